#pragma once

#include <benchmark/benchmark.h>

#include <map>
#include <ostream>
#include <string>
#include <vector>

namespace vestige {

/// Prints benchmarks named "row/peer/threads" as a Markdown table: per row and peer the median and least wall
/// time, the least processor time of all threads, million points a second (counter "points" over the least
/// wall time), and how many times as fast as the row's peer `standard`: by median, by least wall time and by
/// processor time (the one that other programs on the machine disturb least; of one thread only).
class Scoreboard : public benchmark::ConsoleReporter {
  public:
    explicit Scoreboard(std::string standard) : standard_(std::move(standard)) {}

    void ReportRuns(const std::vector<Run>& runs) override;
    void writeTable(std::ostream& out) const;

  private:
    struct Entry {
        std::string row;
        std::string peer;
        std::string threads;
        double points = 0;
        std::vector<double> wall_ms;
        std::vector<double> cpu_ms;
    };
    std::string standard_;
    std::vector<Entry> entries_;
};

}  // namespace vestige
