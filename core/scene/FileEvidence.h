#pragma once

#include <cstdint>
#include <optional>
#include <string>

namespace vestige {

struct Layer;
struct LayerData;

/// What the file of a layer was when it became part of the case. The SHA-256 counts; size and time help
/// people to find the right file again.
struct FileEvidence {
    std::string sha256;  ///< 64 lower-case hexadecimal digits
    std::uint64_t bytes = 0;
    std::string modified;  ///< ISO 8601, UTC; may be empty

    friend bool operator==(const FileEvidence&, const FileEvidence&) = default;
};

/// Of a file as it was read.
FileEvidence evidenceOf(const LayerData& data);

/// Notes the file as read where the case has not said yet what it is to be. True when it did.
bool noteEvidence(Layer& layer);

/// A sentence that names layer, file, what was expected and what is there; nothing when the file is the one
/// that the case knows, when it knows none, or when the layer is not loaded.
std::optional<std::string> evidenceDifference(const Layer& layer);

}  // namespace vestige
