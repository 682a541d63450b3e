#include <nlohmann/json.hpp>

#include "core/scene/casefile/CaseJson.h"

namespace vestige {
namespace {

template <int Rows, int Columns>
Eigen::Matrix<double, Rows, Columns> readNumbers(const JsonCursor& cursor, std::string_view what) {
    const auto values = cursor.elements(Rows * Columns, what);
    Eigen::Matrix<double, Rows, Columns> matrix;
    for (int row = 0; row < Rows; ++row)
        for (int column = 0; column < Columns; ++column)
            matrix(row, column) = values[static_cast<std::size_t>(Columns * row + column)].real();
    return matrix;
}

std::size_t readCount(const JsonCursor& cursor) {
    constexpr std::int64_t kMost = std::int64_t{1} << 53;
    return static_cast<std::size_t>(cursor.integer(0, kMost));
}

ResidualHistogram readHistogram(const JsonCursor& cursor) {
    ResidualHistogram histogram;
    histogram.width_m = cursor.at("width_m").real();
    for (const auto& count : cursor.at("counts").elements()) histogram.counts.push_back(readCount(count));
    if (histogram.counts.size() % 2 == 0 && !histogram.counts.empty())
        cursor.at("counts").reject("there are " + std::to_string(histogram.counts.size()) + " bins here",
                                   "expected an odd number of them");
    histogram.outside = readCount(cursor.at("outside"));
    return histogram;
}

RestartSpread readRestarts(const JsonCursor& cursor) {
    constexpr std::int64_t kMostRuns = 1000000;
    return {static_cast<int>(cursor.at("runs").integer(0, kMostRuns)),
            static_cast<int>(cursor.at("agreeing").integer(0, kMostRuns)), cursor.at("translation_m").real(),
            cursor.at("rotation_rad").real()};
}

}  // namespace

RegistrationQuality readQuality(const JsonCursor& cursor) {
    RegistrationQuality quality;
    quality.residuals = readHistogram(cursor.at("residual_histogram"));
    quality.planeRmse_m = cursor.at("plane_rmse_m").real();
    quality.restarts = readRestarts(cursor.at("restarts"));
    for (const auto& one : cursor.at("observability").elements())
        quality.directions.push_back(
            {one.at("information").real(), readNumbers<6, 1>(one.at("direction"), "six numbers"),
             one.at("sigma_m").real(), one.at("free").boolean(), one.at("words").text()});
    quality.radius_m = cursor.at("radius_m").real();
    quality.uncertainty.covariance =
        readNumbers<6, 6>(cursor.at("covariance"), "36 numbers, the 6x6 matrix row by row");
    quality.uncertainty.pivot_m = cursor.at("pivot_m").vector3();
    return quality;
}

}  // namespace vestige
