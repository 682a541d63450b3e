#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "core/io/ReadJob.h"
#include "core/io/ScalarType.h"
#include "core/io/TextScanner.h"

namespace vestige {

/// Walks through a legacy VTK file: keywords are text in any encoding, arrays text or big endian.
class VtkValues {
  public:
    VtkValues(std::string_view file, const ReadJob& job) : scanner_(file), file_(file), job_(job) {}

    void setBinary(bool binary) { binary_ = binary; }
    bool binary() const { return binary_; }

    std::string_view nextLine() { return scanner_.nextLine(); }
    /// The next word; empty at the end of the file.
    std::string_view word() { return scanner_.nextToken(); }
    /// The next word in capitals, as keywords are compared.
    std::string keyword();
    /// The next word as a count of things of at least `bytesEach` bytes (0: nobody knows); refuses one that
    /// the file cannot hold.
    std::size_t count(std::size_t bytesEach = 1);
    /// A count that stands in `text` already.
    std::size_t countFrom(std::string_view text, std::size_t bytesEach = 1);
    /// The next word as the type of an array.
    ScalarType type();
    static std::optional<ScalarType> typeOfName(std::string_view name);

    /// Before an array: checks that the file can hold it, and goes to its first byte.
    void beginArray(std::size_t values, ScalarType type);
    /// The same for an array of `count` groups of `components` values that may be cut: how many groups the
    /// file has room for.
    std::size_t beginCutArray(std::size_t count, std::size_t components, ScalarType type);
    /// The next value of an array.
    double value(ScalarType type);
    void skipArray(std::size_t values, ScalarType type);
    /// Refuses counts whose product could overflow before beginArray compares it with the file.
    void checkProduct(std::size_t count, std::size_t components) const;
    /// Over the lines of a block METADATA, which an empty line ends.
    void skipMetadata();

    /// For looking ahead: where the walk is, and back to there.
    TextScanner place() const { return scanner_; }
    void returnTo(const TextScanner& place) { scanner_ = place; }

    [[noreturn]] void refuse(const std::string& message, const std::string& expected) const;

  private:
    std::size_t remaining() const { return file_.size() - scanner_.offset(); }

    TextScanner scanner_;
    std::string_view file_;
    const ReadJob& job_;
    bool binary_ = false;
};

}  // namespace vestige
