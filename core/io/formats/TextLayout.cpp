#include "core/io/formats/TextLayout.h"

#include <algorithm>
#include <cmath>

#include "core/io/TextScanner.h"
#include "core/io/formats/TextColumns.h"

namespace vestige {
namespace {

/// Commas within numbers that something else parts.
bool hasDecimalCommas(std::string_view text) {
    const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
    bool within = false;
    for (std::size_t i = 1; i + 1 < text.size(); ++i)
        within = within || (text[i] == ',' && isDigit(text[i - 1]) && isDigit(text[i + 1]));
    return within && text.find_first_of("; \t") != std::string_view::npos;
}

constexpr std::size_t kSampleRows = 1000;
constexpr std::size_t kSampleValues = 1000000;
constexpr std::size_t kLongestLine = 1 << 16;

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\r';
}

char separatorOf(std::string_view line) {
    if (line.find(',') != std::string_view::npos) return ',';
    return line.find(';') != std::string_view::npos ? ';' : ' ';
}

std::string unquoted(std::string_view cell) {
    cell = trimmed(cell);
    if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') cell = cell.substr(1, cell.size() - 2);
    return std::string(trimmed(cell));
}

std::vector<std::string> splitNames(std::string_view line, char separator) {
    std::vector<std::string> names;
    if (separator == ' ') {
        for (auto token = takeToken(line); !token.empty(); token = takeToken(line))
            names.push_back(unquoted(token));
        return names;
    }
    for (;;) {
        const std::size_t end = std::min(line.find(separator), line.size());
        names.push_back(unquoted(line.substr(0, end)));
        if (end == line.size()) return names;
        line.remove_prefix(end + 1);
    }
}

bool namesCoordinates(const std::vector<std::string>& names) {
    const auto has = [&](PointField field) {
        return std::any_of(names.begin(), names.end(),
                           [&](const auto& name) { return fieldOfName(name) == field; });
    };
    return has(PointField::x) && has(PointField::y) && has(PointField::z);
}

std::string_view withoutMark(std::string_view comment) {
    comment = trimmed(comment);
    while (!comment.empty() && std::string_view("#/;%!").find(comment.front()) != std::string_view::npos)
        comment.remove_prefix(1);
    return trimmed(comment);
}

std::string describe(const std::vector<PointField>& fields) {
    constexpr std::array kNames{"-",
                                "x",
                                "y",
                                "z",
                                "nx",
                                "ny",
                                "nz",
                                "red",
                                "green",
                                "blue",
                                "rgb",
                                "intensity",
                                "classification",
                                "gps_time",
                                "point_source_id",
                                "return_number",
                                "number_of_returns"};
    std::string text;
    for (const PointField field : fields)
        text += (text.empty() ? "" : " ") + std::string(kNames[static_cast<std::size_t>(field)]);
    return text;
}

class Recogniser {
  public:
    Recogniser(std::string_view text, ReadJob& job) : scanner_(text), text_(text), job_(job) {}

    TextLayout recognise() {
        std::vector<double> row(64);
        for (;;) {
            if (scanner_.atEnd())
                job_.refuseLine(scanner_.line(), "the file has no row of numbers", "x y z on each line");
            const std::size_t offset = scanner_.offset();
            const std::size_t line = scanner_.line();
            const std::string_view text = scanner_.nextLine();
            if (text.size() > kLongestLine)
                job_.refuseLine(line, "the line is too long for a row of numbers", "x y z on each line");
            if (trimmed(text).empty()) continue;
            if (isComment(text)) {
                takeCommentedNames(text, line);
                continue;
            }
            const char separator = separatorOf(text);
            std::size_t bad = 0;
            const std::size_t cells = splitNumbers(text, separator, row, bad);
            if (bad == 0 && cells == 1 && !promised_ && row[0] >= 0 && row[0] < 1e15 &&
                row[0] == std::floor(row[0])) {
                promised_ = static_cast<std::size_t>(row[0]);  // PTS: the number of points comes first
                continue;
            }
            if (bad == 0 && cells >= 3) return finish(separator, cells, offset, line);
            takeNames(text, separator, line);
        }
    }

