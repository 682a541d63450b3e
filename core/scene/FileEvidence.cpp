#include "core/scene/FileEvidence.h"

#include "core/base/UtcTime.h"
#include "core/scene/Layer.h"

namespace vestige {
namespace {

std::string described(const FileEvidence& file) {
    return "SHA-256 " + file.sha256 + ", " + std::to_string(file.bytes) + " bytes" +
           (file.modified.empty() ? "" : ", of " + file.modified);
}

}  // namespace

FileEvidence evidenceOf(const LayerData& data) {
    constexpr std::int64_t kNanoseconds = 1000000000;
    return {data.sha256, data.stamp.bytes, utcText(data.stamp.modified_ns / kNanoseconds)};
}

bool noteEvidence(Layer& layer) {
    if (layer.evidence || !layer.data || layer.data->sha256.empty()) return false;
    layer.evidence = evidenceOf(*layer.data);
    return true;
}

std::optional<std::string> evidenceDifference(const Layer& layer) {
    if (!layer.evidence || !layer.data || layer.data->isPreview()) return std::nullopt;
    if (layer.data->sha256 == layer.evidence->sha256) return std::nullopt;
    return "layer '" + layer.id + "': " + layer.path.string() +
           " is not the file that became part of the case: expected " + described(*layer.evidence) +
           "; found " + described(evidenceOf(*layer.data));
}

}  // namespace vestige
