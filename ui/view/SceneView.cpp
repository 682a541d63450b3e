#include "ui/view/SceneView.h"

#include <vtkRenderWindow.h>

#include <QElapsedTimer>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QWidget>

#include "core/pipeline/FrameView.h"
#include "ui/view/FrameBudget.h"
#include "ui/view/Overlay.h"
#include "ui/view/SceneDrawing.h"
#include "ui/view/ViewMouse.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

constexpr double kMovingFrame_s = 0.07;
constexpr double kRestingFrame_s = 0.12;
/// A picture is complete after so many steps at most, once the graphics card holds its points: each step
/// costs light and copying, too, however few its points.
constexpr double kLeastStep = 1.0 / 12;
constexpr int kRest_ms = 160;
/// Points made ready and given to the graphics card between two frames: about 30 ms on two cores.
constexpr std::size_t kBroughtAtOnce = 400000;
constexpr double kPivotRadius_px = 24;

/// Paints over the picture; mouse and keyboard go through it.
class OverlayWidget : public QWidget {
  public:
    OverlayWidget(QWidget* parent, std::function<void(QPainter&)> paint)
        : QWidget(parent), paint_(std::move(paint)) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setAttribute(Qt::WA_NoSystemBackground);
    }

  protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        paint_(painter);
    }

  private:
    std::function<void(QPainter&)> paint_;
};

}  // namespace

struct SceneView::Private {
    explicit Private(const SceneView& view) : owner(view) {}

    const SceneView& owner;
    std::unique_ptr<ViewSurface> surface;
    std::unique_ptr<SceneDrawing> drawing;
    OverlayWidget* overlay = nullptr;
    ViewDescription description;
    ViewCamera camera;
    bool hasCamera = false;
    std::vector<std::shared_ptr<const Octree>> octrees;
    ViewTool* tool = nullptr;
    ViewTool* guard = nullptr;
    std::optional<ViewMark> pending;
    std::vector<QRectF> covered;
    std::unique_ptr<ViewMouse> mouse;

    QTimer frameTimer;  // the next frame, as soon as events are handled
    QTimer restTimer;   // the camera stands still
    FrameBudget movingBudget{kMovingFrame_s};
    FrameBudget restingBudget{kRestingFrame_s};
    bool sceneChanged = true;
    bool pictureChanged = true;
    bool moving = false;
    double share = 0;     // of the points wanted that the picture holds
    bool lacks = false;   // the picture has not all points of that share
    bool atOnce = false;  // one step drew the picture

    QSize size() const { return surface->widget()->size(); }

    void fitCamera() {
        camera.width_px = std::max(1, size().width());
        camera.height_px = std::max(1, size().height());
    }

    void paintOver(QPainter& painter) {
        paintOverlay(painter, {description, camera, drawing->scale(), pending, covered});
        if (tool) tool->paint(owner, painter, camera, viewTheme(description.theme));
    }

    /// Draws the next step of the picture: the first points, or some more. `all` leaves nothing out.
    void step(bool all) {
        if (size().isEmpty()) return;
        fitCamera();
        if (sceneChanged) drawing->show(description);
        const bool begin = sceneChanged || pictureChanged;
        if (begin) drawing->setCamera(camera);
        const std::size_t wanted = drawing->pointsWanted();
        FrameBudget& budget = moving ? movingBudget : restingBudget;
        double part = wanted == 0 || all ? 1.0 : static_cast<double>(budget.points()) / wanted;
        if (!moving) part = std::max(part, kLeastStep);
        const double from = begin ? 0 : share;
        double to = std::min(1.0, from + part);
        const bool passing = moving && begin && !all;
        if (!all && !passing) to = drawing->shareWithin(from, to, kBroughtAtOnce);
        bool holds = true;
        if (passing)
            holds = drawing->beginPassingPicture(to, kBroughtAtOnce);
        else if (begin)
            drawing->beginPicture(to);
        else
            drawing->addToPicture(to);
        QElapsedTimer clock;
        clock.start();
        if (!surface->drawFrame()) {
            frameTimer.start(20);
            return;
        }
        budget.frameTook(static_cast<std::size_t>((to - from) * static_cast<double>(wanted)),
                         1e-9 * clock.nsecsElapsed());
        if (begin) lacks = !holds;
        atOnce = begin;
        sceneChanged = pictureChanged = false;
        share = to;
        overlay->update();
        if (share < 1 && !moving) frameTimer.start(0);
    }

    /// The camera stands still: what was left out of passing pictures comes in.
    void rest() {
        moving = false;
        if (lacks) pictureChanged = true;
        frameTimer.start(0);
    }

    void redraw() {
        pictureChanged = true;
        if (!frameTimer.isActive()) frameTimer.start(0);
    }

    std::optional<Pick> pick(const QPoint& position, double radius_px) const {
        std::vector<PickLayer> layers;
        const std::size_t count = std::min(octrees.size(), description.layers.size());
        for (std::size_t i = 0; i < count; ++i)
            if (octrees[i] && description.layers[i].visible)
                layers.push_back(
                    {static_cast<std::uint32_t>(i), octrees[i].get(), description.layers[i].worldFromLayer});
        PickOptions options;
        options.radius_px = radius_px;
        if (description.section) options.clips = description.section->planes();
        return pickPoint(layers, camera, {position.x() + 0.5, position.y() + 0.5}, options);
    }
};

