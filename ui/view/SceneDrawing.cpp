#include "ui/view/SceneDrawing.h"

#include <vtkActor.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPlane.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkRendererCollection.h>

#include <QRectF>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/pipeline/FrameView.h"
#include "ui/view/MeshActor.h"
#include "ui/view/PaneDrawing.h"
#include "ui/view/PointColors.h"
#include "ui/view/PointProp.h"
#include "ui/view/PointStore.h"
#include "ui/view/SampledRange.h"
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

/// A scene wider than this has strays.
constexpr double kWidest_m = 20000;
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
    std::vector<std::unique_ptr<PaneDrawing>> panes;
    std::size_t used = 0;  ///< of the panes
    std::optional<SectionBox> section;
    Eigen::Vector3d origin = Eigen::Vector3d::Zero();  ///< world; of everything in the VTK scene
    std::vector<Drawn> layers;                         ///< as in the description
    std::optional<ColorScale> scale;
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

    PaneDrawing& pane() { return *panes[used]; }

    /// Moves what a prop shows to where it lies in one of the two pictures, and sets how much of it a pane
    /// draws.
    bool prepare(vtkProp& prop, int picture, const PaneDrawing& pane) {
        if (&prop == &const_cast<PaneDrawing&>(pane).grid.actor()) return pane.meshes;
        const auto found = std::find_if(layers.begin(), layers.end(),
                                        [&](const Drawn& drawn) { return drawn.prop() == &prop; });
        if (found == layers.end() || !found->sides[picture].visible) return false;
        if (found->mesh && !pane.meshes) return false;
        if (found->points) {
            setWanted(pane, static_cast<std::size_t>(found - layers.begin()));
            found->points->setPart(pane.from, pane.to, pane.whole);
        }
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
        // A stray at 0,0,0 in a cloud on a map grid must not make its own places coarse.
        const Eigen::Vector3d centre = box.diagonal() < kWidest_m ? box.centre() : middleOf(view);
        const bool near = (origin - centre).norm() <= std::clamp(box.diagonal(), 100.0, kWidest_m);
        if (near && !layers.empty()) return;
        clear();
        origin = centre.array().round();
    }

    /// Where half of the points lie on either side, along each axis.
    static Eigen::Vector3d middleOf(const ViewDescription& view) {
        std::array<SampledRange, 3> along;
        for (const ViewLayer& layer : view.layers) {
            if (!isDrawn(layer) || !layer.geometry) continue;
            const PointCloud& cloud = layer.geometry->vertices;
            for (int axis = 0; axis < 3; ++axis)
                along[static_cast<std::size_t>(axis)].sample(cloud.size(), [&](std::size_t i) {
                    return (layer.worldFromLayer * cloud.point(i))[axis];
                });
        }
        if (along[0].empty()) return Eigen::Vector3d::Zero();
        return {along[0].quantile(0.5), along[1].quantile(0.5), along[2].quantile(0.5)};
    }

    void clear() {
        for (const Drawn& drawn : layers) remove(drawn);
        layers.clear();
    }

    void remove(const Drawn& drawn) {
        if (!drawn.prop()) return;
        for (const auto& pane : panes) pane->renderer->RemoveViewProp(drawn.prop());
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
        for (const auto& pane : panes) pane->renderer->AddViewProp(drawn.prop());
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
        const bool otherTriangles = !drawn.colors || drawn.colors->hidden != key.hidden;
        drawn.colors = key;
        if (drawn.mesh) {
            if (otherTriangles) setTriangles(*drawn.mesh, *layer.geometry, layer.hidden.get());
            return setVertexColors(*drawn.mesh, pointColors(view, index, scale));
        }
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

    void setWanted(const PaneDrawing& pane, std::size_t layer) {
        PointProp& points = *layers[layer].points;
        if (layer < pane.wanted.size() && pane.wanted[layer].size() == points.blocks().size())
            points.setWanted(pane.wanted[layer]);
        else
            points.setWanted(std::vector<std::uint32_t>(points.blocks().size(), 0));
    }

    /// The props are asked about what the pane used wants of them.
    void takeWanted() {
        for (std::size_t i = 0; i < layers.size(); ++i)
            if (layers[i].points) setWanted(pane(), i);
    }

    void setPart(double from, double to, bool whole, bool meshes) {
        PaneDrawing& used = pane();
        used.from = from;
        used.to = to;
        used.whole = whole;
        used.meshes = meshes;
        used.share = to;
        for (const auto& one : panes) one->renderer->SetDraw(one.get() == &used);
    }

    void addPane() {
        auto& pane = *panes.emplace_back(std::make_unique<PaneDrawing>());
        pane.pass->setRelease([store = store] { store->release(); });
        pane.pass->setPrepare(
            [this, &pane](vtkProp& prop, int picture) { return prepare(prop, picture, pane); });
        // In this order: a renderer that enters a window asks its props to give back what they have there.
        window.AddRenderer(pane.renderer);
        for (const Drawn& drawn : layers)
            if (drawn.prop()) pane.renderer->AddViewProp(drawn.prop());
    }

    /// The sides of the section in the display frame.
    std::vector<Eigen::Vector4f> clips() const {
        std::vector<Eigen::Vector4f> sides;
        if (!section) return sides;
        for (const ClipPlane& plane : section->planes()) {
            Eigen::Vector4f side;
            side << plane.normal.cast<float>(), static_cast<float>(plane.distance + plane.normal.dot(origin));
            sides.push_back(side);
        }
        return sides;
    }

    void clip(Drawn& drawn) const {
        const std::vector<Eigen::Vector4f> sides = clips();
        const bool inverted = section && section->inverted;
        if (drawn.points) return drawn.points->setClips(sides, inverted);
        setInverted(*drawn.mesh, inverted);
        drawn.mesh->GetMapper()->RemoveAllClippingPlanes();
        for (const Eigen::Vector4f& side : sides) {
            vtkNew<vtkPlane> plane;
            const Eigen::Vector3d normal = side.head<3>().cast<double>();
            const Eigen::Vector3d on = -side.w() * normal;
            plane->SetNormal(normal.data());
            plane->SetOrigin(on.data());
            drawn.mesh->GetMapper()->AddClippingPlane(plane);
        }
    }

    /// Whether the section cuts away all of a box of the world.
    bool isCut(const BoundingBox& box) const {
        if (!section || box.empty()) return false;
        return kept(section->region(), Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero(), box.centre(),
                    0.5 * (box.max - box.min)) == Kept::none;
    }
};

