#pragma once

#include <cstddef>
#include <memory>
#include <ostream>
#include <span>
#include <vector>

namespace vestige {

/// Packs point records of format 6 or 7 with LASzip into a stream whose header and records the caller writes.
/// The functions throw ErrorException (ErrorCode::output).
class LazWriter {
  public:
    explicit LazWriter(bool colored);
    ~LazWriter();
    LazWriter(const LazWriter&) = delete;
    LazWriter& operator=(const LazWriter&) = delete;

    /// LASzip's own variable length record, header included.
    std::vector<std::byte> record();
    /// Points come next in the stream, which must live until close().
    void open(std::ostream& stream);
    void add(std::span<const std::byte> record);
    /// Writes the chunk table; nothing may be added any more.
    void close();

  private:
    struct State;
    std::unique_ptr<State> state_;
};

}  // namespace vestige
