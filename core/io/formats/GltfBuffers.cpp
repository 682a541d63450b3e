#include "core/io/formats/GltfBuffers.h"

#include <utility>

#include "core/io/Bytes.h"
#include "core/io/formats/Base64.h"
#include "core/io/formats/FolderUri.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

constexpr std::uint32_t kMagic = 0x46546c67, kJsonChunk = 0x4e4f534a, kBinaryChunk = 0x004e4942;

/// The file that a relative address names, unless that leaves the folder of the document.
fs::path fileBeside(const std::string& address, const ReadJob& job) {
    const std::string name = percentDecoded(address);
    const fs::path relative(name);
    bool climbs = false;
    for (const fs::path& part : relative) climbs = climbs || part == "..";
    if (name.empty() || relative.is_absolute() || climbs || name.find(':') != std::string::npos ||
        name.find('\\') != std::string::npos || name.find('\0') != std::string::npos)
        job.refuse("the document names the buffer '" + name.substr(0, 200) + "'",
                   "a file in the document's own folder");
    std::error_code problem;
    const fs::path folder = fs::canonical(fs::absolute(job.path()).parent_path(), problem);
    const fs::path found = problem ? fs::path() : fs::canonical(folder / relative, problem);
    if (problem || !fs::is_regular_file(found, problem))
        job.refuse("the buffer '" + name + "' of the document is missing", "a file beside the document");
    if (!isInside(found, folder))
        job.refuse("the buffer '" + name + "' is a link that leads out of the document's folder",
                   "a file in the document's own folder");
    return found;
}

GltfBuffer decoded(std::string_view address, const ReadJob& job) {
    const std::size_t comma = address.find(',');
    if (comma == std::string_view::npos || !address.substr(0, comma).ends_with(";base64"))
        job.refuse("a buffer inside the document is not in base64", "data:...;base64,...");
    GltfBuffer buffer;
    buffer.decoded = bytesOfBase64(address.substr(comma + 1));
    if (!buffer.decoded) job.refuse("a buffer inside the document is not in base64", "data:...;base64,...");
    buffer.length = buffer.decoded->size();
    return buffer;
}

}  // namespace

GltfContainer splitGltf(std::span<const std::byte> file, const ReadJob& job) {
    GltfContainer container;
    const std::string_view whole(reinterpret_cast<const char*>(file.data()), file.size());
    if (!whole.starts_with("glTF")) {
        container.json = whole;
        if (whole.starts_with("\xef\xbb\xbf")) container.json.remove_prefix(3);
        container.jsonByte = whole.size() - container.json.size();
        return container;
    }
    container.isBinary = true;
    constexpr std::size_t kHeader = 12, kChunk = 8;
    if (file.size() < kHeader + kChunk || load<std::uint32_t>(file.data()) != kMagic)
        job.refuseByte(file.size(), "the file ends inside its header", "12 bytes and a JSON chunk");
    if (load<std::uint32_t>(file.data() + 4) != 2)
        job.refuseByte(4, "this is glTF of another version than 2", "version 2");
    const std::size_t length = load<std::uint32_t>(file.data() + 8);
    if (length > file.size() || length < kHeader + kChunk)
        job.refuseByte(8, "the file should have " + std::to_string(length) + " bytes",
                       "as many as it has, " + std::to_string(file.size()));
    for (std::size_t at = kHeader, number = 0; at + kChunk <= length; ++number) {
        const std::size_t size = load<std::uint32_t>(file.data() + at);
        const auto kind = load<std::uint32_t>(file.data() + at + 4);
        at += kChunk;
        if (size > length - at)
            job.refuseByte(at - kChunk, "a chunk promises more bytes than the file has",
                           "at most " + std::to_string(length - at));
        if ((number == 0) != (kind == kJsonChunk))
            job.refuseByte(at - 4, "the first chunk, and no other, must be JSON", "a chunk JSON, then BIN");
        if (number == 0) {
            container.json = whole.substr(at, size);
            container.jsonByte = at;
        } else if (number == 1 && kind == kBinaryChunk) {
            container.binaryByte = at;
            container.binaryLength = size;
        }
        at += size;
    }
    return container;
}

std::vector<GltfBuffer> findGltfBuffers(const GltfJson& document, const GltfContainer& container,
                                        const std::vector<std::uint64_t>& used) {
    const ReadJob& job = document.job();
    std::vector<GltfBuffer> buffers;
    for (const std::uint64_t index : used) {
        const nlohmann::json& entry = document.item("buffers", index, "a buffer view");
        const std::string address = document.text(entry, "uri");
        GltfBuffer buffer;
        if (address.starts_with("data:")) {
            buffer = decoded(address, job);
        } else if (address.empty() && index == 0 && container.isBinary) {
            buffer.file = job.path();
            buffer.offset = container.binaryByte;
            buffer.length = container.binaryLength;
        } else {
            buffer.file = fileBeside(address, job);
            buffer.length = fs::file_size(buffer.file);
        }
        const std::uint64_t promised = document.number(entry, "byteLength");
        if (buffer.length < promised)
            job.refuse("buffer " + std::to_string(index) + " has " + std::to_string(buffer.length) + " bytes",
                       "the " + std::to_string(promised) + " that the document promises");
        buffer.length = promised;
        buffers.push_back(std::move(buffer));
    }
    return buffers;
}

}  // namespace vestige
