#include "core/io/importer/ImporterProtocol.h"

#include <algorithm>
#include <bit>
#include <cstring>
#include <utility>

#include "core/io/Bytes.h"

namespace vestige {
namespace {

static_assert(std::endian::native == std::endian::little, "the arrays travel as they lie in memory");
static_assert(sizeof(Eigen::Vector3d) == 24 && sizeof(Eigen::Vector3f) == 12 && sizeof(Color) == 6 &&
              sizeof(Triangle) == 12);

constexpr std::uint64_t kChecksumBegin = 0xcbf29ce484222325;
constexpr std::size_t kHeader = 12;
constexpr std::size_t kInstance = 4 + 12 * 8;

/// FNV-1a (Fowler, Noll, Vo) over words of eight bytes, the last one filled with zeros.
std::uint64_t checksum(std::uint64_t sum, std::span<const std::byte> bytes) {
    for (std::size_t at = 0; at < bytes.size(); at += 8) {
        std::uint64_t word = 0;
        std::memcpy(&word, bytes.data() + at, std::min<std::size_t>(8, bytes.size() - at));
        sum = (sum ^ word) * 0x100000001b3;
    }
    return sum;
}

class Receiver {
  public:
    Receiver(const ByteInput& input, std::uint64_t mostBytes, const ReadJob& job)
        : input_(input), left_(mostBytes), job_(job) {}

    ImportedScene receive() {
        std::byte mark[8];
        input_(mark);
        if (load<std::uint64_t>(mark) != kImporterMark) garbage("it does not begin with its mark");
        while (receiveBlock()) {
        }
        return std::move(scene_);
    }

  private:
    [[noreturn]] void garbage(const std::string& why) const {
        job_.refuse("the separate reader of this format sent no geometry: " + why,
                    "a whole and valid file of this format");
    }

    bool receiveBlock() {
        std::byte header[kHeader];
        input_(header);
        const auto kind = static_cast<ImportBlock>(load<std::uint32_t>(header));
        const auto length = load<std::uint64_t>(header + 4);
        if (length > left_ || left_ - length < kImportBlockCost) garbage("more than the file can hold");
        left_ -= length + kImportBlockCost;
        switch (kind) {
            case ImportBlock::warning:
                scene_.warnings.push_back(text(length));
                return true;
            case ImportBlock::refusal:
                refuse(text(length));
            case ImportBlock::unit:
                scene_.metresPerUnit = number<double>(length);
                return true;
            case ImportBlock::vertices:
                scene_.meshes.emplace_back();
                items(scene_.meshes.back().vertices, length);
                return true;
            case ImportBlock::normals:
                ofVertices(current().normals, length);
                return true;
            case ImportBlock::colors:
                ofVertices(current().colors, length);
                return true;
            case ImportBlock::triangles:
                items(current().triangles, length);
                return true;
            case ImportBlock::instances:
                instances(length);
                return true;
            case ImportBlock::end: {
                const std::uint64_t sum = sum_;
                if (number<std::uint64_t>(length) != sum) garbage("its checksum is wrong");
                return false;
            }
        }
        garbage("a block of an unknown kind");
    }

    [[noreturn]] void refuse(const std::string& sentence) const {
        const std::size_t cut = sentence.find('\n');
        if (sentence.empty() || cut == 0) garbage("it refused the file without saying why");
        job_.refuse(sentence.substr(0, cut), cut == std::string::npos ? "" : sentence.substr(cut + 1));
    }

    ImportedMesh& current() {
        if (scene_.meshes.empty()) garbage("a mesh without vertices");
        return scene_.meshes.back();
    }

    /// In pieces, so that a promised length alone costs no memory.
    template <class Item>
    void items(std::vector<Item>& values, std::uint64_t length) {
        constexpr std::size_t kPiece = std::size_t{1} << 16;
        if (length % sizeof(Item) != 0) garbage("a block of a wrong length");
        values.clear();
        for (std::uint64_t left = length / sizeof(Item); left > 0;) {
            const auto piece = static_cast<std::size_t>(std::min<std::uint64_t>(left, kPiece));
            const std::size_t at = values.size();
            values.resize(at + piece);
            const auto bytes = std::as_writable_bytes(std::span(values).subspan(at));
            input_(bytes);
            sum_ = checksum(sum_, bytes);
            left -= piece;
        }
    }

