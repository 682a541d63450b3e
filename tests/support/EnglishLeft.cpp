#include "tests/support/EnglishLeft.h"

#include <algorithm>
#include <regex>
#include <vector>

namespace vestige::test {
namespace {

/// Figures of science, file kinds, products and people, which a Chinese text writes as they are.
const std::set<std::string> kSame{
    "ASCII", "CSV",    "EDL",   "ETH",    "Eigen",     "Esc", "GUM",     "ICP",     "LAS",     "LAZ",
    "LiDAR", "NDT",    "OBJ",   "OSMesa", "PCD",       "PDF", "PLY",     "PNG",     "RGB",     "RMS",
    "RMSE",  "RPE",    "SHA",   "STL",    "UTC",       "VTK", "WGS",     "XML",     "Vestige", "Zhang",
    "Guan",  "Liu",    "World", "Veh",    "Electr",    "Qt",  "English", "Ctrl",    "Shift",   "Alt",
    "min",   "Mesa",   "GCC",   "sor",    "ror",       "ndt", "icp",     "Vehicle", "Journal", "Electric",
    "TBB",   "lambda", "rho",   "deg",    "Backspace", "ftUS"};

}  // namespace

std::set<std::string> englishLeft(std::string_view text, const std::set<std::string>& names) {
    static const std::regex file(
        R"([\w/-]*\.(json|las|laz|ply|xyz|csv|pdf|png|vestige|db)\b|[0-9a-f]{12,}|&[a-z]+;|<[^>]*>)");
    std::string rest(text);
    // A name may be a part of another one.
    std::vector<std::string> longestFirst(names.begin(), names.end());
    std::sort(longestFirst.begin(), longestFirst.end(),
              [](const auto& a, const auto& b) { return a.size() > b.size(); });
    for (const std::string& name : longestFirst)
        for (std::size_t at = rest.find(name); !name.empty() && at != std::string::npos; at = rest.find(name))
            rest.erase(at, name.size()).insert(at, 1, ' ');
    rest = std::regex_replace(rest, file, " ");
    static const std::regex word("[A-Za-z]{3,}");
    std::set<std::string> left;
    for (std::sregex_iterator found(rest.begin(), rest.end(), word), end; found != end; ++found)
        if (!kSame.contains(found->str())) left.insert(found->str());
    return left;
}

}  // namespace vestige::test
