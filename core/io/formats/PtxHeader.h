#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/io/ReadJob.h"
#include "core/io/TextScanner.h"

namespace vestige {

/// What stands before each scan of a PTX file: the size of its grid, the scanner's place and axes, and the
/// 4x4 transform, row by row, that takes a row vector (x y z 1) of the scan into the file's frame.
struct PtxHeader {
    std::uint64_t columns = 0;
    std::uint64_t rows = 0;
    Eigen::Vector3d scanner = Eigen::Vector3d::Zero();
    Eigen::Matrix3d linear =
        Eigen::Matrix3d::Identity();  ///< of column vectors: file = linear * scan + shift
    Eigen::Vector3d shift = Eigen::Vector3d::Zero();

    std::uint64_t points() const { return columns * rows; }
};

/// Reads one header; blank lines before it are passed over. Refuses, at its line, what is none, and a grid
/// that the rest of a text of `textSize` bytes has no room for, unless `salvage`.
PtxHeader readPtxHeader(TextScanner& scanner, std::size_t textSize, bool salvage, const ReadJob& job);

/// True when the text begins as a PTX file does: two lines with a whole number each, four with three numbers,
/// four with four.
bool looksLikePtx(std::string_view head);

}  // namespace vestige
