#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>

#include "core/io/importer/ImportedScene.h"

namespace vestige {

// What vestige-import writes to its standard output: the mark, then blocks of {kind u32, length u64,
// payload}, little endian, and an `end` block that holds the checksum of all payloads before it.
// Both sides are of one build; nothing of this is ever kept in a file.

inline constexpr std::uint64_t kImporterMark = 0x31504d4947545356;  // "VSTGIMP1"

enum class ImportBlock : std::uint32_t {
    warning = 1,    ///< UTF-8
    refusal = 2,    ///< UTF-8: what is wrong, a line feed, what was expected
    unit = 3,       ///< metres a unit, float64
    vertices = 4,   ///< begins a mesh; 3 float64 each
    normals = 5,    ///< of the mesh begun last; 3 float32 each
    colors = 6,     ///< 3 uint16 each
    triangles = 7,  ///< 3 uint32 each
    instances = 8,  ///< mesh uint32, 12 float64: the rows of [linear | translation]
    end = 9         ///< checksum, uint64
};

/// What a block counts beside its payload: even an empty one makes an object of the receiver's.
inline constexpr std::uint64_t kImportBlockCost = 128;

/// The exit status of an importer that met its limit of memory.
inline constexpr int kImporterOutOfMemory = 12;

/// Takes or gives exactly the span's bytes, or throws.
using ByteOutput = std::function<void(std::span<const std::byte>)>;
using ByteInput = std::function<void(std::span<std::byte>)>;

/// The child's side.
class ImportSender {
  public:
    explicit ImportSender(ByteOutput output);

    void warning(const std::string& sentence);
    void refusal(const std::string& message, const std::string& expected);
    void unit(double metresPerUnit);
    void mesh(const ImportedMesh& mesh);
    void instances(std::span<const ImportedInstance> instances);
    void end();

  private:
    void block(ImportBlock kind, std::span<const std::byte> payload);
    template <class Item>
    void items(ImportBlock kind, const std::vector<Item>& values);

    ByteOutput output_;
    std::uint64_t checksum_;
};

/// The parent's side: memory grows with what really arrives, up to `mostBytes` of payloads and
/// kImportBlockCost for each. Refuses with the child's own
/// sentence, or says that what it sent is no geometry.
ImportedScene receiveScene(const ByteInput& input, std::uint64_t mostBytes, const ReadJob& job);

}  // namespace vestige
