#pragma once

#include "core/io/formats/E57Document.h"
#include "core/io/formats/E57Xml.h"

namespace vestige {

/// One child of data3D; `number` from 1, for sentences.
E57Scan parseE57Scan(const pugi::xml_node& node, std::size_t number, const E57Xml& xml);

}  // namespace vestige
