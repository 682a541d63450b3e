#include "ui/jobs/TimeLeft.h"

#include <QCoreApplication>
#include <algorithm>
#include <cmath>

namespace vestige {
namespace {

constexpr double kFirst_s = 1;
constexpr double kLeastShare = 0.02;
/// The estimate comes within 1/e of what the share says in this part of the time that has passed.
constexpr double kSlowness = 0.1;
constexpr double kLeastSlowness_s = 1;
/// What counts as of late, likewise, and how much it counts beside the rate since the start.
constexpr double kLate = 0.2;
constexpr double kLeastLate_s = 2;
constexpr double kWeightOfLate = 0.8;

double reached(double since_s, double slowness_s) {
    return 1 - std::exp(-since_s / slowness_s);
}

}  // namespace

void TimeLeft::update(double now_s, double share) {
    const double since = now_s - asked_s_;
    if (since <= 0) return;
    if (share < share_) end_s_.reset();
    const double rate = (std::clamp(share, 0.0, 1.0) - share_) / since;
    share_ += rate * since;
    asked_s_ = now_s;
    const double passed = now_s - start_s_;
    if (!rate_)
        rate_ = rate;
    else
        *rate_ += reached(since, std::max(kLeastLate_s, kLate * passed)) * (rate - *rate_);
    if (passed < kFirst_s || share_ < kLeastShare) return;
    const double usual = (1 - kWeightOfLate) * share_ / passed + kWeightOfLate * std::max(0.0, *rate_);
    const double said = now_s + (1 - share_) / usual;
    if (!end_s_) {
        end_s_ = said;
        return;
    }
    *end_s_ += reached(since, std::max(kLeastSlowness_s, kSlowness * passed)) * (said - *end_s_);
}

std::optional<double> TimeLeft::left_s(double now_s) const {
    if (!end_s_) return std::nullopt;
    return std::max(0.0, *end_s_ - now_s);
}

QString timeLeftText(double seconds) {
    if (seconds < 1.5) return QCoreApplication::translate("TimeLeft", "1 s left");
    if (seconds < 20) return QCoreApplication::translate("TimeLeft", "%1 s left").arg(std::lround(seconds));
    if (seconds < 57.5)
        return QCoreApplication::translate("TimeLeft", "about %1 s left").arg(5 * std::lround(seconds / 5));
    return QCoreApplication::translate("TimeLeft", "%1 min left")
        .arg(std::max(1L, std::lround(seconds / 60)));
}

}  // namespace vestige
