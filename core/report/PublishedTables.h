#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace vestige {

/// One row of table 2 or 3 of Zhang, Guan, Liu, Zhang: Digital Reconstruction Method for Low-Illumination
/// Road Traffic Accident Scenes Using UAV and Auxiliary Equipment, World Electr. Veh. J. 2025, 16(3), 171
/// (CC BY 4.0): the pavilion sequences of the ETH ASL data sets, i7-12900K, PCL 1.8.1.
struct PublishedRow {
    std::string_view method;  ///< "ndt", "improved-ndt", as in registrationParameters()
    std::string_view filter;  ///< "none" in table 2
    double voxel_m;
    double seconds;
    double rpe_m;
};

/// The rows of table 2 or 3; none of another.
std::span<const PublishedRow> publishedTable(int table);

/// The row of a table for this method, filter and voxel.
std::optional<PublishedRow> publishedRow(int table, std::string_view method, std::string_view filter,
                                         double voxel_m);

}  // namespace vestige
