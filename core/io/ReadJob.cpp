#include "core/io/ReadJob.h"

#include <utility>

namespace vestige {
namespace {

std::string hintOf(const std::string& expected) {
    return expected.empty() ? expected : "expected: " + expected;
}

}  // namespace

void ReadJob::refuse(std::string message, const std::string& expected) const {
    throw ErrorException{{ErrorCode::input, std::move(message), place(), hintOf(expected)}};
}

void ReadJob::refuseLine(std::size_t line, std::string message, const std::string& expected) const {
    throw ErrorException{
        {ErrorCode::input, std::move(message), place() + ", line " + std::to_string(line), hintOf(expected)}};
}

void ReadJob::refuseByte(std::size_t byte, std::string message, const std::string& expected) const {
    throw ErrorException{
        {ErrorCode::input, std::move(message), place() + ", byte " + std::to_string(byte), hintOf(expected)}};
}

void ReadJob::warn(std::string sentence) {
    warnings_.push_back(std::move(sentence));
}

void ReadJob::report(std::size_t done, std::size_t total) const {
    if (control_.cancelled()) throw ErrorException{cancelledError()};
    if (total > 0) control_.progress(static_cast<double>(done) / static_cast<double>(total), "reading");
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

}  // namespace vestige
