#include "ui/view/SceneDrawing.h"

#include <vtkActor.h>
#include <vtkCullerCollection.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "core/pipeline/FrameView.h"
#include "ui/view/MeshActor.h"
#include "ui/view/PicturePass.h"
#include "ui/view/PointColors.h"
#include "ui/view/PointProp.h"
#include "ui/view/PointStore.h"
#include "ui/view/ViewTheme.h"
#include "ui/view/VtkCamera.h"

namespace vestige {
namespace {

/// What the colours of a layer's points depend on.
struct ColorKey {
    ColorMode mode;
    Overlay overlay;
    Theme theme;
    Rgb tint;
    std::shared_ptr<const std::vector<float>> residuals;
    double low;
    double high;
    std::optional<std::array<double, 16>> pose;  ///< where colours are by height
    std::shared_ptr<const std::vector<std::uint8_t>> selected;
    std::shared_ptr<const std::vector<std::uint8_t>> hidden;
    bool operator==(const ColorKey&) const = default;
};

bool byHeight(const ViewDescription& view) {
    return view.overlay == Overlay::none && view.colorMode == ColorMode::height;
}

/// Moved in the display frame, points keep their digits while they are this near to its origin, metres.
constexpr double kNearOrigin_m = 1000;
constexpr double kLeastPull_m = 0.1;  // over the noise of a target from the air
constexpr double kMostPull_m = 0.4;

Eigen::Vector3f toVector(const QColor& color) {
    return {static_cast<float>(color.redF()), static_cast<float>(color.greenF()),
            static_cast<float>(color.blueF())};
}

bool samePlace(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

/// A layer in the VTK scene: a point prop or a mesh actor.
struct Drawn {
    std::shared_ptr<const TriangleMesh> geometry;
    Similarity built;  ///< worldFromLayer that the positions were made with
    BoundingBox box;   ///< world, as built
    std::array<ViewSide, 2> sides;
    vtkSmartPointer<PointProp> points;
    vtkSmartPointer<vtkActor> mesh;
    std::optional<ColorKey> colors;
    bool visible = false;

    /// World motion from where it was built to where it lies in a picture.
    Similarity motion(int picture) const {
        const Similarity& wanted = sides[picture].worldFromLayer;
        if (samePlace(wanted, built)) return {};
        return {wanted.pose * built.pose.inverse(), wanted.scale / built.scale};
    }
    vtkProp* prop() const { return points ? static_cast<vtkProp*>(points) : mesh; }
};

}  // namespace

struct SceneDrawing::Private {
    vtkRenderWindow& window;
    std::shared_ptr<PointStore> store;
    std::size_t wholeBelow;
    vtkNew<vtkOpenGLRenderer> renderer;
    vtkNew<PicturePass> pass;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world; of everything in the VTK scene
    std::vector<Drawn> layers;                         ///< as in the description
    std::optional<ColorScale> scale;
    double share = 0;
    std::size_t wanted = 0;
    bool compares = false;

    Private(vtkRenderWindow& shown, std::size_t mostHeld, std::size_t whole)
        : window(shown),
          // A block at least, or it could not be drawn.
          store(std::make_shared<PointStore>(std::max<std::size_t>(mostHeld, PointBlocks::kSize))),
          wholeBelow(whole) {}

    bool nearOrigin(const BoundingBox& box) const {
        return (box.centre() - origin).norm() + box.diagonal() < kNearOrigin_m;
    }

    /// Whether `drawn` can show the layer without being built again.
    bool holds(const Drawn& drawn, const ViewLayer& layer) const {
        if (drawn.geometry != layer.geometry) return false;
        if (samePlace(drawn.built, layer.worldFromLayer)) return true;
        const Similarity motion{layer.worldFromLayer.pose * drawn.built.pose.inverse(), 1};
        return drawn.built.scale == layer.worldFromLayer.scale && nearOrigin(drawn.box) &&
               nearOrigin(drawn.box.transformed(motion));
    }

