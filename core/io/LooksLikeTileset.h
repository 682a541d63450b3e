#pragma once

#include <filesystem>
#include <string_view>

namespace vestige {

/// Whether a JSON text, whole or its beginning, is a 3D Tiles tileset by the keys of its outermost object:
/// "asset", and "root" or "geometricError", and no "vestige", which marks a case. Only a whole text is sure
/// to show them.
bool looksLikeTilesetText(std::string_view text);

/// The same of a file, its outermost keys all seen; false for what cannot be read or is no JSON object.
bool looksLikeTileset(const std::filesystem::path& file);

}  // namespace vestige
