#include "tests/bench/filters/Scoreboard.h"

#include <algorithm>
#include <iomanip>

namespace vestige {
namespace {

/// "row/peer/threads/iterations:1/..." cut at the slashes.
std::vector<std::string> parts(const std::string& name) {
    std::vector<std::string> found(1);
    for (const char c : name) {
        if (c == '/') {
            found.emplace_back();
        } else {
            found.back() += c;
        }
    }
    return found;
}

double median(std::vector<double> values) {
    std::sort(values.begin(), values.end());
    return 0.5 * (values[(values.size() - 1) / 2] + values[values.size() / 2]);
}

double least(const std::vector<double>& values) {
    return *std::min_element(values.begin(), values.end());
}

}  // namespace

void Scoreboard::ReportRuns(const std::vector<Run>& runs) {
    ConsoleReporter::ReportRuns(runs);
    for (const Run& run : runs) {
        if (run.run_type != Run::RT_Iteration || run.error_occurred) continue;
        const auto names = parts(run.benchmark_name());
        auto entry = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& one) {
            return one.row == names[0] && one.peer == names[1] && one.threads == names[2];
        });
        if (entry == entries_.end())
            entry = entries_.insert(entries_.end(), Entry{names[0], names[1], names[2], 0, {}, {}});
        const auto points = run.counters.find("points");
        if (points != run.counters.end()) entry->points = points->second.value;
        entry->wall_ms.push_back(1e3 * run.real_accumulated_time / static_cast<double>(run.iterations));
        entry->cpu_ms.push_back(1e3 * run.cpu_accumulated_time / static_cast<double>(run.iterations));
    }
}

void Scoreboard::writeTable(std::ostream& out) const {
    std::vector<Entry> sorted = entries_;
    std::stable_sort(sorted.begin(), sorted.end(), [](const Entry& a, const Entry& b) {
        return std::tie(a.row, a.peer, a.threads) < std::tie(b.row, b.peer, b.threads);
    });
    out << "\n| work | program | threads | median ms | least ms | least CPU ms | Mpts/s | times " << standard_
        << ": median, least, CPU |\n|---|---|---|---|---|---|---|---|\n"
        << std::fixed;
    for (const Entry& entry : sorted) {
        const auto against = std::find_if(sorted.begin(), sorted.end(), [&](const Entry& one) {
            return one.row == entry.row && one.peer == standard_;
        });
        out << "| " << entry.row << " | " << entry.peer << " | " << entry.threads << " | "
            << std::setprecision(1) << median(entry.wall_ms) << " | " << least(entry.wall_ms) << " | "
            << least(entry.cpu_ms) << " | " << std::setprecision(2)
            << entry.points / least(entry.wall_ms) * 1e-3 << " | ";
        if (against != sorted.end()) {
            out << std::setprecision(1) << median(against->wall_ms) / median(entry.wall_ms) << ", "
                << least(against->wall_ms) / least(entry.wall_ms);
            if (entry.threads == "1") out << ", " << least(against->cpu_ms) / least(entry.cpu_ms);
        }
        out << " |\n";
    }
}

}  // namespace vestige
