#include "core/io/formats/PlyHeader.h"

#include <array>

#include "core/base/CleanText.h"
#include "core/base/Numbers.h"
#include "core/io/TextScanner.h"

namespace vestige {
namespace {

struct TypeName {
    std::string_view name;
    ScalarType type;
};
constexpr std::array kTypes{
    TypeName{"char", ScalarType::int8},      TypeName{"int8", ScalarType::int8},
    TypeName{"uchar", ScalarType::uint8},    TypeName{"uint8", ScalarType::uint8},
    TypeName{"short", ScalarType::int16},    TypeName{"int16", ScalarType::int16},
    TypeName{"ushort", ScalarType::uint16},  TypeName{"uint16", ScalarType::uint16},
    TypeName{"int", ScalarType::int32},      TypeName{"int32", ScalarType::int32},
    TypeName{"uint", ScalarType::uint32},    TypeName{"uint32", ScalarType::uint32},
    TypeName{"int64", ScalarType::int64},    TypeName{"uint64", ScalarType::uint64},
    TypeName{"float", ScalarType::float32},  TypeName{"float32", ScalarType::float32},
    TypeName{"double", ScalarType::float64}, TypeName{"float64", ScalarType::float64}};

class HeaderParser {
  public:
    HeaderParser(std::string_view text, const ReadJob& job) : scanner_(text), job_(job) {}

    PlyHeader parse() {
        if (trimmed(nextLine()) != "ply")
            refuse("the file does not begin with 'ply'", "the first line of a PLY file");
        bool formatKnown = false;
        for (;;) {
            if (scanner_.atEnd()) refuse("the header has no end", "a line 'end_header'");
            std::string_view rest = nextLine();
            const std::string_view keyword = takeToken(rest);
            if (keyword == "end_header") break;
            if (keyword == "format") {
                parseFormat(rest);
                formatKnown = true;
            } else if (keyword == "element") {
                parseElement(rest);
            } else if (keyword == "property") {
                parseProperty(rest);
            } else if (keyword != "comment" && keyword != "obj_info" && !keyword.empty()) {
                refuse("'" + cleanText(keyword) + "' is no keyword of a PLY header",
                       "format, element, property, comment or end_header");
            }
        }
        if (!formatKnown) refuse("the header names no format", "a line 'format ascii|binary_... 1.0'");
        header_.bodyOffset = scanner_.offset();
        header_.bodyLine = scanner_.line();
        return std::move(header_);
    }

  private:
    std::string_view nextLine() {
        line_ = scanner_.line();
        return scanner_.nextLine();
    }

    [[noreturn]] void refuse(std::string message, std::string expected) const {
        job_.refuseLine(line_, std::move(message), std::move(expected));
    }

    void parseFormat(std::string_view rest) {
        const std::string_view encoding = takeToken(rest);
        if (encoding == "ascii")
            header_.encoding = PlyEncoding::ascii;
        else if (encoding == "binary_little_endian")
            header_.encoding = PlyEncoding::littleEndian;
        else if (encoding == "binary_big_endian")
            header_.encoding = PlyEncoding::bigEndian;
        else
            refuse("the encoding '" + cleanText(encoding) + "' is unknown",
                   "ascii, binary_little_endian or binary_big_endian");
    }

    void parseElement(std::string_view rest) {
        PlyElement& element = header_.elements.emplace_back();
        element.name = std::string(takeToken(rest));
        element.line = line_;
        const auto count = parseInteger(takeToken(rest));
        if (element.name.empty() || !count || *count < 0)
            refuse("the element has no name or no count", "element NAME COUNT");
        element.count = static_cast<std::uint64_t>(*count);
    }

    ScalarType parseType(std::string_view name) const {
        for (const TypeName& known : kTypes)
            if (known.name == name) return known.type;
        refuse("'" + cleanText(name) + "' is no type of a PLY property",
               "char ... double, int8 ... float64 or list");
    }

    void parseProperty(std::string_view rest) {
        if (header_.elements.empty())
            refuse("the property belongs to no element", "a line 'element' before it");
        PlyProperty property;
        std::string_view type = takeToken(rest);
        property.list = type == "list";
        if (property.list) {
            property.lengthType = parseType(takeToken(rest));
            if (!isInteger(property.lengthType)) refuse("a list's length is no integer", "an integer type");
            type = takeToken(rest);
        }
        property.type = parseType(type);
        property.name = std::string(takeToken(rest));
        if (property.name.empty()) refuse("the property has no name", "property TYPE NAME");
        header_.elements.back().properties.push_back(std::move(property));
    }

    TextScanner scanner_;
    const ReadJob& job_;
    std::size_t line_ = 1;
    PlyHeader header_;
};

}  // namespace

PlyHeader parsePlyHeader(std::string_view text, const ReadJob& job) {
    return HeaderParser(text, job).parse();
}

}  // namespace vestige