SceneView::SceneView(const ViewSurfaceFactory& makeSurface, QWidget* parent)
    : QObject(parent), d_(std::make_unique<Private>(*this)) {
    d_->surface = makeSurface(parent);
    d_->drawing = std::make_unique<SceneDrawing>(d_->surface->renderWindow());
    QWidget* widget = d_->surface->widget();
    d_->overlay = new OverlayWidget(widget, [this](QPainter& painter) { d_->paintOver(painter); });
    d_->mouse = std::make_unique<ViewMouse>([this](const QPoint& position) -> std::optional<Eigen::Vector3d> {
        auto pick = d_->pick(position, PickOptions{}.radius_px);
        if (!pick) pick = d_->pick(position, kPivotRadius_px);
        return pick ? std::optional(pick->world) : std::nullopt;
    });
    widget->setMouseTracking(true);
    widget->setFocusPolicy(Qt::StrongFocus);
    widget->setContextMenuPolicy(Qt::PreventContextMenu);
    widget->installEventFilter(this);
    d_->frameTimer.setSingleShot(true);
    d_->restTimer.setSingleShot(true);
    connect(&d_->frameTimer, &QTimer::timeout, this, [this] { d_->step(false); });
    connect(&d_->restTimer, &QTimer::timeout, this, [this] { d_->rest(); });
}

SceneView::~SceneView() = default;

QWidget* SceneView::widget() const {
    return d_->surface->widget();
}

void SceneView::show(ViewDescription view, bool resetCamera) {
    const bool take = resetCamera || !d_->hasCamera;
    d_->description = std::move(view);
    d_->sceneChanged = true;
    if (take) {
        d_->camera = d_->description.camera;
        d_->hasCamera = true;
        d_->fitCamera();
    }
    d_->redraw();
    d_->overlay->update();
    if (take) emit cameraChanged();
}

const ViewDescription& SceneView::description() const {
    return d_->description;
}

void SceneView::setPickIndex(std::vector<std::shared_ptr<const Octree>> octrees) {
    d_->octrees = std::move(octrees);
}

std::optional<Pick> SceneView::pickAt(const QPoint& position) const {
    return d_->pick(position, PickOptions{}.radius_px);
}

ViewCamera SceneView::camera() const {
    d_->fitCamera();
    return d_->camera;
}

void SceneView::setCamera(const ViewCamera& camera) {
    d_->camera = camera;
    d_->hasCamera = true;
    d_->fitCamera();
    d_->redraw();
    d_->overlay->update();
    emit cameraChanged();
}

void SceneView::showNamedView(NamedView view) {
    d_->fitCamera();
    setCamera(frameView(d_->description, view, d_->camera.width_px, d_->camera.height_px));
}

void SceneView::setTool(ViewTool* tool) {
    if (tool == d_->tool) return;
    if (d_->tool) d_->tool->leave(*this);
    d_->tool = tool;
    if (d_->tool) d_->tool->enter(*this);
}

ViewTool* SceneView::tool() const {
    return d_->tool;
}

void SceneView::setGuard(ViewTool* guard) {
    d_->guard = guard;
}

void SceneView::setComparison(const ViewComparison& comparison) {
    if (!d_->description.comparison) return;
    d_->description.comparison = comparison;
    d_->drawing->setComparison(comparison);
    d_->overlay->update();
    if (d_->sceneChanged || d_->pictureChanged) return;
    d_->drawing->addToPicture(d_->share);
    d_->surface->drawFrame();
}

void SceneView::setPendingMark(std::optional<ViewMark> mark) {
    d_->pending = std::move(mark);
    d_->overlay->update();
}

void SceneView::updateOverlay() {
    d_->overlay->update();
}

const std::optional<ColorScale>& SceneView::scale() const {
    return d_->drawing->scale();
}

const std::vector<QRectF>& SceneView::covered() const {
    return d_->covered;
}

void SceneView::setCovered(std::vector<QRectF> covered) {
    d_->covered = std::move(covered);
    d_->overlay->update();
}

void SceneView::completePicture() {
    d_->moving = false;
    if (isComplete() && d_->atOnce) return;
    // Points of equal depth hide each other by the order of drawing, and steps end where the time of a frame
    // did: what they drew is drawn anew.
    d_->pictureChanged = true;
    d_->step(true);
}

bool SceneView::isComplete() const {
    return !d_->sceneChanged && !d_->pictureChanged && !d_->lacks && d_->share >= 1;
}

QImage SceneView::grab() {
    completePicture();
    return widget()->grab().toImage();
}

bool SceneView::offerTo(ViewTool& tool, QEvent& event) {
    switch (event.type()) {
        case QEvent::KeyPress:
            return tool.keyPress(*this, static_cast<QKeyEvent&>(event));
        case QEvent::MouseButtonPress:
            return tool.mousePress(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseMove:
            return tool.mouseMove(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseButtonRelease:
            return tool.mouseRelease(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseButtonDblClick:
            return tool.mouseDoubleClick(*this, static_cast<QMouseEvent&>(event));
        default:
            return false;
    }
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != d_->surface->widget()) return QObject::eventFilter(watched, event);
    const auto offer = [&](ViewTool* tool) { return tool && offerTo(*tool, *event); };
    switch (event->type()) {
        case QEvent::Resize:
            d_->overlay->resize(d_->size());
            [[fallthrough]];
        case QEvent::Show:
            d_->fitCamera();
            d_->redraw();
            return false;
        case QEvent::ShortcutOverride:
            if (!d_->tool || !d_->tool->holdsKey(*this, static_cast<QKeyEvent&>(*event))) return false;
            event->accept();
            return true;
        case QEvent::KeyPress:
            return offer(d_->tool) || offer(d_->guard);
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
            if (offer(d_->guard) || offer(d_->tool)) return true;
            break;
        case QEvent::Wheel:
            break;
        case QEvent::MouseButtonDblClick:
            offer(d_->tool);
            return true;
        default:
            return false;
    }
    if (const auto moved = d_->mouse->handle(*event, camera())) {
        d_->moving = true;
        d_->restTimer.start(kRest_ms);
        setCamera(*moved);
    }
    return true;
}

}  // namespace vestige
