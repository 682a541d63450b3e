#include "core/io/formats/VtkValues.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <utility>

#include "core/base/Numbers.h"

namespace vestige {

void VtkValues::refuse(const std::string& message, const std::string& expected) const {
    if (binary_) job_.refuseByte(scanner_.offset(), message, expected);
    job_.refuseLine(scanner_.line(), message, expected);
}

std::string VtkValues::keyword() {
    std::string text;
    for (const char c : word()) text += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return text;
}

void VtkValues::checkProduct(std::size_t count, std::size_t components) const {
    if (components > 1000 || count > (std::size_t{1} << 48))
        refuse("an array is larger than any file", "at most 1000 components");
}

void VtkValues::skipMetadata() {
    nextLine();
    while (!trimmed(nextLine()).empty()) {
    }
}

std::size_t VtkValues::count(std::size_t bytesEach) {
    return countFrom(word(), bytesEach);
}

std::size_t VtkValues::countFrom(std::string_view text, std::size_t bytesEach) {
    const auto number = parseInteger(text);
    if (!number || *number < 0) refuse("a count is missing or no whole number", "a whole number from 0");
    // Text may end without a blank behind its last value.
    if (bytesEach > 0 && static_cast<std::size_t>(*number) > (remaining() + 2) / bytesEach)
        refuse("a count of " + std::to_string(*number) + " is more than the file can hold",
               std::to_string(remaining()) + " bytes are left");
    return static_cast<std::size_t>(*number);
}

std::optional<ScalarType> VtkValues::typeOfName(std::string_view name) {
    using enum ScalarType;
    constexpr std::array kTypes{std::pair<std::string_view, ScalarType>("char", int8),
                                std::pair<std::string_view, ScalarType>("unsigned_char", uint8),
                                std::pair<std::string_view, ScalarType>("short", int16),
                                std::pair<std::string_view, ScalarType>("unsigned_short", uint16),
                                std::pair<std::string_view, ScalarType>("int", int32),
                                std::pair<std::string_view, ScalarType>("unsigned_int", uint32),
                                std::pair<std::string_view, ScalarType>("long", int64),
                                std::pair<std::string_view, ScalarType>("unsigned_long", uint64),
                                std::pair<std::string_view, ScalarType>("vtktypeint64", int64),
                                std::pair<std::string_view, ScalarType>("vtktypeuint64", uint64),
                                std::pair<std::string_view, ScalarType>("vtkidtype", int32),
                                std::pair<std::string_view, ScalarType>("float", float32),
                                std::pair<std::string_view, ScalarType>("double", float64)};
    for (const auto& [known, type] : kTypes)
        if (equalsIgnoringCase(name, known)) return type;
    return std::nullopt;
}

ScalarType VtkValues::type() {
    const auto known = typeOfName(word());
    if (!known) refuse("an array's type is unknown", "float, double, int and such");
    return *known;
}

std::size_t VtkValues::beginCutArray(std::size_t count, std::size_t components, ScalarType type) {
    if (binary_) scanner_.nextLine();
    const std::size_t smallest = components * (binary_ ? sizeOf(type) : 2);
    return std::min(count, (remaining() + (binary_ ? 0 : 1)) / smallest);
}

void VtkValues::beginArray(std::size_t values, ScalarType type) {
    if (binary_) scanner_.nextLine();
    const std::size_t smallest = binary_ ? sizeOf(type) : 2;
    if (values > (remaining() + (binary_ ? 0 : 1)) / smallest)
        refuse("the file ends before " + std::to_string(values) + " values",
               "at least " + std::to_string(smallest) + " bytes for each, " + std::to_string(remaining()) +
                   " are left");
}

double VtkValues::value(ScalarType type) {
    if (!binary_) {
        const auto number = scanner_.nextNumber();
        if (!number) refuse("a value is missing or no number", "a number");
        return *number;
    }
    const std::size_t size = sizeOf(type);
    if (remaining() < size) refuse("the file ends before its last value", "as many values as announced");
    const double number = readScalar(
        type, reinterpret_cast<const std::byte*>(file_.data()) + scanner_.offset(), std::endian::big);
    scanner_.skip(size);
    return number;
}

void VtkValues::skipArray(std::size_t values, ScalarType type) {
    beginArray(values, type);
    if (binary_)
        scanner_.skip(values * sizeOf(type));
    else
        for (std::size_t i = 0; i < values; ++i) scanner_.nextToken();
}

}  // namespace vestige
