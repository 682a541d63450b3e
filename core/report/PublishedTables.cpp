#include "core/report/PublishedTables.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace vestige {
namespace {

constexpr std::array<PublishedRow, 12> kTable2{{{"ndt", "none", 1.0, 6.15, 0.67},
                                                {"ndt", "none", 0.8, 6.71, 0.58},
                                                {"ndt", "none", 0.6, 7.44, 0.61},
                                                {"ndt", "none", 0.4, 9.13, 0.55},
                                                {"ndt", "none", 0.2, 12.87, 0.45},
                                                {"ndt", "none", 0.1, 15.86, 0.43},
                                                {"improved-ndt", "none", 1.0, 6.82, 0.62},
                                                {"improved-ndt", "none", 0.8, 7.69, 0.59},
                                                {"improved-ndt", "none", 0.6, 8.35, 0.55},
                                                {"improved-ndt", "none", 0.4, 9.75, 0.50},
                                                {"improved-ndt", "none", 0.2, 14.15, 0.39},
                                                {"improved-ndt", "none", 0.1, 18.26, 0.36}}};

constexpr std::array<PublishedRow, 9> kTable3{{{"improved-ndt", "gaussian", 0.1, 20.38, 0.32},
                                               {"improved-ndt", "mean", 0.1, 20.62, 0.36},
                                               {"improved-ndt", "median", 0.1, 21.12, 0.35},
                                               {"improved-ndt", "gaussian", 0.2, 15.54, 0.34},
                                               {"improved-ndt", "mean", 0.2, 15.83, 0.37},
                                               {"improved-ndt", "median", 0.2, 16.11, 0.38},
                                               {"improved-ndt", "gaussian", 0.3, 10.21, 0.45},
                                               {"improved-ndt", "mean", 0.3, 10.74, 0.48},
                                               {"improved-ndt", "median", 0.3, 11.38, 0.51}}};

}  // namespace

std::span<const PublishedRow> publishedTable(int table) {
    if (table == 2) return kTable2;
    if (table == 3) return kTable3;
    return {};
}

std::optional<PublishedRow> publishedRow(int table, std::string_view method, std::string_view filter,
                                         double voxel_m) {
    const auto rows = publishedTable(table);
    const auto found = std::find_if(rows.begin(), rows.end(), [&](const PublishedRow& row) {
        return row.method == method && row.filter == filter && std::abs(row.voxel_m - voxel_m) < 1e-9;
    });
    return found == rows.end() ? std::nullopt : std::optional(*found);
}

}  // namespace vestige