    template <class Item>
    void ofVertices(std::vector<Item>& values, std::uint64_t length) {
        items(values, length);
        if (values.size() != current().vertices.size()) garbage("attributes of a wrong length");
    }

    std::string text(std::uint64_t length) {
        std::vector<char> letters;
        items(letters, length);
        return {letters.begin(), letters.end()};
    }

    template <class Number>
    Number number(std::uint64_t length) {
        std::vector<Number> values;
        items(values, length);
        if (values.size() != 1) garbage("a block of a wrong length");
        return values[0];
    }

    void instances(std::uint64_t length) {
        std::vector<std::array<std::byte, kInstance>> records;
        items(records, length);
        for (const auto& record : records) {
            ImportedInstance instance;
            instance.mesh = load<std::uint32_t>(record.data());
            for (int i = 0; i < 12; ++i)
                instance.fileFromMesh.matrix()(i / 4, i % 4) = load<double>(record.data() + 4 + 8 * i);
            scene_.instances.push_back(instance);
        }
    }

    const ByteInput& input_;
    std::uint64_t left_;
    const ReadJob& job_;
    ImportedScene scene_;
    std::uint64_t sum_ = kChecksumBegin;
};

}  // namespace

ImportSender::ImportSender(ByteOutput output) : output_(std::move(output)), checksum_(kChecksumBegin) {
    std::byte mark[8];
    store(mark, kImporterMark);
    output_(mark);
}

void ImportSender::block(ImportBlock kind, std::span<const std::byte> payload) {
    std::byte header[kHeader];
    store(header, static_cast<std::uint32_t>(kind));
    store(header + 4, std::uint64_t{payload.size()});
    output_(header);
    output_(payload);
}

template <class Item>
void ImportSender::items(ImportBlock kind, const std::vector<Item>& values) {
    // The receiver sums each of its pieces on its own, which are whole words except for the last one.
    const auto bytes = std::as_bytes(std::span(values));
    checksum_ = checksum(checksum_, bytes);
    block(kind, bytes);
}

void ImportSender::warning(const std::string& sentence) {
    items(ImportBlock::warning, std::vector<char>(sentence.begin(), sentence.end()));
}

void ImportSender::refusal(const std::string& message, const std::string& expected) {
    std::string text = message;
    // What is quoted of the file must not end the message; the receiver cleans the rest.
    std::replace(text.begin(), text.end(), '\n', '?');
    text += "\n" + expected;
    items(ImportBlock::refusal, std::vector<char>(text.begin(), text.end()));
}

void ImportSender::unit(double metresPerUnit) {
    items(ImportBlock::unit, std::vector<double>{metresPerUnit});
}

void ImportSender::mesh(const ImportedMesh& mesh) {
    items(ImportBlock::vertices, mesh.vertices);
    if (!mesh.normals.empty()) items(ImportBlock::normals, mesh.normals);
    if (!mesh.colors.empty()) items(ImportBlock::colors, mesh.colors);
    if (!mesh.triangles.empty()) items(ImportBlock::triangles, mesh.triangles);
}

void ImportSender::instances(std::span<const ImportedInstance> instances) {
    std::vector<std::array<std::byte, kInstance>> records(instances.size());
    for (std::size_t k = 0; k < records.size(); ++k) {
        store(records[k].data(), instances[k].mesh);
        for (int i = 0; i < 12; ++i)
            store(records[k].data() + 4 + 8 * i, instances[k].fileFromMesh.matrix()(i / 4, i % 4));
    }
    items(ImportBlock::instances, records);
}

void ImportSender::end() {
    std::byte sum[8];
    store(sum, checksum_);
    block(ImportBlock::end, sum);
}

ImportedScene receiveScene(const ByteInput& input, std::uint64_t mostBytes, const ReadJob& job) {
    return Receiver(input, mostBytes, job).receive();
}

}  // namespace vestige
