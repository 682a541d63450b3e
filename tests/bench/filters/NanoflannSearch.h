#pragma once

#include <cstddef>
#include <memory>

#include "core/geometry/PointCloud.h"

namespace vestige {

/// nanoflann's kd-tree of a cloud's offsets, leaves of 10 points (its standard).
class NanoflannSearch {
  public:
    explicit NanoflannSearch(const PointCloud& cloud);
    ~NanoflannSearch();

    /// Every point's `count` nearest, itself included; the sum of all squared distances to the last of them.
    double nearestOfAll(std::size_t count) const;

  private:
    struct Tree;
    std::unique_ptr<Tree> tree_;
};

}  // namespace vestige
