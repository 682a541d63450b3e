#include "core/io/ReadJob.h"

#include <utility>

#include "core/base/CleanText.h"
#include "core/io/CleanTexts.h"

namespace vestige {
namespace {

/// Messages quote the file, hints may: neither may hold more than a sentence, or speak to the terminal.
Error refusal(const std::string& message, std::string place, const std::string& expected) {
    return {ErrorCode::input, cleanText(message, kLongestSentence), std::move(place),
            expected.empty() ? expected : "expected: " + cleanText(expected, kLongestSentence)};
}

}  // namespace

void ReadJob::refuse(std::string message, const std::string& expected) const {
    throw ErrorException{refusal(message, place(), expected)};
}

void ReadJob::refuseLine(std::size_t line, std::string message, const std::string& expected) const {
    throw ErrorException{refusal(message, place() + ", line " + std::to_string(line), expected)};
}

void ReadJob::refuseByte(std::size_t byte, std::string message, const std::string& expected) const {
    throw ErrorException{refusal(message, place() + ", byte " + std::to_string(byte), expected)};
}

void ReadJob::untilDamage(const std::function<void()>& work, const std::function<WholePart()>& whole) {
    try {
        work();
    } catch (ErrorException& refusal) {
        Error& error = refusal.error;
        if (error.code != ErrorCode::input) throw;
        const WholePart part = whole();
        if (part.points == 0) throw;
        if (!salvage_) {
            offerSalvage(error, part.words);
            throw;
        }
        const std::string file = place();
        const std::string where = error.place.starts_with(file) ? error.place.substr(file.size()) : "";
        damage_ = "the file is damaged" + where + ": " + error.message + "; " + part.words +
                  " are whole and were read";
    }
}

void offerSalvage(Error& error, const std::string& words) {
    error.salvageable = true;
    error.hint +=
        (error.hint.empty() ? "" : "; ") + words +
        " are whole and can be read where damage is allowed (--salvage; in a case \"salvage\": true)";
}

void ReadJob::alsoReads(const std::filesystem::path& file) {
    companions_.push_back(file);
    companionStamps_.push_back(stampOf(file).value_or(FileStamp{}));
}

void ReadJob::warn(std::string sentence) {
    constexpr std::size_t kMostWarnings = 100;
    if (warnings_.size() > kMostWarnings) return;
    if (warnings_.size() == kMostWarnings) sentence = "further notes on this file are not listed";
    warnings_.push_back(cleanText(sentence, kLongestSentence));
}

void ReadJob::report(std::size_t done, std::size_t total) const {
    if (control_.cancelled()) throw ErrorException{cancelledError()};
    if (total > 0) control_.progress(static_cast<double>(done) / static_cast<double>(total), "reading");
}

std::string counted(std::size_t count, const std::string& noun) {
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

std::string firstOf(std::size_t whole, std::size_t promised, const std::string& noun) {
    if (whole >= promised) return "all " + counted(whole, noun);
    return "the first " + std::to_string(whole) + " of " + counted(promised, noun);
}

}  // namespace vestige
