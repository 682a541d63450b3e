#pragma once

#include "app/cli/Session.h"
#include "core/io/FileFormat.h"

namespace vestige::cli {

/// The unit of what was read from `in`, and who says so.
struct ReadUnit {
    double metresPerUnit = 1;
    bool given = false;  ///< on the command line, else by the file
};

/// Makes metres of points that a format is to hold which fixes them, and says so; leaves them as they are for
/// any other format.
void putIntoUnitOf(const FileFormat& target, const std::string& out, const std::string& in,
                   const ReadUnit& unit, LoadedGeometry& loaded, const Session& session);

}  // namespace vestige::cli
