#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/base/Error.h"
#include "core/base/Language.h"

namespace vestige {

/// Core speaks English: results, files for machines and logs are the same in every language. Where people
/// read (window, report, picture), what it says is translated: a text is looked up whole, or by the template
/// that the source joins it from ("only %1 of %2 came back"), and what stands at a template's places is
/// translated in turn. What no template fits stays as it is.
class Translator {
  public:
    /// `names`: what people called things; these are never translated, whatever they say. Where they are not
    /// given, a single word at a template's place counts as one.
    explicit Translator(Language language);
    Translator(Language language, std::set<std::string, std::less<>> names);

    Language language() const { return language_; }
    std::string operator()(std::string_view english) const;

  private:
    Language language_;
    bool namesKnown_ = false;
    std::set<std::string, std::less<>> names_;
};

/// The language of the process, English at first. Set before work starts; safe to read from any thread.
void setLanguage(Language language);
Language language();

/// A text in the language of the process.
std::string say(std::string_view english);
/// A template with its places filled: say("Page %1 of %2", {"1", "9"}). The values are not translated.
std::string say(std::string_view english, const std::vector<std::string>& values);
/// Error::sentence() in the language of the process.
std::string say(const Error& error);

}  // namespace vestige