  private:
    void takeCommentedNames(std::string_view comment, std::size_t line) {
        const std::string_view text = withoutMark(comment);
        const std::vector<std::string> names = splitNames(text, separatorOf(text));
        if (!namesCoordinates(names)) return;
        names_ = names;
        namesLine_ = line;
    }

    void takeNames(std::string_view text, char separator, std::size_t line) {
        const std::vector<std::string> names = splitNames(text, separator);
        const bool anyName = std::any_of(names.begin(), names.end(), [](const auto& name) {
            return fieldOfName(name) != PointField::none;
        });
        if (!anyName && hasDecimalCommas(text))
            job_.refuseLine(line, "the numbers of this row have decimal commas", "decimal numbers with '.'");
        if (!names_.empty() || !anyName || promised_)
            job_.refuseLine(line, "this is neither a row of numbers nor a row of column names",
                            "x y z and what else there is of intensity, colour and normals, or their names");
        names_ = names;
        namesLine_ = line;
        fieldsOfNames(names_, namesLine_, job_);  // refuses at once a header without x, y and z
        job_.warnings().clear();
    }

    TextLayout finish(char separator, std::size_t cells, std::size_t offset, std::size_t line) {
        TextLayout layout;
        layout.separator = separator;
        layout.bodyOffset = offset;
        layout.bodyLine = line;
        layout.promised = promised_;
        if (!names_.empty()) {
            layout.fields = fieldsOfNames(names_, namesLine_, job_);
            if (cells < names_.size())
                job_.refuseLine(
                    line, "the row has " + counted(cells, "value"),
                    counted(names_.size(), "value") + " as line " + std::to_string(namesLine_) + " names");
        } else {
            layout.fields = guessColumns(sample(separator, cells, offset, line));
            const auto unknown = static_cast<std::size_t>(
                std::count(layout.fields.begin(), layout.fields.end(), PointField::none));
            if (unknown > 0) job_.warn(counted(unknown, "column") + " of unknown meaning not kept");
        }
        layout.description = describe(layout.fields);
        return layout;
    }

    std::vector<std::vector<double>> sample(char separator, std::size_t cells, std::size_t offset,
                                            std::size_t line) {
        std::vector<std::vector<double>> rows;
        TextScanner scanner(text_, offset, line);
        std::vector<double> row(cells);
        while (rows.size() < kSampleRows && rows.size() * cells < kSampleValues && !scanner.atEnd()) {
            const std::string_view text = scanner.nextLine();
            std::size_t bad = 0;
            if (splitNumbers(text, separator, row, bad) == cells && bad == 0) rows.push_back(row);
        }
        return rows;
    }

    TextScanner scanner_;
    std::string_view text_;
    ReadJob& job_;
    std::vector<std::string> names_;
    std::size_t namesLine_ = 0;
    std::optional<std::size_t> promised_;
};

}  // namespace

bool isComment(std::string_view line) {
    line = trimmed(line);
    return line.starts_with('#') || line.starts_with("//") || line.starts_with(';') ||
           line.starts_with('%') || line.starts_with('!');
}

std::size_t splitNumbers(std::string_view line, char separator, std::vector<double>& row, std::size_t& bad) {
    const char* at = line.data();
    const char* end = at + line.size();
    std::size_t cells = 0;
    bad = 0;
    for (;;) {
        while (at != end && isBlank(*at)) ++at;
        if (at == end && (separator == ' ' || cells == 0)) return cells;
        const auto number = takeNumber(at, end);
        ++cells;
        while (at != end && isBlank(*at) && separator != ' ') ++at;
        const bool ended = at == end || *at == separator || (separator == ' ' && isBlank(*at));
        if (!number || !ended) {
            bad = cells;
            return cells;
        }
        if (cells <= row.size()) row[cells - 1] = *number;
        if (at == end) return cells;
        ++at;
    }
}

TextLayout recogniseLayout(std::string_view text, ReadJob& job) {
    return Recogniser(text, job).recognise();
}

}  // namespace vestige
