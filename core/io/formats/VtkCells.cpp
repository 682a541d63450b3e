#include "core/io/formats/VtkCells.h"

namespace vestige {

bool VtkCells::isSection(const std::string& key) {
    return key == "VERTICES" || key == "LINES" || key == "POLYGONS" || key == "TRIANGLE_STRIPS" ||
           key == "CELLS";
}

void VtkCells::read(const std::string& key, std::size_t points) {
    section_ = key;
    points_ = points;
    if (key == "LINES" || key == "TRIANGLE_STRIPS") job_.warn("not kept: " + key);
    const std::size_t first = values_.count();
    const std::size_t second = values_.count();
    const TextScanner before = values_.place();
    if (values_.keyword() == "OFFSETS") {
        readSplit(first, second);
    } else {
        values_.returnTo(before);
        readJoined(first, second);
    }
}

/// Each cell is its length, then its points.
void VtkCells::readJoined(std::size_t cells, std::size_t numbers) {
    values_.beginArray(numbers, ScalarType::int32);
    std::size_t used = 0;
    for (std::size_t cell = 0; cell < cells; ++cell) {
        job_.step(cell, cells);
        const double length = used < numbers ? values_.value(ScalarType::int32) : -1;
        ++used;
        if (!(length >= 0 && length <= static_cast<double>(numbers - used)))
            values_.refuse("a cell is longer than its section",
                           "cells of " + std::to_string(numbers) + " numbers");
        used += static_cast<std::size_t>(length);
        corners_.resize(static_cast<std::size_t>(length));
        for (double& corner : corners_) corner = values_.value(ScalarType::int32);
        take();
    }
}

/// Version 5: where each cell ends, then the points of all.
void VtkCells::readSplit(std::size_t offsets, std::size_t connections) {
    const ScalarType offsetType = values_.type();
    values_.beginArray(offsets, offsetType);
    std::vector<double> ends(offsets);
    for (double& end : ends) end = values_.value(offsetType);
    if (values_.keyword() != "CONNECTIVITY") values_.refuse("CONNECTIVITY is missing", "it after OFFSETS");
    const ScalarType type = values_.type();
    values_.beginArray(connections, type);
    std::size_t used = 0;
    for (std::size_t cell = 1; cell < ends.size(); ++cell) {
        job_.step(cell, ends.size());
        if (!(ends[cell] >= static_cast<double>(used) && ends[cell] <= static_cast<double>(connections)))
            values_.refuse("an offset of a cell is out of order", "offsets that grow up to the connectivity");
        corners_.resize(static_cast<std::size_t>(ends[cell]) - used);
        used += corners_.size();
        for (double& corner : corners_) corner = values_.value(type);
        take();
    }
    for (; used < connections; ++used) values_.value(type);
}

void VtkCells::take() {
    if (section_ == "POLYGONS") add(corners_);
    if (section_ != "CELLS") return;
    gridLengths_.push_back(corners_.size());
    gridCorners_.insert(gridCorners_.end(), corners_.begin(), corners_.end());
}

void VtkCells::add(const Corners& corners) {
    std::vector<std::uint32_t> polygon;
    for (const double index : corners) {
        if (!(index >= 0 && index < static_cast<double>(points_)))
            values_.refuse("a polygon names a point that is not there",
                           "an index from 0 to " + std::to_string(points_) + " - 1");
        polygon.push_back(static_cast<std::uint32_t>(index));
    }
    polygons_.add(polygon);
}

void VtkCells::readTypes(std::size_t points) {
    constexpr double kTriangle = 5, kPolygon = 7, kQuad = 9;
    points_ = points;
    const std::size_t count = values_.count();
    values_.beginArray(count, ScalarType::int32);
    auto corner = gridCorners_.begin();
    for (std::size_t i = 0; i < count; ++i) {
        const double type = values_.value(ScalarType::int32);
        if (i >= gridLengths_.size()) continue;
        const auto end = corner + static_cast<std::ptrdiff_t>(gridLengths_[i]);
        if (type == kTriangle || type == kPolygon || type == kQuad) add(Corners(corner, end));
        corner = end;
    }
}

}  // namespace vestige