    /// Moves what a prop shows to where it lies in one of the two pictures.
    bool prepare(vtkProp& prop, int picture) {
        const auto found = std::find_if(layers.begin(), layers.end(),
                                        [&](const Drawn& drawn) { return drawn.prop() == &prop; });
        if (found == layers.end() || !found->sides[picture].visible) return false;
        const Similarity motion = found->motion(picture);
        Eigen::Matrix4d display = Eigen::Matrix4d::Identity();
        display.topLeftCorner<3, 3>() = motion.scale * motion.pose.linear();
        display.topRightCorner<3, 1>() = motion * origin - origin;
        if (motion.isIdentity()) display.setIdentity();
        if (found->points) {
            found->points->setMotion(display.cast<float>());
        } else {
            vtkNew<vtkMatrix4x4> matrix;
            for (int i = 0; i < 16; ++i) matrix->SetElement(i / 4, i % 4, display(i / 4, i % 4));
            found->mesh->SetUserMatrix(matrix);
        }
        return true;
    }

    void placeOrigin(const ViewDescription& view) {
        const BoundingBox box = subjectBounds(view);
        if (box.empty()) return;
        const bool near = (origin - box.centre()).norm() <= std::max(100.0, box.diagonal());
        if (near && !layers.empty()) return;
        clear();
        origin = box.centre().array().round();
    }

    void clear() {
        for (const Drawn& drawn : layers) remove(drawn);
        layers.clear();
    }

    void remove(const Drawn& drawn) {
        if (drawn.prop()) renderer->RemoveViewProp(drawn.prop());
    }

    Drawn add(const ViewLayer& layer) {
        Drawn drawn;
        drawn.geometry = layer.geometry;
        drawn.built = layer.worldFromLayer;
        if (!layer.geometry || layer.geometry->vertices.empty()) return drawn;
        drawn.box = layer.geometry->vertices.bounds().transformed(layer.worldFromLayer);
        if (layer.geometry->isMesh()) {
            drawn.mesh = makeMeshActor(*layer.geometry, layer.worldFromLayer, origin);
        } else {
            const std::shared_ptr<const PointCloud> cloud(layer.geometry, &layer.geometry->vertices);
            const bool usable = layer.octree && &layer.octree->cloud() == cloud.get();
            auto octree = usable ? layer.octree : std::make_shared<const Octree>(cloud);
            drawn.points = vtkSmartPointer<PointProp>::New();
            drawn.points->setPoints(cloud, PointBlocks(std::move(octree), layer.worldFromLayer),
                                    layer.worldFromLayer, origin, store);
        }
        renderer->AddViewProp(drawn.prop());
        return drawn;
    }

    /// Half of what is coloured by its distance lies behind the target's surface; it is drawn as if it lay
    /// before it, or one sign of the distances would be hidden.
    double pullOf(const ViewDescription& view, const ViewLayer& layer) const {
        if (view.overlay != Overlay::residual || !layer.residual_m || !scale) return 0;
        return std::clamp(4 * scale->high, kLeastPull_m, kMostPull_m);
    }

    void color(Drawn& drawn, const ViewDescription& view, std::size_t index) {
        const ViewLayer& layer = view.layers[index];
        const ColorKey key{view.colorMode,
                           view.overlay,
                           view.theme,
                           layerTint(view, index),
                           layer.residual_m,
                           scale ? scale->low : 0,
                           scale ? scale->high : 0,
                           byHeight(view) ? std::optional(rowMajor(layer.worldFromLayer.pose)) : std::nullopt,
                           layer.selected,
                           layer.hidden};
        if (drawn.colors == key) return;
        drawn.colors = key;
        if (drawn.mesh) return setVertexColors(*drawn.mesh, pointColors(view, index, scale));
        drawn.points->setPainter(pointPainter(view, index, scale));
    }

    /// Room in the store for all there is, as far as it goes; none where there are no points.
    void reserve() {
        std::size_t pages = 0;
        for (const Drawn& drawn : layers)
            if (drawn.points)
                for (const PointBlock& block : drawn.points->blocks())
                    pages += (block.size() + PointStore::kPage - 1) / PointStore::kPage;
        if (pages > 0) return store->reserve(pages);
        window.MakeCurrent();  // or another window's buffer of the same number would go
        store->release();
    }

