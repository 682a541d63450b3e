#pragma once

#include <cmath>

#include "core/scene/MeasuredScene.h"

namespace vestige::test {

/// One row, measured three times or not at all.
inline MeasuredLength measuredRow(std::string object, std::string method, double tape_m,
                                  std::vector<double> repeats_m) {
    MeasuredLength row;
    row.object = std::move(object);
    row.method = std::move(method);
    row.tape_m = tape_m;
    row.tapeUncertainty_m = tapeUncertainty(0.01);
    row.length = lengthStatistic(repeats_m, {0.001, 0.002}, {0.001, 0.002});
    if (row.length) row.re = relativeError(row.length->mean_m, tape_m);
    return row;
}

/// Five objects by LiDAR, the fourth far off (excluded); the second not measurable by photogrammetry.
inline MeasuredScene measuredExample() {
    MeasuredScene scene;
    const double tapes[] = {4.93, 1.84, 0.25, 0.5, 0.65, 0.75, 1.6};
    const char* names[] = {"Length", "Width, \"front\"", "Handle", "Box", "Wheel", "Carton", "Bicycle"};
    std::vector<AccuracyObject> lidar;
    std::vector<AccuracyObject> photo;
    for (int i = 0; i < 7; ++i) {
        const double re = i == 3 ? 0.2 : 0.01 * (i % 2 ? 1 : -1);
        const double length = tapes[i] * (1 + re);
        scene.lengths.push_back(
            measuredRow(names[i], "lidar", tapes[i], {length - 0.001, length, length + 0.001}));
        lidar.push_back({names[i], tapes[i], scene.lengths.back().length->mean_m, {}, false});
        scene.lengths.push_back(
            measuredRow(names[i], "photogrammetry", tapes[i],
                        i == 1 ? std::vector<double>{} : std::vector<double>{tapes[i] * 1.03}));
        if (i == 1) scene.lengths.back().note = "hidden by trees";
        const auto& row = scene.lengths.back();
        photo.push_back(
            {names[i], tapes[i], row.length ? std::optional(row.length->mean_m) : std::nullopt, {}, false});
    }
    scene.accuracy = {methodAccuracy("lidar", lidar), methodAccuracy("photogrammetry", photo)};
    for (auto& row : scene.lengths)
        if (row.object == "Box" && row.method == "lidar") row.excluded = true;
    return scene;
}

}  // namespace vestige::test
