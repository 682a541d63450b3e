// What vestige-import itself makes of a 3MF archive, in this process: its parts, their XML, the scene that it
// sends and the geometry that comes of it. Without lib3mf, which is why that is a process of its own. The
// input is an archive; else a model part, and behind a zero byte a second one, packed into an archive here.
#include <cstring>
#include <optional>

#include "app/importer/ThreeMfCheck.h"
#include "app/importer/ThreeMfModel.h"
#include "core/base/CleanText.h"
#include "core/io/CleanTexts.h"
#include "core/io/importer/ImportedScene.h"
#include "tests/core/io/ZipText.h"
#include "tests/fuzz/FuzzFile.h"

using namespace vestige;

namespace {

// Where the child has a limit of memory of its own, this target has libFuzzer's.
constexpr std::uint64_t kMostVertices = 100000;
constexpr std::uint64_t kMostSent = std::uint64_t{256} << 20;

std::string archiveOf(const std::string& input) {
    if (input.starts_with("PK")) return input;
    const std::size_t cut = input.find('\0');
    std::vector<test::ZipItem> parts = test::threeMfParts(input.substr(0, cut));
    if (cut != std::string::npos) parts.push_back({"3D/b.model", input.substr(cut + 1)});
    return test::zipOf(parts);
}

struct Sent {
    std::string bytes;
    std::optional<std::string> refusal;
};

Sent whatTheChildSends(const std::string& archive) {
    Sent sent;
    ImportSender sender([&](std::span<const std::byte> bytes) {
        sent.bytes.append(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    });
    try {
        importer::sendThreeMf(std::as_bytes(std::span(archive)), sender);
        sender.end();
    } catch (const ErrorException& thrown) {
        sender.refusal(thrown.error.message, thrown.error.hint);
        sent.refusal = thrown.error.message;
    }
    return sent;
}

}  // namespace

importer::ThreeMfVerdict vestige::importer::checkThreeMf(std::span<const std::byte>) {
    return {false, 0, 0, {}};
}

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const Sent child = whatTheChildSends(archiveOf(std::string(reinterpret_cast<const char*>(data), size)));
    const std::string& sent = child.bytes;
    const std::filesystem::path file = "input.3mf";
    std::size_t at = 0;
    ReadJob job(file, {});
    const ByteInput input = [&](std::span<std::byte> bytes) {
        if (bytes.size() > sent.size() - at) fuzz::finding("the sender promised more than it sent");
        if (!bytes.empty()) std::memcpy(bytes.data(), sent.data() + at, bytes.size());
        at += bytes.size();
    };
    const Result<TriangleMesh> read = guarded(file.string(), [&]() -> Result<TriangleMesh> {
        return assembleScene(receiveScene(input, kMostSent, job), kMostVertices, job);
    });
    if (!read) {
        fuzz::checkError(read.error(), file);
        // A refusal may quote any words of the file, these too.
        const bool received =
            child.refusal
                ? read.error().message == cleanText(*child.refusal, kLongestSentence)
                : !read.error().message.starts_with("the separate reader of this format sent no geometry");
        if (!received) fuzz::finding("what is sent cannot be received: " + read.error().sentence());
    }
    if (read && child.refusal) fuzz::finding("a refusal was received as geometry: " + *child.refusal);
    for (const std::string& warning : job.warnings()) fuzz::checkSentence(warning);
    return 0;
}
