#pragma once

#include <optional>
#include <string_view>

namespace vestige {

/// What people can read the program and its reports in. Files for machines (JSON, CSV, logs) are English
/// always.
enum class Language { english, simplifiedChinese };

/// "en", "zh_CN": on the command line and in the settings.
std::string_view name(Language language);
std::optional<Language> languageFromName(std::string_view name);

/// Of a locale's name as POSIX or Qt write it ("zh_CN.UTF-8", "zh-Hans-CN"); English where it is not one of
/// ours. Traditional Chinese is not.
Language languageOfLocale(std::string_view locale);

}  // namespace vestige
