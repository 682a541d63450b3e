#include <boost/math/distributions/students_t.hpp>
#include <cmath>

#include "core/measurement/Length.h"

namespace vestige {

double studentQuantile975(double degrees) {
    constexpr double kNormal975 = 1.959963984540054;
    if (!(degrees > 0)) return std::numeric_limits<double>::quiet_NaN();
    if (std::isinf(degrees)) return kNormal975;
    // Below 0.01 degrees the quantile overflows; with n - 1 >= 1 such a nu cannot come from repeats.
    using Overflow = boost::math::policies::policy<
        boost::math::policies::overflow_error<boost::math::policies::ignore_error>>;
    return boost::math::quantile(boost::math::students_t_distribution<double, Overflow>(degrees), 0.975);
}

}  // namespace vestige
