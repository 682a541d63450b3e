#pragma once

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace vestige {

enum class Distribution { normal, rectangular, student };
/// "normal", "rectangular", "t".
std::string_view name(Distribution distribution);

/// One line of an uncertainty budget (GUM 8): what is uncertain, by how much, and what that does to the
/// result.
struct Contribution {
    std::string source;      ///< "repeats", "sensor noise", "point spacing", "registration of front", ...
    double value = 0;        ///< standard uncertainty of the input, in `unit`
    std::string unit;        ///< of the input
    double sensitivity = 1;  ///< of the result to the input, result unit per `unit`
    Distribution distribution = Distribution::normal;
    double degreesOfFreedom = std::numeric_limits<double>::infinity();
    double share = 0;  ///< of the combined variance; filled by `combined`

    /// |c_i| u(x_i), in the unit of the result.
    double part() const;
};

/// An uncertainty with what it is made of. Contributions are independent of each other.
struct Budget {
    std::vector<Contribution> contributions;
    double standard = 0;                                                ///< u, in the unit of the result
    double degreesOfFreedom = std::numeric_limits<double>::infinity();  ///< Welch-Satterthwaite (GUM G.4.1)
    double coverageFactor = 0;                                          ///< t(0.975, nu)
    double expanded = 0;                                                ///< U
};

/// Root of the sum of squares, effective degrees of freedom and shares. Contributions of 0 stay, with a share
/// of 0.
Budget combined(std::vector<Contribution> contributions);

}  // namespace vestige
