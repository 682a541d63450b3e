#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/io/FileInfo.h"

namespace vestige::cli {

class Session;

/// What a file says about itself, as the JSON of `info`; what it does not say is null or an empty list.
nlohmann::json infoJson(const FileInfo& info);
/// The same for people.
void printInfo(const Session& session, const FileInfo& info);

}  // namespace vestige::cli
