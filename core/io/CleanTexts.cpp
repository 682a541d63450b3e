#include "core/io/CleanTexts.h"

#include <algorithm>

#include "core/base/CleanText.h"

namespace vestige {
namespace {

void clean(std::string& text, std::size_t longest) {
    text = cleanText(text, longest);
}

void cleanAll(std::vector<std::string>& texts, std::size_t longest) {
    for (std::string& text : texts) clean(text, longest);
}

}  // namespace

void cleanTexts(FileInfo& info) {
    const auto isBlank = [](char c) { return c == '\n' || c == '\r' || c == '\t'; };
    std::replace_if(info.crs.begin(), info.crs.end(), isBlank, ' ');
    clean(info.crs, info.crs.size());
    for (std::string* text : {&info.format, &info.version, &info.generatingSoftware})
        clean(*text, kLongestName);
    clean(info.damage, kLongestSentence);
    cleanAll(info.attributes, kLongestName);
    cleanAll(info.warnings, kLongestSentence);
    for (ScanInfo& scan : info.scans)
        for (std::string* text :
             {&scan.name, &scan.guid, &scan.sensorVendor, &scan.sensorModel, &scan.sensorSerial})
            clean(*text, kLongestName);
    for (ImageInfo& image : info.images) clean(image.name, kLongestName);
}

void cleanTexts(Error& error) {
    clean(error.message, kLongestSentence);
    clean(error.hint, kLongestSentence);
}

}  // namespace vestige
