#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "core/simulation/SurfaceModel.h"

namespace vestige {

/// Puts a SurfaceModel together from simple pieces. Every piece takes the part and material set last.
class ModelBuilder {
  public:
    using Point = Eigen::Vector3d;

    ModelBuilder& part(const std::string& name);
    ModelBuilder& material(Material material) {
        material_ = material;
        return *this;
    }

    void triangle(const Point& a, const Point& b, const Point& c);
    /// Corners in order round the face; it need not be flat.
    void quad(const Point& a, const Point& b, const Point& c, const Point& d);
    /// The surface at(row, column) over 0..rows x 0..columns; faces keep the material set, or what
    /// `materialAt` says for the cell.
    void grid(int rows, int columns, const std::function<Point(int, int)>& at,
              const std::function<Material(int, int)>& materialAt = {});
    /// A box of full size `size` with axis-parallel sides.
    void box(const Point& centre, const Point& size);
    /// A round bar from a to b, closed at both ends.
    void tube(const Point& a, const Point& b, double radiusA, double radiusB, int segments);
    void tube(const Point& a, const Point& b, double radius, int segments = 10) {
        tube(a, b, radius, radius, segments);
    }
    /// The profile (radius, height along the axis) turned round the axis. `segments` a multiple of 4 puts
    /// vertices exactly on `reference`, its opposite, and at right angles to it.
    void lathe(const Point& centre, const Point& axis, const Point& reference,
               const std::vector<std::pair<double, double>>& profile, int segments);
    void feature(const std::string& name, const Point& position, const Point& lookFrom,
                 const std::string& snap = {});
    void light(const Point& position) { model_.lights.push_back(position); }
    void append(const SurfaceModel& other, const Pose& hereFromOther, const std::string& prefix) {
        model_.append(other, hereFromOther, prefix);
    }

    SurfaceModel take() { return std::move(model_); }

  private:
    SurfaceModel model_;
    std::uint16_t part_ = 0;
    Material material_ = Material::plastic;
};

}  // namespace vestige
