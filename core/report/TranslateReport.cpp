#include "core/report/TranslateReport.h"

#include "core/base/Translation.h"

namespace vestige {
namespace {

/// Figure and unit on one line: Chinese breaks between any two of its characters, so that a line would often
/// begin with a lonely "%".
std::string withUnitsHeld(const std::string& text) {
    std::string held;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool figureBefore = i > 0 && text[i - 1] >= '0' && text[i - 1] <= '9';
        const std::string_view rest = std::string_view(text).substr(i);
        const bool unitAfter = rest.starts_with(" %") || rest.starts_with(" mm") || rest.starts_with(" m");
        if (figureBefore && unitAfter)
            held += "\u00a0";
        else
            held += text[i];
    }
    return held;
}

class Visitor {
  public:
    explicit Visitor(const Translator& say) : say_(say) {}

    void operator()(Paragraph& paragraph) const { turn(paragraph.text); }
    void operator()(Facts& facts) const {
        for (auto& [name, value] : facts.rows) {
            turn(name);
            turn(value);
        }
    }
    void operator()(Table& table) const {
        turn(table.caption);
        for (std::string& column : table.columns) turn(column);
        for (auto& row : table.rows)
            for (std::string& cell : row) turn(cell);
    }
    void operator()(Picture& picture) const { turn(picture.caption); }
    void operator()(BarChart& chart) const {
        turn(chart.caption);
        for (auto& series : chart.series) turn(series.name);
    }
    void operator()(LineChart& chart) const {
        turn(chart.caption);
        turn(chart.xName);
        turn(chart.yName);
        for (auto& series : chart.series) turn(series.name);
    }
    void operator()(Diagram& diagram) const {
        turn(diagram.caption);
        turn(diagram.xName);
        turn(diagram.yName);
        for (auto& series : diagram.series) turn(series.name);
    }
    void turn(std::string& text) const { text = withUnitsHeld(say_(text)); }

  private:
    const Translator& say_;
};

}  // namespace

Report translated(Report report, Language language) {
    if (language == Language::english) return report;
    const Translator say(language, {report.names.begin(), report.names.end()});
    const Visitor visitor(say);
    for (std::string* text : {&report.title, &report.subtitle, &report.date}) visitor.turn(*text);
    for (Section& section : report.sections) {
        visitor.turn(section.title);
        for (Block& block : section.blocks) std::visit(visitor, block);
    }
    return report;
}

}  // namespace vestige
