#pragma once

#include <span>
#include <string_view>

#include "core/base/Language.h"

namespace vestige {

/// One text of core and how it is said in another language. Both may hold places %1 ... %9, which the
/// translation may put into another order.
struct CatalogueEntry {
    std::string_view english;
    std::string_view translated;
    bool vocabulary = false;  ///< a word that nobody would give to a thing as its name: a unit, a bearing
};

/// Ascending by the bytes of `english`; made at build time from resources/translations. Nothing for English.
std::span<const CatalogueEntry> catalogue(Language language);

}  // namespace vestige
