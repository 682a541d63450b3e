#pragma once

#include <chrono>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Descriptor.h"
#include "core/base/JobControl.h"
#include "core/io/importer/ImportedScene.h"

namespace vestige {

/// Opens a regular file for reading; throws ErrorException (ErrorCode::input).
Descriptor openForReading(const std::filesystem::path& file);
/// A file without a name, in memory, that holds `content` and is read from its beginning.
Descriptor fileInMemory(std::string_view content);

/// What a separate reader is given and what it may use.
struct ImportRequest {
    std::string format;                                  ///< "gltf", "3mf": the program's first argument
    std::string request;                                 ///< what it finds on its standard input
    std::vector<Descriptor> files;                       ///< what it finds as descriptors 3, 4, ...
    std::uint64_t memoryBytes = std::uint64_t{1} << 30;  ///< of its address space, libraries included
    std::uint64_t resultBytes = std::uint64_t{1} << 30;  ///< of receiveScene()
    std::chrono::seconds time{30};                       ///< of the processor; of the wall three times that
};

/// Address space for a reader that holds a file of this size several times over: 1 GiB, and beyond that what
/// it takes, but not more than the machine has free.
std::uint64_t importMemoryFor(std::uint64_t fileBytes);

/// Time of the processor for a reader of this many bytes: 10 s, and one for each million.
std::chrono::seconds importTimeFor(std::uint64_t fileBytes);

/// The program vestige-import: beside this program, in ../libexec/vestige, or where the environment's
/// VESTIGE_IMPORT says. Empty where there is none.
std::filesystem::path importerProgram();

/// Runs the foreign library that reads the format in a process of its own, which can crash, hang or be killed
/// without harm to this one. It sees only the descriptors given to it. A cancel kills it at once. Refuses
/// (ErrorException, see ReadJob) with a sentence when it refuses, dies, takes too long or sends no geometry.
ImportedScene importScene(ImportRequest request, const ReadJob& job, const JobControl& control);

}  // namespace vestige
