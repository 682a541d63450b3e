#include "core/io/formats/PcdHeader.h"

#include <optional>

#include "core/base/CleanText.h"
#include "core/base/Numbers.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

constexpr int kMostColumns = 100000;

std::optional<ScalarType> scalarType(char kind, std::int64_t size) {
    using enum ScalarType;
    if (kind == 'F')
        return size == 4 ? std::optional(float32) : size == 8 ? std::optional(float64) : std::nullopt;
    if (kind != 'I' && kind != 'U') return std::nullopt;
    const bool isSigned = kind == 'I';
    switch (size) {
        case 1:
            return isSigned ? int8 : uint8;
        case 2:
            return isSigned ? int16 : uint16;
        case 4:
            return isSigned ? int32 : uint32;
        case 8:
            return isSigned ? int64 : uint64;
        default:
            return std::nullopt;
    }
}

std::vector<std::string_view> tokens(std::string_view line) {
    std::vector<std::string_view> found;
    for (auto token = takeToken(line); !token.empty(); token = takeToken(line)) found.push_back(token);
    return found;
}

class HeaderParser {
  public:
    HeaderParser(std::string_view text, const ReadJob& job) : scanner_(text), job_(job) {}

    PcdHeader parse() {
        for (;;) {
            if (scanner_.atEnd())
                refuse("the header has no end", "a line 'DATA ascii|binary|binary_compressed'");
            line_ = scanner_.line();
            const std::vector<std::string_view> words = tokens(scanner_.nextLine());
            if (words.empty() || words.front().starts_with('#')) continue;
            if (words.front() == "DATA") {
                parseEncoding(words);
                break;
            }
            parseLine(words);
        }
        finish();
        return std::move(header_);
    }

  private:
    [[noreturn]] void refuse(std::string message, std::string expected) const {
        job_.refuseLine(line_, std::move(message), std::move(expected));
    }

    void parseLine(const std::vector<std::string_view>& words) {
        const std::string_view key = words.front();
        if (key == "VERSION") {
            if (words.size() > 1) header_.version = cleanText(words[1].substr(0, 16));
        } else if (key == "FIELDS" || key == "COLUMNS") {
            header_.fieldsLine = line_;
            for (std::size_t i = 1; i < words.size(); ++i) names_.emplace_back(words[i]);
        } else if (key == "SIZE") {
            sizes_ = integers(words);
        } else if (key == "COUNT") {
            counts_ = integers(words);
        } else if (key == "TYPE") {
            for (std::size_t i = 1; i < words.size(); ++i) types_.push_back(words[i].front());
        } else if (key == "WIDTH") {
            width_ = single(words);
        } else if (key == "HEIGHT") {
            height_ = single(words);
        } else if (key == "POINTS") {
            points_ = single(words);
        } else if (key == "VIEWPOINT") {
            parseViewpoint(words);
        } else {
            refuse("this line does not belong into a PCD header",
                   "VERSION, FIELDS, SIZE, TYPE, COUNT, WIDTH, HEIGHT, VIEWPOINT, POINTS or DATA");
        }
    }

    std::vector<std::int64_t> integers(const std::vector<std::string_view>& words) const {
        std::vector<std::int64_t> values;
        for (std::size_t i = 1; i < words.size(); ++i) {
            const auto value = parseInteger(words[i]);
            if (!value || *value < 0) refuse("a value is no whole number", "whole numbers from 0");
            values.push_back(*value);
        }
        return values;
    }

    std::int64_t single(const std::vector<std::string_view>& words) const {
        const std::vector<std::int64_t> values = integers(words);
        if (values.size() != 1)
            refuse("the line has no single value", std::string(words[0]) + " and one number");
        return values[0];
    }

    void parseViewpoint(const std::vector<std::string_view>& words) {
        constexpr std::array kUnmoved{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};
        for (std::size_t i = 0; i < kUnmoved.size() && i + 1 < words.size(); ++i)
            if (parseReal(words[i + 1]).value_or(0) != kUnmoved[i]) header_.movedViewpoint = true;
    }

    void parseEncoding(const std::vector<std::string_view>& words) {
        const std::string_view name = words.size() > 1 ? words[1] : "";
        if (name == "ascii")
            header_.encoding = PcdEncoding::ascii;
        else if (name == "binary")
            header_.encoding = PcdEncoding::binary;
        else if (name == "binary_compressed")
            header_.encoding = PcdEncoding::compressed;
        else
            refuse("the encoding of DATA is unknown", "ascii, binary or binary_compressed");
    }

    void finish() {
        if (names_.empty()) refuse("the header has no line FIELDS before DATA", "FIELDS x y z ...");
        if (counts_.empty()) counts_.assign(names_.size(), 1);
        if (sizes_.size() != names_.size() || types_.size() != names_.size() ||
            counts_.size() != names_.size())
            refuse("FIELDS, SIZE, TYPE and COUNT have different numbers of entries",
                   "one entry for each field");
        for (std::size_t i = 0; i < names_.size(); ++i) addField(i);
        const std::int64_t points = points_             ? *points_
                                    : width_ && height_ ? checkedProduct(*width_, *height_)
                                                        : -1;
        if (points < 0)
            refuse("the header does not say how many points there are", "POINTS, or WIDTH and HEIGHT");
        header_.points = static_cast<std::size_t>(points);
        header_.bodyOffset = scanner_.offset();
        header_.bodyLine = scanner_.line();
    }

    void addField(std::size_t i) {
        const auto type = scalarType(types_[i], sizes_[i]);
        if (!type)
            refuse("the field " + cleanText(names_[i]) + " has a TYPE and SIZE that do not exist together",
                   "I or U of 1, 2, 4, 8 bytes, F of 4, 8");
        if (counts_[i] > kMostColumns || header_.columns > kMostColumns)
            refuse("the points have more values than any file needs",
                   std::to_string(kMostColumns) + " at most");
        PcdField field{names_[i], *type, static_cast<std::size_t>(counts_[i]), header_.stride,
                       header_.columns};
        header_.stride += field.bytes();
        header_.columns += field.count;
        header_.fields.push_back(std::move(field));
    }

    std::int64_t checkedProduct(std::int64_t a, std::int64_t b) const {
        std::int64_t product = 0;
        if (__builtin_mul_overflow(a, b, &product))
            refuse("WIDTH times HEIGHT is too large", "the number of points");
        return product;
    }

    TextScanner scanner_;
    const ReadJob& job_;
    std::size_t line_ = 1;
    PcdHeader header_;
    std::vector<std::string> names_;
    std::vector<std::int64_t> sizes_, counts_;
    std::vector<char> types_;
    std::optional<std::int64_t> width_, height_, points_;
};

}  // namespace

PcdHeader parsePcdHeader(std::string_view text, const ReadJob& job) {
    return HeaderParser(text, job).parse();
}

}  // namespace vestige
