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

/// Ours with the same number of threads, which the others of the pair are compared with.
const Trial* oursFor(const Trial& trial, const std::vector<Trial>& trials) {
    const auto found = std::find_if(trials.begin(), trials.end(), [&](const Trial& other) {
        return other.pair == trial.pair && other.threads == trial.threads;
    });
    return found == trials.end() ? nullptr : &*found;
}

std::string ratioText(const Trial& trial, const std::vector<Trial>& trials) {
    const Trial* ours = oursFor(trial, trials);
    if (!ours || ours == &trial) return "1";
    const std::vector<double> ratios = ratiosByRound(trial.seconds, ours->seconds);
    if (ratios.empty()) return "-";
    const bool bound = !trial.contender.ours && missed(trial.error);
    const auto [least, most] = std::minmax_element(ratios.begin(), ratios.end());
    return (bound ? "> " : "") + printed("%.1f", median(ratios)) + " (" + printed("%.1f", *least) + " - " +
           printed("%.1f", *most) + ")";
}

/// The least processor time against ours: what other programs on the machine disturb least.
std::string cpuRatioText(const Trial& trial, const std::vector<Trial>& trials) {
    const Trial* ours = oursFor(trial, trials);
    if (!ours || ours == &trial) return "1";
    const std::vector<double> times = allTimes(trial.cpu_seconds);
    const std::vector<double> oursTimes = allTimes(ours->cpu_seconds);
    if (times.empty() || oursTimes.empty()) return "-";
    return printed("%.1f", minimum(times) / minimum(oursTimes));
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

std::string markdown(const std::vector<ScanPair>& pairs, const std::vector<Trial>& trials) {
    std::string text;
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
                    " | " + cpuRatioText(trial, trials) + " | " + noteOf(trial, trials) + " |\n";
        }
    }
    return text;
}

}  // namespace vestige::bench