SceneDrawing::SceneDrawing(vtkRenderWindow& window, std::size_t mostHeld, std::size_t wholeBelow)
    : d_(std::make_unique<Private>(window, mostHeld, wholeBelow)) {
    d_->addPane();
}

SceneDrawing::~SceneDrawing() {
    d_->window.MakeCurrent();
    for (const auto& pane : d_->panes) d_->window.RemoveRenderer(pane->renderer);
}

void SceneDrawing::setPanes(const std::vector<QRectF>& viewports) {
    d_->window.MakeCurrent();
    while (d_->panes.size() > std::max<std::size_t>(1, viewports.size())) {
        // The props stay in the other renderers, and so do their points on the card.
        PaneDrawing& last = *d_->panes.back();
        last.pass->setRelease({});
        for (const Drawn& drawn : d_->layers)
            if (drawn.points) drawn.points->keepPages(true);
        d_->window.RemoveRenderer(last.renderer);
        last.renderer->RemoveAllViewProps();
        d_->panes.pop_back();
        for (const Drawn& drawn : d_->layers)
            if (drawn.points) drawn.points->keepPages(false);
    }
    while (d_->panes.size() < viewports.size()) d_->addPane();
    for (std::size_t i = 0; i < viewports.size(); ++i) {
        const QRectF& place = viewports[i];
        d_->panes[i]->renderer->SetViewport(place.left(), 1 - place.bottom(), place.right(), 1 - place.top());
    }
    d_->used = 0;
}

void SceneDrawing::usePane(std::size_t pane) {
    d_->used = std::min(pane, d_->panes.size() - 1);
    d_->takeWanted();
}

void SceneDrawing::show(const ViewDescription& view) {
    d_->placeOrigin(view);
    d_->section = view.section;
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
            drawn.points->setSizeByDistance(view.sizeByDistance);
        }
        d_->clip(drawn);
    }
    for (const Drawn& drawn : before) d_->remove(drawn);
    before.clear();
    d_->reserve();
    const ViewTheme theme = viewTheme(view.theme);
    d_->compares = view.comparison.has_value();
    for (const auto& pane : d_->panes) {
        pane->pass->setEyeDomeLighting(view.eyeDomeLighting);
        pane->pass->setBackground(toVector(theme.backgroundTop), toVector(theme.backgroundBottom),
                                  view.transparent);
        pane->grid.show(view, d_->origin);
        if (!view.comparison) pane->pass->setMix(PicturePass::Mix::none, 0, 1);
    }
    if (view.comparison) setComparison(*view.comparison);
}

