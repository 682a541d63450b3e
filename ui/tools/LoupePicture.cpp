#include "ui/tools/LoupePicture.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>
#include <vector>

#include "ui/view/PointColors.h"
#include "ui/view/SceneView.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr std::size_t kMostPoints = 60000;
constexpr float kFar = std::numeric_limits<float>::infinity();

/// What a layer's colours depend on.
struct PainterKey {
    const void* geometry = nullptr;
    const void* residual = nullptr;
    const void* selected = nullptr;
    ColorMode mode = ColorMode::source;
    Overlay overlay = Overlay::none;
    Theme theme = Theme::dark;
    std::array<std::uint8_t, 3> tint{};
    Eigen::Matrix4d pose = Eigen::Matrix4d::Zero();
    double scale = 0, low = 0, high = 0;

    friend bool operator==(const PainterKey&, const PainterKey&) = default;
};

struct KeptPainter {
    PainterKey key;
    PointPainter paint;
};

/// Points of the picture with their depths, nearest on top.
class Canvas {
  public:
    explicit Canvas(int side)
        : side_(side), depth_(static_cast<std::size_t>(side) * side, kFar), color_(depth_.size()) {}

    void disc(double x, double y, double radius, float depth, const Rgba& color) {
        const int left = std::max(0, static_cast<int>(std::ceil(x - radius - 0.5)));
        const int right = std::min(side_ - 1, static_cast<int>(std::floor(x + radius - 0.5)));
        const int top = std::max(0, static_cast<int>(std::ceil(y - radius - 0.5)));
        const int bottom = std::min(side_ - 1, static_cast<int>(std::floor(y + radius - 0.5)));
        for (int row = top; row <= bottom; ++row) {
            for (int column = left; column <= right; ++column) {
                const double dx = column + 0.5 - x;
                const double dy = row + 0.5 - y;
                const std::size_t at = static_cast<std::size_t>(row) * side_ + column;
                if (dx * dx + dy * dy > radius * radius || depth >= depth_[at]) continue;
                depth_[at] = depth;
                color_[at] = color;
            }
        }
    }

    /// Shaded where something near stands before something far, so that shapes show in one colour, too.
    QImage picture(const ViewTheme& theme, int reach, double strength) const {
        QImage image(side_, side_, QImage::Format_RGB32);
        const QColor ground = theme.backgroundBottom;
        for (int row = 0; row < side_; ++row) {
            auto* line = reinterpret_cast<QRgb*>(image.scanLine(row));
            for (int column = 0; column < side_; ++column) {
                const std::size_t at = static_cast<std::size_t>(row) * side_ + column;
                if (depth_[at] == kFar) {
                    line[column] = ground.rgb();
                    continue;
                }
                const double light = std::exp(-strength * drop(row, column, reach));
                const Rgba& c = color_[at];
                const auto lit = [light](std::uint8_t part) { return static_cast<int>(light * part); };
                line[column] = qRgb(lit(c[0]), lit(c[1]), lit(c[2]));
            }
        }
        return image;
    }

  private:
    /// How much nearer the neighbours are, on average, as a share of the depth.
    double drop(int row, int column, int reach) const {
        const float here = depth_[static_cast<std::size_t>(row) * side_ + column];
        double sum = 0;
        for (const auto& [dx, dy] : {std::pair(1, 0), std::pair(-1, 0), std::pair(0, 1), std::pair(0, -1)}) {
            const int x = std::clamp(column + dx * reach, 0, side_ - 1);
            const int y = std::clamp(row + dy * reach, 0, side_ - 1);
            const float there = depth_[static_cast<std::size_t>(y) * side_ + x];
            if (there < here) sum += std::min(0.05, static_cast<double>(here - there) / here);
        }
        return sum / 4;
    }

    int side_;
    std::vector<float> depth_;
    std::vector<Rgba> color_;
};

struct Waiting {
    double depth = 0;
    std::size_t layer = 0;
    std::uint32_t node = 0;
    friend bool operator>(const Waiting& a, const Waiting& b) { return a.depth > b.depth; }
};

/// Where a node lies in the picture, as a disc that holds it.
struct NodePlace {
    double depth;      ///< least
    double radius_px;  ///< of the view; infinite when the viewer is in it
};

class Gathering {
  public:
    Gathering(const ViewDescription& view, const ViewCamera& camera, const QPointF& centre, double half_px,
              double fine_px)
        : view_(view), camera_(camera), centre_(centre.x(), centre.y()), half_(half_px), fine_(fine_px) {
        if (view.section) clips_ = view.section->region();
        for (const ViewLayer& layer : view.layers) {
            // Flags of other points than the octree's are there for a moment at most.
            const bool fits =
                layer.hidden && layer.octree && layer.hidden->size() == layer.octree->cloud().size();
            hidden_.push_back(fits ? layer.hidden.get() : nullptr);
        }
    }

