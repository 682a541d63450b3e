#pragma once

#include <string>
#include <vector>

#include "core/io/formats/E57Section.h"

namespace vestige {

/// The XML section of a file to write. `seed` is what the GUIDs are made of that no source names; the text's
/// length does not depend on it.
std::string e57Xml(const std::vector<E57Part>& parts, const std::vector<E57Section>& sections,
                   const FileInfo* source, const std::string& seed);

/// Whether a reference system is in the words that E57 wants: WKT.
bool isWkt(const std::string& crs);

}  // namespace vestige
