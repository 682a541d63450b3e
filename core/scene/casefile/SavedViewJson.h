#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/scene/SavedView.h"
#include "core/scene/casefile/JsonCursor.h"

namespace vestige {

/// One of `saved_views`; ErrorException names file and path of what is wrong.
nlohmann::ordered_json savedViewJson(const SavedView& view);
SavedView readSavedView(const JsonCursor& view);

nlohmann::ordered_json sectionJson(const SectionBox& section);
/// Sides above 0 and at most 1e7 m.
SectionBox readSection(const JsonCursor& section);

}  // namespace vestige
