#include "core/registration/adjustment/SignificanceTests.h"

#include <cmath>

namespace vestige {

double chiSquareTail(double x, int degrees) {
    if (!(x > 0)) return 1;
    // exp(-x/2) times the first degrees/2 terms of exp(x/2), scaled together so that nothing overflows.
    double sum = 0;
    double logTerm = -x / 2;
    for (int k = 0; k < degrees / 2; ++k) {
        if (k > 0) logTerm += std::log(x / 2 / k);
        sum += std::exp(logTerm);
    }
    return std::fmin(sum, 1);
}

double chiSquareLimit(double probability, int degrees) {
    double low = 0;
    double high = degrees;
    while (chiSquareTail(high, degrees) > probability) high *= 2;
    for (int halving = 0; halving < 100; ++halving) {
        const double middle = (low + high) / 2;
        (chiSquareTail(middle, degrees) > probability ? low : high) = middle;
    }
    return (low + high) / 2;
}

double fisherTail(double x, int numerator, int denominator) {
    if (!(x > 0)) return 1;
    const int a = denominator / 2;
    const int n = a + numerator / 2 - 1;
    const double share = denominator / (denominator + numerator * x);
    // I_share(a, b) is the chance of at least a successes in n = a + b - 1 trials.
    double sum = 0;
    double logWays = 0;  // of choosing k out of n
    for (int k = n; k >= a; --k) {
        sum += std::exp(logWays + k * std::log(share) + (n - k) * std::log1p(-share));
        logWays += std::log(static_cast<double>(k) / (n - k + 1));
    }
    return std::fmin(sum, 1);
}

}  // namespace vestige
