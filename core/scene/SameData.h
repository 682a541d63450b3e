#pragma once

#include "core/scene/Layer.h"

namespace vestige {

/// Whether both load the same points: the same part of the same file, damage treated alike. What was read for
/// one is then what the other asks for.
inline bool readsTheSame(const Layer& a, const Layer& b) {
    const bool sameBox = a.box.has_value() == b.box.has_value() &&
                         (!a.box || (a.box->min == b.box->min && a.box->max == b.box->max));
    return a.path == b.path && a.keepEvery == b.keepEvery && sameBox && a.salvage == b.salvage;
}

}  // namespace vestige
