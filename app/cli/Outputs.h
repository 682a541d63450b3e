#pragma once

#include <initializer_list>
#include <string>

#include "app/cli/Session.h"
#include "core/io/FileInfo.h"

namespace vestige::cli {

/// ErrorCode::usage where an output is one of the inputs, by whatever name: files are only ever read. Empty
/// names are none.
Status noInputIsWritten(std::initializer_list<std::string> outputs,
                        std::initializer_list<std::string> inputs);

/// "1 2.5 3"
std::string coordinates(const Eigen::Vector3d& values);

/// After `out` was written of `wanted` (with the scale, offset and unit that it was to have): warns of what
/// its format does not hold. What was not asked for is not missed.
struct Wanted {
    bool scale = false;
    bool offset = false;
    std::size_t triangles = 0;
};
void tellWhatIsLost(const std::string& out, const FileInfo& wanted, const Wanted& asked,
                    const Session& session);

}  // namespace vestige::cli
