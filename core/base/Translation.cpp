#include "core/base/Translation.h"

#include <algorithm>
#include <array>
#include <atomic>

#include "core/base/Catalogue.h"
#include "core/base/TextTemplate.h"

namespace vestige {
namespace {

constexpr int kDeepest = 8;

std::atomic<Language> processLanguage{Language::english};

struct Form {
    TextTemplate english;
    TextTemplate translated;
    std::size_t size;
    bool needsFigure;  ///< "%1 steps": too little to be told from other texts unless a figure stands there
};

/// The templates of a language, those with the most literal text first.
std::vector<Form> formsOf(Language language) {
    std::vector<Form> forms;
    for (const CatalogueEntry& entry : catalogue(language)) {
        Form form{TextTemplate(entry.english), TextTemplate(entry.translated), 0, false};
        if (form.english.places.empty() || form.english.words() == 0) continue;
        form.size = form.english.literalSize();
        form.needsFigure = form.english.words() < 2 && form.english.pieces.front().empty();
        forms.push_back(std::move(form));
    }
    std::stable_sort(forms.begin(), forms.end(),
                     [](const Form& a, const Form& b) { return a.size > b.size; });
    return forms;
}

const std::vector<Form>& forms() {
    static const std::vector<Form> chinese = formsOf(Language::simplifiedChinese);
    return chinese;
}

bool hasLetters(std::string_view text) {
    return std::any_of(text.begin(), text.end(),
                       [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
}

bool isFigure(std::string_view text) {
    return text.find_first_of("0123456789") != std::string_view::npos && !hasLetters(text);
}

bool isQuoted(const TextTemplate& form, std::size_t place) {
    constexpr std::array<std::string_view, 3> kOpening{"'", "\"", "\u201c"};
    return std::any_of(kOpening.begin(), kOpening.end(),
                       [&](std::string_view mark) { return form.pieces[place].ends_with(mark); });
}

const CatalogueEntry* find(Language language, std::string_view english) {
    const auto entries = catalogue(language);
    const auto found = std::lower_bound(
        entries.begin(), entries.end(), english,
        [](const CatalogueEntry& entry, std::string_view text) { return entry.english < text; });
    return found != entries.end() && found->english == english ? &*found : nullptr;
}

std::string_view trimmed(std::string_view text) {
    const std::size_t begin = text.find_first_not_of(" \n");
    if (begin == std::string_view::npos) return {};
    return text.substr(begin, text.find_last_not_of(" \n") + 1 - begin);
}

/// What stands between texts behind each other.
struct Joint {
    std::string_view english;
    std::string_view translated;
};
constexpr std::array<Joint, 5> kJoints{
    {{". ", "\u3002"}, {"\n", "\n"}, {"; ", "\uff1b"}, {": ", "\uff1a"}, {", ", "\uff0c"}}};

std::vector<std::size_t> beginsOf(std::string_view text, std::string_view joint) {
    std::vector<std::size_t> begins{0};
    for (std::size_t at = text.find(joint); at != std::string_view::npos; at = text.find(joint, at + 1))
        begins.push_back(at + joint.size());
    return begins;
}

/// Stands for a name while a text is translated: the first byte of a character of Unicode's private area.
constexpr char kHiddenName = '\xee';

/// Names of several words, which could be taken for a part of a sentence, hidden behind one character each.
class Hiding {
  public:
    explicit Hiding(const std::set<std::string, std::less<>>& names) {
        for (const std::string& name : names)
            if (name.find(' ') != std::string::npos && names_.size() < kMost) names_.push_back(&name);
        // A name may be a part of another one.
        std::stable_sort(names_.begin(), names_.end(),
                         [](const auto* a, const auto* b) { return a->size() > b->size(); });
    }
    std::string hidden(std::string text) const {
        for (std::size_t i = 0; i < names_.size(); ++i) replaceAll(text, *names_[i], mark(i));
        return text;
    }
    std::string shown(std::string text) const {
        for (std::size_t i = 0; i < names_.size(); ++i) replaceAll(text, mark(i), *names_[i]);
        return text;
    }

  private:
    static std::string mark(std::size_t i) {
        return {kHiddenName, static_cast<char>(0x80 + i / 64), static_cast<char>(0x80 + i % 64)};
    }
    static void replaceAll(std::string& text, const std::string& what, const std::string& by) {
        for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
            text.replace(at, what.size(), by);
    }

    static constexpr std::size_t kMost = 56 * 64;  // U+E000 to U+EDFF
    std::vector<const std::string*> names_;
};

class Reading {
  public:
    Reading(Language language, bool namesKnown, const std::set<std::string, std::less<>>& names)
        : language_(language), namesKnown_(namesKnown), names_(names) {}

    std::optional<std::string> text(std::string_view english, int depth = 0) const {
        if (const CatalogueEntry* entry = find(language_, english); entry && !names_.contains(english))
            return std::string(entry->translated);
        const std::string_view bare = trimmed(english);
        if (depth > kDeepest || !hasLetters(bare) || names_.contains(bare)) return std::nullopt;
        if (auto said = whole(bare, depth)) return said;
        return joined(bare, 0, depth);
    }

  private:
    /// By one text or one template of the catalogue.
    std::optional<std::string> whole(std::string_view english, int depth) const {
        if (names_.contains(english)) return std::nullopt;
        if (const CatalogueEntry* entry = find(language_, english)) return std::string(entry->translated);
        for (const Form& form : forms())
            if (auto said = fitted(form, english, depth)) return said;
        return std::nullopt;
    }

    std::optional<std::string> fitted(const Form& form, std::string_view english, int depth) const {
        if (form.size > english.size()) return std::nullopt;
        const auto values = form.english.match(english);
        if (!values) return std::nullopt;
        // The full stop belongs to the sentence, not to what stands at the end of it.
        if (form.english.pieces.back().empty() && values->back().ends_with('.')) return std::nullopt;
        if (form.needsFigure && std::none_of(values->begin(), values->end(), isFigure) &&
            !std::all_of(values->begin(), values->end(),
                         [&](std::string_view value) { return isName(value); }))
            return std::nullopt;
        std::vector<std::string> said(9);
        for (std::size_t i = 0; i < values->size(); ++i)
            said[static_cast<std::size_t>(form.english.places[i] - 1)] =
                isQuoted(form.english, i) ? std::string((*values)[i]) : value((*values)[i], depth);
        return form.translated.filled(said);
    }

    std::string value(std::string_view english, int depth) const {
        const bool word = english.find(' ') == std::string_view::npos;
        const CatalogueEntry* entry = word ? find(language_, english) : nullptr;
        if (word && !namesKnown_ && !(entry && entry->vocabulary)) return std::string(english);
        return text(english, depth + 1).value_or(std::string(english));
    }

    /// Several texts behind each other: sentences, reasons, a place and what is wrong there. Each run of them
    /// that is in the catalogue is taken, the longest first.
    std::optional<std::string> joined(std::string_view english, std::size_t level, int depth) const {
        if (level == kJoints.size()) return std::nullopt;
        const Joint& joint = kJoints[level];
        if (joint.english == ", ")
            if (auto said = list(english)) return said;
        const std::vector<std::size_t> begins = beginsOf(english, joint.english);
        const auto run = [&](std::size_t from, std::size_t to) {
            const std::size_t end = to == begins.size() ? english.size() : begins[to] - joint.english.size();
            return english.substr(begins[from], end - begins[from]);
        };
        std::string said;
        bool any = false;
        for (std::size_t i = 0; i < begins.size();) {
            std::size_t to = begins.size();
            std::optional<std::string> best;
            for (; to > i && !names_.contains(run(i, to)); --to) {
                const bool stopFollows = to < begins.size();
                best = level == 0 ? sentence(run(i, to), stopFollows, depth) : whole(run(i, to), depth);
                if (best) break;
            }
            if (to == i) {
                to = i + 1;
                best = joined(run(i, to), level + 1, depth);
                if (best && level == 0 && to < begins.size()) *best += joint.translated;
            }
            any = any || best;
            if (i > 0 && level > 0) said += joint.translated;
            if (best)
                said += *best;
            else
                said += std::string(run(i, to)) + (level == 0 && to < begins.size() ? ". " : "");
            i = to;
        }
        return any ? std::optional(said) : std::nullopt;
    }

    /// The catalogue has a sentence with its full stop, a message without.
    std::optional<std::string> sentence(std::string_view english, bool stopFollows, int depth) const {
        if (stopFollows)
            if (auto said = whole(std::string(english) + ".", depth)) return said;
        const bool stops = !stopFollows && english.ends_with('.');
        auto said = whole(stops ? english.substr(0, english.size() - 1) : english, depth);
        if (said && (stops || stopFollows)) *said += "\u3002";
        return said;
    }

    bool isName(std::string_view text) const {
        return names_.contains(text) || text.starts_with(kHiddenName) ||
               names_.contains(text.substr(0, text.find(" (")));
    }

    /// "a, b and c" of names.
    std::optional<std::string> list(std::string_view english) const {
        const std::size_t last = english.rfind(" and ");
        if (last == std::string_view::npos || !namesKnown_) return std::nullopt;
        std::string said;
        std::string_view rest = english.substr(0, last);
        while (!rest.empty()) {
            const std::size_t comma = rest.find(", ");
            const std::string_view one = rest.substr(0, comma);
            if (!isName(one)) return std::nullopt;
            said += (said.empty() ? "" : "\u3001") + std::string(one);
            rest = comma == std::string_view::npos ? std::string_view() : rest.substr(comma + 2);
        }
        const std::string_view end = english.substr(last + 5);
        if (!isName(end)) return std::nullopt;
        return said + "\u548c" + std::string(end);
    }

    Language language_;
    bool namesKnown_;
    const std::set<std::string, std::less<>>& names_;
};

}  // namespace

Translator::Translator(Language language) : language_(language) {}

Translator::Translator(Language language, std::set<std::string, std::less<>> names)
    : language_(language), namesKnown_(true), names_(std::move(names)) {}

std::string Translator::operator()(std::string_view english) const {
    if (language_ == Language::english) return std::string(english);
    const Hiding hiding(names_);
    const std::string hidden = hiding.hidden(std::string(english));
    const auto said = Reading(language_, namesKnown_, names_).text(hidden);
    return said ? hiding.shown(*said) : std::string(english);
}

void setLanguage(Language language) {
    processLanguage = language;
}

Language language() {
    return processLanguage;
}

std::string say(std::string_view english) {
    return Translator(language())(english);
}

std::string say(std::string_view english, const std::vector<std::string>& values) {
    const CatalogueEntry* entry = find(language(), english);
    return TextTemplate(entry ? entry->translated : english).filled(values);
}

std::string say(const Error& error) {
    if (language() == Language::english) return error.sentence();
    std::string text;
    if (!error.place.empty()) text += say(error.place) + "\uff1a";
    text += say(error.message);
    if (!error.hint.empty()) text += "\uff1b" + say(error.hint);
    return text;
}

}  // namespace vestige
