#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "core/base/JobControl.h"
#include "core/base/Result.h"

namespace vestige {

/// One step of a recipe over some state.
template <class State>
struct Stage {
    std::string id;
    std::string title;  ///< for people: progress, report
    double share = 1;   ///< of the progress, relative to the other stages
    std::function<Status(State&, const JobControl&)> run;
};

/// The stages of a job, in order.
template <class State>
using Recipe = std::vector<Stage<State>>;

/// Runs the stages one after the other; ends at the first error, or with ErrorCode::cancelled between two.
/// `done(stage, seconds)` hears of each that is finished.
template <class State, class Done>
Status runRecipe(const Recipe<State>& recipe, State& state, const JobControl& control, const Done& done) {
    double whole = 0;
    for (const auto& stage : recipe) whole += stage.share;
    double before = 0;
    for (const auto& stage : recipe) {
        if (control.cancelled()) return fail(cancelledError());
        const JobControl sub = control.sub(before / whole, (before + stage.share) / whole);
        sub.progress(0, stage.title);
        const auto start = std::chrono::steady_clock::now();
        const Status status = guarded(stage.title, [&] { return stage.run(state, sub); });
        if (!status) return status;
        done(stage, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        before += stage.share;
    }
    if (control.cancelled()) return fail(cancelledError());
    control.progress(1);
    return {};
}

}  // namespace vestige
