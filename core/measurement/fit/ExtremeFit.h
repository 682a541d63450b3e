#pragma once

#include <optional>
#include <vector>

namespace vestige {

/// The upper end of something that is seen through noise.
struct EndFit {
    double place = 0;
    double standardUncertainty = 0;
    double thickness = 0;  ///< over how far down its points spread: 0 for a layer across the direction
    std::size_t used = 0;
};

/// Values spread evenly over [end - thickness, end], each with Gaussian noise: the most likely end. A flat
/// top has thickness 0 and ends at the mean of its points; an upright surface ends where half of the density
/// is left. Stray values above (their share `strays` of all, spread evenly) do not draw it out. Nothing with
/// fewer than 8 values.
std::optional<EndFit> upperEnd(std::vector<double> values, double noise, double strays = 0.01);

/// The same by the mean over all ends and thicknesses, each weighted by its likelihood, a thickness also by
/// exp(-thickness / noise): steadier than the most likely one where the values do not tell a thick layer from
/// a thin one. Its uncertainty is their standard deviation.
std::optional<EndFit> meanUpperEnd(std::vector<double> values, double noise, double strays = 0.01);

}  // namespace vestige
