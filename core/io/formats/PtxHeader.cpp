#include "core/io/formats/PtxHeader.h"

#include <array>
#include <cmath>
#include <vector>

#include "core/io/formats/TextLayout.h"

namespace vestige {
namespace {

/// "0 0 0" and the end of its line: nothing shorter is a point.
constexpr std::uint64_t kShortestRow = 6;
/// Keeps columns times rows inside 64 bits.
constexpr double kMostOfOne = 4294967295.0;

/// The numbers of one line, exactly as many as asked for; nothing otherwise.
bool takeNumbers(std::string_view line, std::size_t count, std::vector<double>& numbers) {
    numbers.assign(count, 0);
    std::size_t bad = 0;
    if (splitNumbers(line, ' ', numbers, bad) != count || bad != 0) return false;
    for (const double number : numbers)
        if (!std::isfinite(number)) return false;
    return true;
}

bool isCount(double number) {
    return number >= 0 && number <= kMostOfOne && number == std::floor(number);
}

class HeaderReader {
  public:
    HeaderReader(TextScanner& scanner, const ReadJob& job) : scanner_(scanner), job_(job) {}

    std::uint64_t count(const std::string& what) {
        const double number = numbers(1, "the number of " + what)[0];
        if (!isCount(number))
            job_.refuseLine(line_, "this is no number of " + what, "a whole number from 0 to 4294967295");
        return static_cast<std::uint64_t>(number);
    }

    const std::vector<double>& numbers(std::size_t count, const std::string& what) {
        line_ = scanner_.line();
        if (scanner_.atEnd()) job_.refuseLine(line_, "the file ends inside a scan's header", what);
        if (!takeNumbers(scanner_.nextLine(), count, numbers_))
            job_.refuseLine(line_, "the header of a scan is broken here",
                            what + ": " + counted(count, "finite number"));
        return numbers_;
    }

    Eigen::Vector3d vector(const std::string& what) {
        const std::vector<double>& read = numbers(3, what);
        return {read[0], read[1], read[2]};
    }

    std::size_t line() const { return line_; }

  private:
    TextScanner& scanner_;
    const ReadJob& job_;
    std::vector<double> numbers_;
    std::size_t line_ = 1;
};

void skipBlankLines(TextScanner& scanner) {
    for (;;) {
        TextScanner ahead = scanner;
        if (ahead.atEnd() || !trimmed(ahead.nextLine()).empty()) return;
        scanner = ahead;
    }
}

}  // namespace

PtxHeader readPtxHeader(TextScanner& scanner, std::size_t textSize, bool salvage, const ReadJob& job) {
    skipBlankLines(scanner);
    const std::size_t firstLine = scanner.line();
    HeaderReader reader(scanner, job);
    PtxHeader header;
    header.columns = reader.count("columns");
    header.rows = reader.count("rows");
    header.scanner = reader.vector("the scanner's place");
    for (const char* axis : {"x", "y", "z"}) reader.vector(std::string("the scanner's ") + axis + " axis");
    for (int row = 0; row < 4; ++row) {
        const std::vector<double>& read = reader.numbers(4, "a row of the transform");
        const Eigen::Vector3d part(read[0], read[1], read[2]);
        if (row < 3)
            header.linear.col(row) = part;
        else
            header.shift = part;
        if (read[3] != (row < 3 ? 0 : 1))
            job.refuseLine(reader.line(), "the transform is not affine",
                           "0 0 0 1 as its last column, the shift in its last row");
    }
    const std::uint64_t room = (textSize - scanner.offset() + 1) / kShortestRow;
    if (!salvage && header.points() > room)
        job.refuseLine(firstLine,
                       "a scan of " + std::to_string(header.columns) + " columns and " +
                           std::to_string(header.rows) + " rows is promised, but the file has room for " +
                           counted(room, "point"),
                       "a file that is whole");
    return header;
}

bool looksLikePtx(std::string_view head) {
    constexpr std::array<std::size_t, 10> kNumbers{1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
    TextScanner scanner(head);
    std::vector<double> numbers;
    for (const std::size_t count : kNumbers) {
        if (scanner.atEnd() || !takeNumbers(scanner.nextLine(), count, numbers)) return false;
        if (count == 1 && !isCount(numbers[0])) return false;
    }
    return true;
}

}  // namespace vestige
