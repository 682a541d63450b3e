#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "core/io/formats/GltfJson.h"

namespace vestige {

/// What an accessor holds: `count` items of `type` ("VEC3") in `componentType` (5126: float32).
struct GltfAccessor {
    std::uint64_t number = 0;  ///< among the accessors of the checked document
    std::string type;
    std::uint64_t componentType = 0;
    bool normalized = false;
    std::uint64_t count = 0;
    std::uint64_t bytes = 0;  ///< of all items, packed
};

/// Takes over into a new document those accessors, views and buffers that geometry needs, each checked
/// (glTF 2.0 section 3.6): every item inside its view, every view inside its buffer.
class GltfAccessors {
  public:
    explicit GltfAccessors(const GltfJson& source);
    ~GltfAccessors();

    /// `why` says who needs it, for the sentence of a refusal.
    GltfAccessor take(std::uint64_t index, const std::string& why);
    /// Of the source's buffers, those in use, in the order of the new document's.
    const std::vector<std::uint64_t>& buffers() const { return buffers_; }
    /// Puts "accessors", "bufferViews" and "buffers" (named "0", "1", ...) into the new document.
    void putInto(nlohmann::json& document) &&;

  private:
    std::uint64_t takeView(std::uint64_t index, std::uint64_t offset, std::uint64_t itemBytes,
                           std::uint64_t count, const std::string& why);
    void takeSparse(const nlohmann::json& from, nlohmann::json& to, const GltfAccessor& accessor,
                    const std::string& why);

    const GltfJson& source_;
    std::map<std::uint64_t, GltfAccessor> taken_;
    std::map<std::uint64_t, std::uint64_t> views_, bufferNumbers_;
    std::vector<std::uint64_t> buffers_;
    std::vector<nlohmann::json> newAccessors_, newViews_;
};

}  // namespace vestige