    /// Calls `sink(layer, point, pixel, depth)` for the points in the square, near boxes first.
    template <class Sink>
    void run(const Sink& sink) const {
        std::priority_queue<Waiting, std::vector<Waiting>, std::greater<>> waiting;
        const auto enter = [&](std::size_t layer, std::uint32_t node) {
            if (const auto place = placeOf(layer, node)) waiting.push({place->depth, layer, node});
        };
        for (std::size_t i = 0; i < view_.layers.size(); ++i) {
            const ViewLayer& layer = view_.layers[i];
            if (layer.visible && layer.octree && !layer.octree->nodes().empty()) enter(i, 0);
        }
        std::size_t left = kMostPoints;
        while (!waiting.empty() && left > 0) {
            const Waiting next = waiting.top();
            waiting.pop();
            const Octree& octree = *view_.layers[next.layer].octree;
            const Octree::Node& node = octree.nodes()[next.node];
            const auto place = placeOf(next.layer, next.node);
            const bool tiny = place && place->radius_px < fine_;
            // Of a tiny one the first point stands for all, if it is seen; else one of its parts has it.
            if (tiny && node.childCount > 0 && show(next.layer, octree.order()[node.begin], sink)) {
                --left;
                continue;
            }
            for (std::uint32_t child = 0; child < node.childCount; ++child)
                enter(next.layer, node.firstChild + child);
            if (node.childCount > 0) {
                --left;
                continue;
            }
            for (std::uint32_t at = node.begin; at < node.end && left > 0; ++at, --left)
                if (show(next.layer, octree.order()[at], sink) && tiny) break;
        }
    }

  private:
    std::optional<NodePlace> placeOf(std::size_t index, std::uint32_t number) const {
        const ViewLayer& layer = view_.layers[index];
        const Octree::Node& node = layer.octree->nodes()[number];
        const Eigen::Vector3d middle = 0.5 * (node.min + node.max).cast<double>();
        const Eigen::Vector3d world = layer.worldFromLayer * (layer.octree->cloud().origin() + middle);
        const double radius =
            0.5 * layer.worldFromLayer.scale * static_cast<double>((node.max - node.min).norm());
        if (kept(clips_, Eigen::Matrix3d::Identity(), world, Eigen::Vector3d::Zero(),
                 Eigen::Vector3d::Constant(radius)) == Kept::none)
            return std::nullopt;
        const double depth = (world - camera_.position).dot(camera_.direction());
        if (!camera_.parallel && depth + radius <= 0) return std::nullopt;
        const double nearest = depth - radius;
        const auto seen = camera_.project(world);
        if (!seen || (!camera_.parallel && nearest <= 1e-6))
            return NodePlace{nearest, std::numeric_limits<double>::infinity()};
        const double pixels = radius / camera_.metresPerPixel(nearest);
        if ((seen->pixel - centre_).cwiseAbs().maxCoeff() > half_ + pixels) return std::nullopt;
        return NodePlace{nearest, pixels};
    }

    /// Whether it is in the square and not hidden or cut away.
    template <class Sink>
    bool show(std::size_t index, std::uint32_t point, const Sink& sink) const {
        const ViewLayer& layer = view_.layers[index];
        if (hidden_[index] && (*hidden_[index])[point]) return false;
        const Eigen::Vector3d world = layer.worldFromLayer * layer.octree->cloud().point(point);
        const auto seen = camera_.project(world);
        if (!seen || (seen->pixel - centre_).cwiseAbs().maxCoeff() > half_) return false;
        if (!clips_.keeps(world)) return false;
        sink(index, point, seen->pixel, seen->depth_m);
        return true;
    }

    const ViewDescription& view_;
    const ViewCamera& camera_;
    Eigen::Vector2d centre_;
    double half_;
    double fine_;
    ClipRegion clips_;
    std::vector<const std::vector<std::uint8_t>*> hidden_;
};

}  // namespace

struct LoupePicture::Private {
    std::vector<KeptPainter> painters;

    const PointPainter& painter(const ViewDescription& view, std::size_t index,
                                const std::optional<ColorScale>& scale) {
        const ViewLayer& layer = view.layers[index];
        const PainterKey key{layer.geometry.get(),
                             layer.residual_m.get(),
                             layer.selected.get(),
                             view.colorMode,
                             view.overlay,
                             view.theme,
                             layer.tint,
                             layer.worldFromLayer.pose.matrix(),
                             layer.worldFromLayer.scale,
                             scale ? scale->low : 0,
                             scale ? scale->high : 0};
        if (painters.size() <= index) painters.resize(index + 1);
        if (!painters[index].paint || !(painters[index].key == key))
            painters[index] = {key, pointPainter(view, index, scale)};
        return painters[index].paint;
    }
};

LoupePicture::LoupePicture() : d_(std::make_unique<Private>()) {}
LoupePicture::~LoupePicture() = default;

QImage LoupePicture::draw(const SceneView& view, const QPointF& centre, double magnification, int side_px) {
    const ViewDescription& shown = view.description();
    d_->painters.resize(shown.layers.size());
    Canvas canvas(side_px);
    const double half = 0.5 * side_px / magnification;
    // Smaller than enlarged pixels, so that points stand apart; never so small that they get lost.
    const double radius = std::max(2.0, 0.3 * magnification * shown.pointSize_px);
    const double margin = radius / magnification;
    Gathering(shown, view.camera(), centre, half + margin, 0.6 * margin)
        .run([&](std::size_t layer, std::uint32_t point, const Eigen::Vector2d& pixel, double depth) {
            canvas.disc(magnification * (pixel.x() - centre.x()) + 0.5 * side_px,
                        magnification * (pixel.y() - centre.y()) + 0.5 * side_px, radius,
                        static_cast<float>(depth), d_->painter(shown, layer, view.scale())(point));
        });
    const int reach = std::max(1, static_cast<int>(0.6 * radius));
    return canvas.picture(viewTheme(shown.theme), reach, shown.eyeDomeLighting ? 60 : 0);
}

}  // namespace vestige
