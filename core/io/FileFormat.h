#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/geometry/TriangleMesh.h"
#include "core/io/FileInfo.h"
#include "core/io/ReadOptions.h"

namespace vestige {

/// What a reader returns: points (and triangles) in the file's own unit, and what the file says about itself.
struct LoadedGeometry {
    TriangleMesh geometry;
    FileInfo info;        ///< `attributes` are those of the file, whichever of them were read
    bool heeded = false;  ///< the reader itself left out what the ReadOptions leave out
};

struct WriteOptions {
    /// From the source of the data: CRS, scale and offset, GPS time kind are carried on where the format has
    /// them.
    const FileInfo* source = nullptr;
};

/// One file format: recognises, describes, reads and, where it can, writes. Stateless; any thread may call
/// it.
class FileFormat {
  public:
    virtual ~FileFormat() = default;
    virtual std::string_view id() const = 0;                  ///< "las"
    virtual std::string_view title() const = 0;               ///< "LAS point cloud", for open dialogs
    virtual std::vector<std::string> extensions() const = 0;  ///< lower case, without dot
    /// False for formats that are only recognised, to say what to do instead; open dialogs leave them out.
    virtual bool canRead() const { return true; }
    virtual bool canWrite() const { return false; }
    /// True when read() leaves out what the options leave out while it reads, so that a part takes no more
    /// memory than it has.
    virtual bool readsParts() const { return false; }
    /// True when read() with ReadOptions::salvage may give part of a file that it else refuses, without
    /// saying so in the refusal.
    virtual bool salvagesUnasked() const { return false; }
    /// True when the format fixes its coordinates to metres.
    virtual bool writesMetres() const { return false; }
    /// True when the first bytes (up to 4096) are of this format; text formats may go by the extension.
    virtual bool recognises(std::span<const std::byte> head, std::string_view extension) const = 0;

    /// What the file says about itself, checked against its points; by default what read() finds.
    virtual Result<FileInfo> info(const std::filesystem::path& file, const JobControl& control) const;
    /// What can be told without reading the points, for open dialogs and memory estimates: at once for
    /// formats whose header says it. By default only path, format and nothing else (points 0).
    virtual Result<FileInfo> peek(const std::filesystem::path& file, const JobControl& control) const;
    /// About `points` of the file's points, spread over it and exact, in a fraction of the time that read()
    /// takes: the first picture. Nothing where the format offers no such short cut.
    virtual Result<std::optional<LoadedGeometry>> preview(const std::filesystem::path& file,
                                                          std::size_t points,
                                                          const JobControl& control) const;
    virtual Result<LoadedGeometry> read(const std::filesystem::path& file, const ReadOptions& options,
                                        const JobControl& control) const = 0;
    /// Atomic: beside, then rename. ErrorCode::output on failure.
    virtual Status write(const std::filesystem::path& file, const TriangleMesh& geometry,
                         const WriteOptions& options, const JobControl& control) const;
};

}  // namespace vestige
