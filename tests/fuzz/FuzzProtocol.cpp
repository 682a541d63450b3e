// What a process that reads a foreign format may send: the input is its blocks, between the mark and a block
// `end` whose checksum is right.
#include <cstring>

#include "core/io/Bytes.h"
#include "core/io/importer/ImportedScene.h"
#include "core/io/importer/ImporterProtocol.h"
#include "tests/fuzz/FuzzFile.h"
#include "tests/fuzz/MemoryBound.h"

using namespace vestige;

namespace {

constexpr std::size_t kBlockHeader = 12;
constexpr std::uint64_t kMostVertices = 10000;
constexpr std::size_t kFixed = std::size_t{8} << 20;
constexpr std::size_t kPerByte = 200;

/// FNV-1a over words of eight bytes, of the payloads of all whole blocks.
std::uint64_t checksumOf(std::span<const std::byte> blocks) {
    std::uint64_t sum = 0xcbf29ce484222325;
    while (blocks.size() >= kBlockHeader) {
        const auto length = load<std::uint64_t>(blocks.data() + 4);
        blocks = blocks.subspan(kBlockHeader);
        if (length > blocks.size()) break;
        for (std::size_t at = 0; at < length; at += 8) {
            std::uint64_t word = 0;
            std::memcpy(&word, blocks.data() + at, std::min<std::size_t>(8, length - at));
            sum = (sum ^ word) * 0x100000001b3;
        }
        blocks = blocks.subspan(length);
    }
    return sum;
}

}  // namespace

extern "C" int LLVMFuzzerInitialize(int*, char***) {
    fuzz::MemoryBound::install();
    return 0;
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::span blocks(reinterpret_cast<const std::byte*>(data), size);
    const fuzz::MemoryBound bound(size, kFixed, kPerByte);
    std::vector<std::byte> sent(8 + size + kBlockHeader + 8);
    store(sent.data(), kImporterMark);
    std::copy(blocks.begin(), blocks.end(), sent.begin() + 8);
    std::byte* end = sent.data() + 8 + size;
    store(end, static_cast<std::uint32_t>(ImportBlock::end));
    store(end + 4, std::uint64_t{8});
    store(end + kBlockHeader, checksumOf(blocks));

    const std::filesystem::path file = "input.3mf";
    std::size_t at = 0;
    ReadJob job(file, {});
    const ByteInput input = [&](std::span<std::byte> bytes) {
        if (bytes.size() > sent.size() - at) job.refuse("the pipe ended", "more");
        if (!bytes.empty()) std::memcpy(bytes.data(), sent.data() + at, bytes.size());
        at += bytes.size();
    };
    const Result<TriangleMesh> read = guarded(file.string(), [&]() -> Result<TriangleMesh> {
        return assembleScene(receiveScene(input, 65536 + 8 * size, job), kMostVertices, job);
    });
    if (!read) fuzz::checkError(read.error(), file);
    if (read && read->vertices.size() > kMostVertices) fuzz::finding("more vertices than are allowed");
    return 0;
}