void SceneDrawing::setSection(const std::optional<SectionBox>& section) {
    d_->section = section;
    for (Drawn& drawn : d_->layers)
        if (drawn.prop()) d_->clip(drawn);
}

void SceneDrawing::setComparison(const ViewComparison& comparison) {
    if (!d_->compares) return;
    using Mix = PicturePass::Mix;
    const Mix mix = comparison.mode == CompareMode::swipe          ? Mix::swipe
                    : comparison.mode == CompareMode::checkerboard ? Mix::checkerboard
                    : comparison.otherShown                        ? Mix::other
                                                                   : Mix::own;
    for (const auto& pane : d_->panes)
        pane->pass->setMix(mix, static_cast<float>(comparison.divider), comparison.tile_px);
}

void SceneDrawing::setCamera(const ViewCamera& camera) {
    setCamera(camera, {0, 0, camera.width_px, camera.height_px});
}

void SceneDrawing::setCamera(const ViewCamera& camera, const PictureTile& tile) {
    PaneDrawing& pane = d_->pane();
    std::optional<DepthRange> range;
    const double slope =
        camera.parallel ? 0 : 2 * std::tan(0.5 * camera.verticalAngle_rad) / camera.height_px;
    const double parallel = 2 * camera.halfHeight_m / camera.height_px;
    /// Metres a pixel where the box is nearest in one of the pictures; nothing where it is in none.
    const auto finestSeen = [&](const BoundingBox& built, const std::vector<Similarity>& motions) {
        std::optional<double> finest;
        for (const Similarity& motion : motions) {
            const BoundingBox box = motion.isIdentity() ? built : built.transformed(motion);
            if (d_->isCut(box)) continue;
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
    std::vector<std::pair<std::size_t, std::vector<std::optional<double>>>> seen;
    for (std::size_t layer = 0; layer < d_->layers.size(); ++layer) {
        const Drawn& drawn = d_->layers[layer];
        if (!drawn.visible) continue;
        std::vector<Similarity> motions;
        for (int picture = 0; picture < 2; ++picture)
            if (drawn.sides[picture].visible) motions.push_back(drawn.motion(picture));
        if (drawn.mesh) {
            finestSeen(drawn.box, motions);
            continue;
        }
        auto& finest = seen.emplace_back(layer, std::vector<std::optional<double>>()).second;
        for (const PointBlock& block : drawn.points->blocks()) {
            finest.push_back(finestSeen(block.box, motions));
            if (finest.back()) seenPoints += block.size();
        }
    }
    pane.wantedPoints = 0;
    pane.wanted.assign(d_->layers.size(), {});
    for (const auto& [layer, finest] : seen) {
        const PointProp& points = *d_->layers[layer].points;
        std::vector<std::uint32_t>& wanted = pane.wanted[layer];
        wanted.assign(finest.size(), 0);
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            if (!finest[i]) continue;
            const PointBlock& block = points.blocks()[i];
            wanted[i] = seenPoints <= d_->wholeBelow ? block.size() : pointsWorthDrawing(block, *finest[i]);
            pane.wantedPoints += wanted[i];
        }
    }
    d_->takeWanted();
    pane.grid.setCamera(camera);
    setVtkCamera(*pane.renderer->GetActiveCamera(), camera, d_->origin, range.value_or(DepthRange{1, 2}),
                 tile);
    const auto height = static_cast<float>(camera.height_px);
    pane.pass->setBand(1 - static_cast<float>(tile.top + tile.height) / height,
                       1 - static_cast<float>(tile.top) / height);
}

std::size_t SceneDrawing::pointsWanted() const {
    return d_->pane().wantedPoints;
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
    d_->pane().pass->restart();
    d_->setPart(0, share, true, true);
}

bool SceneDrawing::beginPassingPicture(double share, std::size_t most) {
    d_->pane().pass->restart();
    d_->setPart(0, share, false, true);
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
    d_->setPart(d_->pane().share, share, true, false);
}

const std::optional<ColorScale>& SceneDrawing::scale() const {
    return d_->scale;
}

}  // namespace vestige
