#include <algorithm>
#include <cstdio>

#include "core/base/Units.h"
#include "tests/bench/registration/Trials.h"

namespace vestige::bench {
namespace {

std::string printed(const char* format, double value) {
    char text[64];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

std::string milliseconds(double seconds) {
    return printed(seconds < 0.1 ? "%.1f" : "%.0f", 1000 * seconds);
}

std::vector<double> allTimes(const RoundTimes& rounds) {
    std::vector<double> all;
    for (const auto& round : rounds) all.insert(all.end(), round.begin(), round.end());
    return all;
}

std::string ratioText(const Trial& trial, const std::vector<Trial>& trials) {
    const Trial* ours = oursFor(trial, trials);
    if (!ours || ours == &trial) return "1";
    const std::vector<double> ratios = ratiosByRound(trial.seconds, ours->seconds);
    if (ratios.empty()) return "-";
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    return wallRatio(trial, trials) + " (" + printed("%.1f", *least) + " - " + printed("%.1f", *most) + ")";
}

std::string noteOf(const Trial& trial, const std::vector<Trial>& trials) {
    std::string note;
    const auto add = [&note](const std::string& text) { note += (note.empty() ? "" : "; ") + text; };
    if (missed(trial.error)) add(trial.contender.ours ? "missed the pose" : "missed the pose: lower bound");
    if (!trial.counts) add("as asked; another setting counts");
    if (trial.refused > 0) add(std::to_string(trial.refused) + " rounds refused, machine loaded");
    if (trial.threads == 2 && trial.contender.ours) {
        for (const Trial& one : trials) {
            if (one.pair != trial.pair || one.threads != 1 || one.contender.name != trial.contender.name)
                continue;
            const std::vector<double> gains = ratiosByRound(one.seconds, trial.seconds);
            if (!gains.empty()) add(printed("%.2f", median(gains)) + " times one thread");
        }
    }
    return note;
}

}  // namespace

const Trial* oursFor(const Trial& trial, const std::vector<Trial>& trials) {
    const auto found = std::find_if(trials.begin(), trials.end(), [&](const Trial& other) {
        return other.pair == trial.pair && other.threads == trial.threads;
    });
    return found == trials.end() ? nullptr : &*found;
}

std::string wallRatio(const Trial& trial, const std::vector<Trial>& trials) {
    const Trial* ours = oursFor(trial, trials);
    if (!ours || ours == &trial) return "1";
    const std::vector<double> ratios = ratiosByRound(trial.seconds, ours->seconds);
    if (ratios.empty()) return "-";
    const bool bound = !trial.contender.ours && missed(trial.error);
    return (bound ? "> " : "") + printed("%.1f", median(ratios));
}

std::string cpuRatio(const Trial& trial, const std::vector<Trial>& trials) {
    const Trial* ours = oursFor(trial, trials);
    if (!ours || ours == &trial) return "1";
    const std::vector<double> times = allTimes(trial.cpu_seconds);
    const std::vector<double> oursTimes = allTimes(ours->cpu_seconds);
    if (times.empty() || oursTimes.empty()) return "-";
    return printed("%.1f", minimum(times) / minimum(oursTimes));
}

std::string goalsTable(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials) {
    struct Goal {
        const char* contender;
        double leaf_m;  ///< 0: the setting that counts
        const char* title;
    };
    constexpr Goal kGoals[] = {{"PCL NDT, Debian", 1, "PCL NDT, Debian, 1.0 m: 50"},
                               {"PCL NDT, Debian", 0, "at the setting that counts: 50"},
                               {"PCL NDT, AVX2", 1, "PCL NDT, AVX2, 1.0 m: 30"},
                               {"PCL NDT, AVX2", 0, "at the setting that counts: 30"},
                               {"PCL NDT chain, Debian", 0, "chain, Debian: 80"},
                               {"PCL NDT chain, AVX2", 0, "chain, AVX2: 50"}};
    std::string text = "\n| pair | our error mm, deg |";
    std::string line = "|---|---|";
    for (const Goal& goal : kGoals) {
        text += std::string(" ") + goal.title + " |";
        line += "---|";
    }
    text += " two threads: 1.7 |\n" + line + "---|\n";
    for (const ScanPair& pair : pairs) {
        std::string row = "| " + pair.name + " | ";
        const Trial* single = nullptr;
        for (const Trial& trial : trials)
            if (!single && trial.pair == &pair && trial.threads == 1) single = &trial;
        if (!single) continue;
        row += printed("%.2f, ", 1000 * single->error.translation_m) +
               printed("%.3f |", degrees(single->error.rotation_rad));
        for (const Goal& goal : kGoals) {
            std::string cell = "-";
            for (const Trial& trial : trials)
                if (trial.pair == &pair && trial.threads == 1 && trial.contender.name == goal.contender &&
                    (goal.leaf_m > 0 ? trial.leaf_m == goal.leaf_m : trial.counts))
                    cell = wallRatio(trial, trials) + " (CPU " + cpuRatio(trial, trials) + ")";
            row.append(" ").append(cell).append(" |");
        }
        std::string gain = "refused";
        for (const Trial& trial : trials) {
            if (trial.pair != &pair || trial.threads != 2 || trial.contender.name != single->contender.name)
                continue;
            const std::vector<double> gains = ratiosByRound(single->seconds, trial.seconds);
            if (!gains.empty()) gain = printed("%.2f", median(gains));
        }
        text.append(row).append(" ").append(gain).append(" |\n");
    }
    return text;
}

std::string markdown(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials) {
    std::string text = goalsTable(pairs, trials);
    for (const ScanPair& pair : pairs) {
        const PoseError start = poseError(pair.start, pair.reference);
        text += "\n### " + pair.name + "\n\n" + std::to_string(pair.target.size()) + " and " +
                std::to_string(pair.source.size()) + " points; first pose wrong by " +
                printed("%.2f m", start.translation_m) + " and " +
                printed("%.1f degrees", degrees(start.rotation_rad)) + "; truth: " + pair.truth + ".\n\n";
        text +=
            "| method | setting | threads | median ms | min ms | min CPU ms | error mm | error deg | times "
            "ours (range over rounds) | by CPU | note |\n|---|---|---|---|---|---|---|---|---|---|---|\n";
        for (const Trial& trial : trials) {
            if (trial.pair != &pair) continue;
            const std::vector<double> times = allTimes(trial.seconds);
            if (times.empty() && trial.refused == 0) continue;  // filtered out by name
            const std::string setting = trial.leaf_m > 0 ? printed("%g m", trial.leaf_m) : "-";
            text +=
                "| " + trial.contender.name + " | " + setting + " | " + std::to_string(trial.threads) + " | ";
            text += times.empty() ? "refused | - | -"
                                  : milliseconds(median(times)) + " | " + milliseconds(minimum(times)) +
                                        " | " + milliseconds(minimum(allTimes(trial.cpu_seconds)));
            text += " | " + printed("%.2f", 1000 * trial.error.translation_m) + " | " +
                    printed("%.3f", degrees(trial.error.rotation_rad)) + " | " + ratioText(trial, trials) +
                    " | " + cpuRatio(trial, trials) + " | " + noteOf(trial, trials) + " |\n";
        }
    }
    return text;
}

}  // namespace vestige::bench
