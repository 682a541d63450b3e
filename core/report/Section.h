#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace vestige {

/// Blocks of a report, as content without layout; ui/print sets them, CSV and tests read them.
struct Paragraph {
    std::string text;
};
struct Facts {
    std::vector<std::pair<std::string, std::string>> rows;  ///< name, value
};
struct Table {
    std::string caption;
    std::vector<std::string> columns;
    std::vector<bool> numeric;  ///< right-aligned; one per column
    std::vector<std::vector<std::string>> rows;
    std::vector<std::size_t> emphasised;  ///< rows to set off, e.g. excluded objects
    std::vector<double> widths;           ///< relative; empty: by content
};
struct Picture {
    std::filesystem::path png;
    std::string caption;
    double width = 1;  ///< share of the text's width; two of 0.5 that follow each other stand side by side
    bool toScale = false;  ///< as large as its file's dots per inch say, as far as the page has room
};
struct BarChart {
    std::string caption;
    std::string unit;  ///< of the axis, e.g. "%"
    std::vector<std::string> categories;
    struct Series {
        std::string name;
        std::vector<std::optional<double>> values;  ///< one per category
        std::vector<bool> excluded;                 ///< one per category, or empty: none
    };
    std::vector<Series> series;
};
/// Values against a size; both axes logarithmic, so values are positive (others are left out).
struct LineChart {
    std::string caption;
    std::string xName;  ///< with unit: "Voxel (m)"
    std::string yName;
    struct Series {
        std::string name;
        std::vector<std::pair<double, double>> points;  ///< x, y; ascending or descending in x
        bool dashed = false;                            ///< what others published, beside what was measured
    };
    std::vector<Series> series;
};
/// Lines in metres on axes as they are, not logarithmic: a cross-section, a crush profile.
struct Diagram {
    std::string caption;
    std::string xName;  ///< with unit
    std::string yName;
    struct Series {
        std::string name;
        std::vector<std::pair<double, double>> points;
        bool dots = false;  ///< marks its points, e.g. stations
    };
    std::vector<Series> series;
};
using Block = std::variant<Paragraph, Facts, Table, Picture, BarChart, LineChart, Diagram>;

struct Section {
    std::string title;
    std::vector<Block> blocks;
};

struct Report {
    std::string title;
    std::string subtitle;
    std::string caseName;
    std::string operatorName;
    std::string date;  ///< as people read it: readableDate()
    std::string software;
    std::vector<Section> sections;
    std::vector<std::string>
        names;  ///< that people gave: case, operator, layers, objects, files; never translated
};

}  // namespace vestige
