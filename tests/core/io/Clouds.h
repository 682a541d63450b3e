#pragma once

#include <filesystem>
#include <string>

#include "core/geometry/TriangleMesh.h"
#include "core/io/FormatRegistry.h"

namespace vestige::test {

/// A cloud with every attribute, on a grid of 1 mm at UTM coordinates; `bytes` makes its colours 8 bit.
PointCloud fullCloud(std::size_t points, bool bytes);

/// Reads, and fails the running test with the reader's sentence where that does not work.
LoadedGeometry readOrFail(const std::filesystem::path& file);

/// The largest difference of any coordinate; infinite when the sizes differ.
double largestDifference(const PointCloud& a, const PointCloud& b);

/// Expects the attributes that `b` has to be exactly those of `a`.
void expectSameAttributes(const PointCloud& a, const PointCloud& b);

void writeBytes(const std::filesystem::path& file, std::string_view content);
std::string readBytes(const std::filesystem::path& file);

}  // namespace vestige::test
