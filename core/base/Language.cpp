#include "core/base/Language.h"

#include <array>
#include <string>
#include <utility>

namespace vestige {
namespace {

constexpr std::array<std::pair<Language, std::string_view>, 2> kNames{
    {{Language::english, "en"}, {Language::simplifiedChinese, "zh_CN"}}};

}  // namespace

std::string_view name(Language language) {
    return kNames[static_cast<std::size_t>(language)].second;
}

std::optional<Language> languageFromName(std::string_view name) {
    for (const auto& [language, text] : kNames)
        if (text == name) return language;
    return std::nullopt;
}

Language languageOfLocale(std::string_view locale) {
    const std::string_view plain = locale.substr(0, locale.find_first_of(".@"));
    if (plain.substr(0, 2) != "zh" || (plain.size() > 2 && plain[2] != '_' && plain[2] != '-'))
        return Language::english;
    constexpr std::array<std::string_view, 4> kTraditional{"TW", "HK", "MO", "Hant"};
    for (const std::string_view mark : kTraditional)
        if (plain.find(mark) != std::string_view::npos) return Language::english;
    return Language::simplifiedChinese;
}

}  // namespace vestige