    /// Calls `visit(prop, block, page)` for the pages that the part [from, to) of the picture needs, the
    /// first page of each block first; ends when it returns false.
    template <class Visit>
    void visitPages(double from, double to, const Visit& visit) const {
        constexpr std::uint32_t kPages = PointBlocks::kSize / PointStore::kPage;
        bool any = true;
        for (std::uint32_t page = 0; page < kPages && any; ++page) {
            any = false;
            for (const Drawn& drawn : layers) {
                if (!drawn.points || !drawn.visible) continue;
                const std::vector<std::uint32_t>& many = drawn.points->wanted();
                for (std::size_t block = 0; block < many.size(); ++block) {
                    if (many[block] == 0) continue;
                    any = any || page * PointStore::kPage < rankRange(many[block], from, to).last;
                    if (drawn.points->needsPage(block, page, from, to)) visit(*drawn.points, block, page);
                }
            }
        }
    }

    void setParts(double from, double to, bool whole, bool meshes) {
        for (const Drawn& drawn : layers) {
            if (drawn.points) drawn.points->setPart(from, to, whole);
            if (drawn.mesh) drawn.mesh->SetVisibility(meshes && drawn.visible);
        }
    }
};

SceneDrawing::SceneDrawing(vtkRenderWindow& window, std::size_t mostHeld, std::size_t wholeBelow)
    : d_(std::make_unique<Private>(window, mostHeld, wholeBelow)) {
    d_->renderer->SetPass(d_->pass);
    d_->renderer->SetBackground(0, 0, 0);
    // VTK would leave out what the first picture does not show; setCamera() decides for both.
    d_->renderer->GetCullers()->RemoveAllItems();
    d_->pass->setRelease([store = d_->store] { store->release(); });
    d_->pass->setPrepare([this](vtkProp& prop, int picture) { return d_->prepare(prop, picture); });
    window.AddRenderer(d_->renderer);
}

SceneDrawing::~SceneDrawing() {
    d_->window.MakeCurrent();
    d_->window.RemoveRenderer(d_->renderer);
}

void SceneDrawing::show(const ViewDescription& view) {
    d_->placeOrigin(view);
    d_->scale = colorScale(view);
    std::vector<Drawn> before = std::move(d_->layers);
    d_->layers.clear();
    for (std::size_t i = 0; i < view.layers.size(); ++i) {
        const ViewLayer& layer = view.layers[i];
        const auto known = std::find_if(before.begin(), before.end(),
                                        [&](const Drawn& drawn) { return d_->holds(drawn, layer); });
        if (known != before.end()) {
            d_->layers.push_back(std::move(*known));
            before.erase(known);
        } else {
            d_->layers.push_back(d_->add(layer));
        }
        Drawn& drawn = d_->layers.back();
        if (!drawn.prop()) continue;
        const ViewSide own{layer.worldFromLayer, layer.visible};
        drawn.sides = {own,
                       view.comparison ? layer.other.value_or(own) : ViewSide{own.worldFromLayer, false}};
        drawn.visible = drawn.sides[0].visible || drawn.sides[1].visible;
        drawn.prop()->SetVisibility(drawn.visible);
        if (drawn.visible) d_->color(drawn, view, i);
        if (drawn.points) {
            drawn.points->setPointSize(view.pointSize_px);
            drawn.points->setPull(d_->pullOf(view, layer));
        }
    }
    for (const Drawn& drawn : before) d_->remove(drawn);
    before.clear();
    d_->reserve();
    d_->pass->setEyeDomeLighting(view.eyeDomeLighting);
    const ViewTheme theme = viewTheme(view.theme);
    d_->pass->setBackground(toVector(theme.backgroundTop), toVector(theme.backgroundBottom));
    d_->compares = view.comparison.has_value();
    if (view.comparison)
        setComparison(*view.comparison);
    else
        d_->pass->setMix(PicturePass::Mix::none, 0, 1);
}

void SceneDrawing::setComparison(const ViewComparison& comparison) {
    if (!d_->compares) return;
    using Mix = PicturePass::Mix;
    const Mix mix = comparison.mode == CompareMode::swipe          ? Mix::swipe
                    : comparison.mode == CompareMode::checkerboard ? Mix::checkerboard
                    : comparison.otherShown                        ? Mix::other
                                                                   : Mix::own;
    d_->pass->setMix(mix, static_cast<float>(comparison.divider), comparison.tile_px);
}

void SceneDrawing::setCamera(const ViewCamera& camera) {
    std::optional<DepthRange> range;
    const double slope =
        camera.parallel ? 0 : 2 * std::tan(0.5 * camera.verticalAngle_rad) / camera.height_px;
    const double parallel = 2 * camera.halfHeight_m / camera.height_px;
    /// Metres a pixel where the box is nearest in one of the pictures; nothing where it is in none.
    const auto finestSeen = [&](const BoundingBox& built, const std::vector<Similarity>& motions) {
        std::optional<double> finest;
        for (const Similarity& motion : motions) {
            const BoundingBox box = motion.isIdentity() ? built : built.transformed(motion);
            const auto seen = depthsSeen(camera, box.min, box.max);
            if (!seen) continue;
            range = range ? DepthRange{std::min(range->nearest, seen->nearest),
                                       std::max(range->farthest, seen->farthest)}
                          : *seen;
            const double here = camera.parallel ? parallel : std::max(0.0, slope * seen->nearest);
            finest = finest ? std::min(*finest, here) : here;
        }
        return finest;
    };
    std::size_t seenPoints = 0;
    std::vector<std::pair<PointProp*, std::vector<std::optional<double>>>> seen;
    for (Drawn& drawn : d_->layers) {
        if (!drawn.visible) continue;
        std::vector<Similarity> motions;
        for (int picture = 0; picture < 2; ++picture)
            if (drawn.sides[picture].visible) motions.push_back(drawn.motion(picture));
        if (drawn.mesh) {
            finestSeen(drawn.box, motions);
            continue;
        }
        auto& [points, finest] = seen.emplace_back(drawn.points.Get(), std::vector<std::optional<double>>());
        for (const PointBlock& block : points->blocks()) {
            finest.push_back(finestSeen(block.box, motions));
            if (finest.back()) seenPoints += block.size();
        }
    }
    d_->wanted = 0;
    for (const auto& [points, finest] : seen) {
        std::vector<std::uint32_t> wanted(finest.size(), 0);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (!finest[i]) continue;
            const PointBlock& block = points->blocks()[i];
            wanted[i] = seenPoints <= d_->wholeBelow ? block.size() : pointsWorthDrawing(block, *finest[i]);
            d_->wanted += wanted[i];
        }
        points->setWanted(std::move(wanted));
    }
    setVtkCamera(*d_->renderer->GetActiveCamera(), camera, d_->origin, range.value_or(DepthRange{1, 2}));
}

std::size_t SceneDrawing::pointsWanted() const {
    return d_->wanted;
}

std::uint64_t SceneDrawing::pointsUploaded() const {
    return d_->store->uploadedPoints();
}

std::size_t SceneDrawing::pointsHeld() const {
    return d_->store->pagesHeld() * PointStore::kPage;
}

double SceneDrawing::shareWithin(double from, double to, std::size_t most) const {
    const auto missing = [&](double until) {
        std::size_t pages = 0;
        for (const Drawn& drawn : d_->layers)
            if (drawn.points && drawn.visible) pages += drawn.points->pagesMissing(from, until);
        return pages * PointStore::kPage;
    };
    double until = to;
    for (int halving = 0; halving < 12 && missing(until) > most; ++halving) until = 0.5 * (from + until);
    return until;
}

void SceneDrawing::beginPicture(double share) {
    d_->pass->restart();
    d_->share = share;
    d_->setParts(0, share, true, true);
}

bool SceneDrawing::beginPassingPicture(double share, std::size_t most) {
    d_->pass->restart();
    d_->share = share;
    d_->setParts(0, share, false, true);
    d_->store->begin();
    std::map<PointProp*, std::vector<PointProp::Page>> missing;
    std::size_t points = 0;
    bool all = true;
    d_->visitPages(0, share, [&](PointProp& prop, std::size_t block, std::uint32_t page) {
        if (prop.touchPage(block, page)) return;
        all = all && points < most;
        if (points >= most) return;
        points += PointStore::kPage;
        missing[&prop].push_back({block, page});
    });
    for (auto& [prop, pages] : missing) all = prop->bring(pages) && all;
    return all;
}

void SceneDrawing::addToPicture(double share) {
    d_->setParts(d_->share, share, true, false);
    d_->share = share;
}

const std::optional<ColorScale>& SceneDrawing::scale() const {
    return d_->scale;
}

}  // namespace vestige
