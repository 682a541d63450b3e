#pragma once

#include <set>
#include <string>
#include <string_view>

namespace vestige::test {

/// The English words of a text that is to be Chinese, each once: words of three letters or more that are
/// neither abbreviations, units, products and file names nor in `names` (whole phrases that people gave).
std::set<std::string> englishLeft(std::string_view text, const std::set<std::string>& names = {});

}  // namespace vestige::test
