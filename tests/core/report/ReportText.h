#pragma once

#include <string>

#include "core/report/Section.h"

namespace vestige::test {

inline void appendText(std::string& text, const Paragraph& block) {
    text += block.text + "\n";
}
inline void appendText(std::string& text, const Facts& block) {
    for (const auto& [name, value] : block.rows) text += name + ": " + value + "\n";
}
/// Cells end with a tab and begin after a line feed, so that a test can ask for a whole cell.
inline void appendText(std::string& text, const Table& block) {
    text += block.caption + "\n";
    for (const auto& row : block.rows)
        for (const auto& cell : row) text += "\n" + cell + "\t";
    text += "\n";
}
inline void appendText(std::string& text, const Picture& block) {
    text += block.caption + "\n";
}
inline void appendText(std::string& text, const BarChart& block) {
    text += block.caption + "\n";
}
inline void appendText(std::string& text, const LineChart& block) {
    text += block.caption + "\n";
    for (const auto& series : block.series) text += series.name + "\n";
}

inline void appendText(std::string& text, const Diagram& block) {
    text += block.caption + "\n";
    for (const auto& series : block.series) text += series.name + "\n";
}

/// Everything that a report says, in its order.
inline std::string textOf(const Report& report) {
    std::string text = report.title + "\n" + report.subtitle + "\n" + report.caseName + "\n";
    for (const Section& section : report.sections) {
        text += "# " + section.title + "\n";
        for (const Block& block : section.blocks)
            std::visit([&](const auto& one) { appendText(text, one); }, block);
    }
    return text;
}

}  // namespace vestige::test
