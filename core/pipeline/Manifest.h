#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/pipeline/Reconstruct.h"
#include "core/pipeline/ReconstructRun.h"

namespace vestige {

/// manifest.json: SHA-256 of every input and output, versions, parameters, times.
std::string manifestText(const ReconstructRun& run, const std::vector<OutputFile>& outputs);

/// Every file that was written so far, with its SHA-256.
Result<std::vector<OutputFile>> hashedOutputs(OutputFolder& output, const JobControl& control);

/// Names of files in the folder that an earlier run's manifest lists, that are unchanged since, and that this
/// run does not make: pictures of layers or objects that are gone.
std::vector<std::string> obsoleteOutputs(const std::filesystem::path& folder,
                                         const std::vector<OutputFile>& outputs);

/// Component and version of what computes the results.
std::vector<std::pair<std::string, std::string>> softwareVersions(const ViewRenderer* renderer,
                                                                  const DocumentPrinter* printer);

}  // namespace vestige
