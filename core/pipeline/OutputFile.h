#pragma once

#include <string>

namespace vestige {

/// A file of the results.
struct OutputFile {
    std::string path;  ///< relative to the output folder, with '/'
    std::string sha256;
};

}  // namespace vestige
