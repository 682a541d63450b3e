#include "ui/view/SceneView.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QWheelEvent>
#include <QWidget>

#include "core/pipeline/FrameView.h"
#include "ui/view/Overlay.h"
#include "ui/view/PaneFrames.h"
#include "ui/view/SameDrawing.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

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
    std::unique_ptr<PaneFrames> frames;
    OverlayWidget* overlay = nullptr;
    ViewDescription description;
    bool hasCamera = false;
    std::vector<std::shared_ptr<const Octree>> octrees;
    ViewTool* tool = nullptr;
    ViewTool* guard = nullptr;
    ViewTool* handles = nullptr;
    std::optional<ViewMark> pending;
    std::vector<QRectF> covered;
    std::unique_ptr<ViewMouse> mouse;
    std::optional<Eigen::Vector3d> pivot;
    std::optional<SectionHandle> held;
    std::optional<std::pair<double, double>> colorEnds;
    bool sectionHandles = false;
    bool handling = false;  // a mouse event, in the pane that is pointed at
    QPoint lastPlace;       // of the mouse, in that pane

    ViewPanes& panes() { return frames->panes(); }
    QSize size() const { return frames->widget()->size(); }
    ViewPane& current() { return handling ? panes().pointed() : panes().active(); }

    void fitCameras() { panes().fit(size()); }

    void paintOver(QPainter& painter) {
        const ViewTheme theme = viewTheme(description.theme);
        const bool several = panes().layout() == ViewLayout::four;
        for (std::size_t i = 0; i < panes().all().size(); ++i) {
            const ViewPane& pane = panes().all()[i];
            std::vector<QRectF> over;
            for (const QRectF& place : covered) {
                const QRectF here = (place & QRectF(pane.place)).translated(-pane.place.topLeft());
                if (!here.isEmpty()) over.push_back(here);
            }
            painter.save();
            painter.setClipRect(pane.place);
            painter.translate(pane.place.topLeft());
            // One legend is enough: at the top right.
            OverlayContent content{description, pane.camera, frames->drawing().scale(), pending,
                                   std::move(over)};
            content.legend = !several || i == 1;
            if (several) content.name = viewName(pane.camera);
            content.sectionHandles = sectionHandles;
            content.held = held;
            content.pivot = pivot;
            paintOverlay(painter, content);
            if (tool && i == panes().pointedIndex()) tool->paint(owner, painter, pane.camera, theme);
            painter.restore();
        }
        if (!several) return;
        painter.setRenderHint(QPainter::Antialiasing, false);
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(theme.panelEdge, 1));
        for (const ViewPane& pane : panes().all()) painter.drawRect(pane.place.adjusted(0, 0, -1, -1));
        painter.setPen(QPen(theme.accent, 2));
        painter.drawRect(panes().active().place.adjusted(1, 1, -1, -1));
    }

    /// Null where the flags are of other points than the octree's, for the moment.
    const std::vector<std::uint8_t>* hiddenOf(std::size_t layer) const {
        const auto& hidden = description.layers[layer].hidden;
        return hidden && hidden->size() == octrees[layer]->cloud().size() ? hidden.get() : nullptr;
    }

    std::optional<Pick> pick(const QPoint& position, double radius_px) {
        std::vector<PickLayer> layers;
        const std::size_t count = std::min(octrees.size(), description.layers.size());
        for (std::size_t i = 0; i < count; ++i)
            if (octrees[i] && description.layers[i].visible)
                layers.push_back({static_cast<std::uint32_t>(i), octrees[i].get(),
                                  description.layers[i].worldFromLayer, hiddenOf(i)});
        PickOptions options;
        options.radius_px = radius_px;
        if (description.section) options.clips = description.section->region();
        return pickPoint(layers, panes().pointed().camera, {position.x() + 0.5, position.y() + 0.5}, options);
    }

    std::optional<Eigen::Vector3d> pointNear(const QPoint& position) {
        auto found = pick(position, PickOptions{}.radius_px);
        if (!found) found = pick(position, kPivotRadius_px);
        return found ? std::optional(found->world) : std::nullopt;
    }

    /// The panes that look from named sides, all there is in them.
    void framePanes() {
        for (std::size_t i = 0; i < panes().all().size(); ++i) {
            ViewPane& pane = panes().all()[i];
            if (const auto side = viewOfPane(i); side && panes().layout() == ViewLayout::four)
                pane.camera = frameView(description, *side, pane.camera.width_px, pane.camera.height_px);
        }
    }
};

SceneView::SceneView(const ViewSurfaceFactory& makeSurface, QWidget* parent)
    : QObject(parent), d_(std::make_unique<Private>(*this)) {
    d_->frames = std::make_unique<PaneFrames>(makeSurface(parent), [this] {
        d_->overlay->update();
        const auto ends = colorEnds();
        if (ends == d_->colorEnds) return;
        d_->colorEnds = ends;
        emit colorsChanged();
    });
    d_->frames->description = [this]() -> const ViewDescription& { return d_->description; };
    QWidget* widget = d_->frames->widget();
    d_->overlay = new OverlayWidget(widget, [this](QPainter& painter) { d_->paintOver(painter); });
    d_->mouse =
        std::make_unique<ViewMouse>([this](const QPoint& position) { return d_->pointNear(position); });
    d_->mouse->onMiddleClick([this](const QPoint& position) { setPivotAt(position); });
    widget->setMouseTracking(true);
    widget->setFocusPolicy(Qt::StrongFocus);
    widget->setContextMenuPolicy(Qt::PreventContextMenu);
    widget->installEventFilter(this);
}

SceneView::~SceneView() = default;

QWidget* SceneView::widget() const {
    return d_->frames->widget();
}

void SceneView::show(ViewDescription view, bool resetCamera) {
    const bool take = resetCamera || !d_->hasCamera;
    // Most edits change what is painted over the points alone.
    const bool same = !take && sameDrawing(d_->description, view);
    d_->description = std::move(view);
    if (same) return d_->overlay->update();
    if (take) {
        d_->panes().active().camera = d_->description.camera;
        d_->hasCamera = true;
        d_->fitCameras();
        d_->framePanes();
    }
    d_->frames->sceneChanged();
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
    d_->fitCameras();
    return d_->current().camera;
}

void SceneView::setCamera(const ViewCamera& camera) {
    ViewPane& pane = d_->current();
    pane.camera = camera;
    d_->hasCamera = true;
    d_->fitCameras();
    d_->frames->paneChanged(pane);
    d_->overlay->update();
    emit cameraChanged();
}

void SceneView::showNamedView(NamedView view) {
    const ViewCamera now = camera();
    setCamera(frameView(d_->description, view, now.width_px, now.height_px));
}

void SceneView::setLayout(ViewLayout layout) {
    if (layout == d_->panes().layout()) return;
    d_->panes().setLayout(layout);
    d_->fitCameras();
    d_->framePanes();
    d_->frames->layoutChanged();
    d_->overlay->update();
    emit layoutChanged();
    emit cameraChanged();
}

ViewLayout SceneView::layout() const {
    return d_->panes().layout();
}

QRect SceneView::panePlace() const {
    d_->fitCameras();
    return d_->current().place;
}

void SceneView::changeCameras(const std::function<ViewCamera(const ViewCamera&)>& change) {
    d_->fitCameras();
    for (ViewPane& pane : d_->panes().all()) pane.camera = change(pane.camera);
    d_->frames->allChanged();
    d_->overlay->update();
    emit cameraChanged();
}

void SceneView::setSection(const std::optional<SectionBox>& section) {
    if (d_->description.section == section) return;
    d_->description.section = section;
    d_->frames->drawing().setSection(section);
    d_->frames->moves(nullptr);
    d_->frames->allChanged();
    d_->overlay->update();
}

void SceneView::showSectionHandles(bool on) {
    d_->sectionHandles = on;
    d_->overlay->update();
}

void SceneView::setHeldHandle(const std::optional<SectionHandle>& held) {
    d_->held = held;
    d_->overlay->update();
}

void SceneView::setNavigation(NavigationPreset preset) {
    d_->mouse->setPreset(preset);
}

void SceneView::setPivot(const std::optional<Eigen::Vector3d>& pivot) {
    d_->pivot = pivot;
    d_->mouse->setPivot(pivot);
    d_->overlay->update();
}

const std::optional<Eigen::Vector3d>& SceneView::pivot() const {
    return d_->pivot;
}

void SceneView::setPivotAt(const QPoint& position) {
    setPivot(d_->pointNear(position));
}

void SceneView::setPivotUnderCursor() {
    setPivotAt(d_->lastPlace);
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

void SceneView::setHandles(ViewTool* handles) {
    d_->handles = handles;
}

void SceneView::setComparison(const ViewComparison& comparison) {
    if (!d_->description.comparison) return;
    d_->description.comparison = comparison;
    d_->frames->drawing().setComparison(comparison);
    d_->overlay->update();
    d_->frames->mixChanged();
}

void SceneView::setPendingMark(std::optional<ViewMark> mark) {
    d_->pending = std::move(mark);
    d_->overlay->update();
}

void SceneView::updateOverlay() {
    d_->overlay->update();
}

const std::optional<ColorScale>& SceneView::scale() const {
    return d_->frames->drawing().scale();
}

const std::vector<QRectF>& SceneView::covered() const {
    return d_->covered;
}

void SceneView::setCovered(std::vector<QRectF> covered) {
    d_->covered = std::move(covered);
    d_->overlay->update();
}

void SceneView::completePicture() {
    d_->frames->completePicture();
}

bool SceneView::isComplete() const {
    return d_->frames->isComplete();
}

QImage SceneView::grab() {
    completePicture();
    return widget()->grab().toImage();
}

std::optional<std::pair<double, double>> SceneView::colorEnds() const {
    const auto& scale = d_->frames->drawing().scale();
    if (!scale || !scale->classes.empty()) return std::nullopt;
    return std::pair(scale->low, scale->high);
}

double SceneView::movingFrame_s() const {
    return d_->frames->movingFrame_s();
}

std::uint64_t SceneView::pointsUploaded() const {
    return d_->frames->drawing().pointsUploaded();
}

bool SceneView::offerTo(ViewTool& tool, QEvent& event) {
    switch (event.type()) {
        case QEvent::KeyPress:
            return tool.keyPress(*this, static_cast<QKeyEvent&>(event));
        case QEvent::MouseButtonPress:
            return tool.mousePress(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseButtonDblClick:
            return tool.mouseDoubleClick(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseMove:
            return tool.mouseMove(*this, static_cast<QMouseEvent&>(event));
        case QEvent::MouseButtonRelease:
            return tool.mouseRelease(*this, static_cast<QMouseEvent&>(event));
        case QEvent::Wheel:
            return tool.wheel(*this, static_cast<QWheelEvent&>(event));
        default:
            return false;
    }
}

/// An event in the pane that is pointed at, in its coordinates.
bool SceneView::handle(QEvent& event) {
    const auto offer = [&](ViewTool* tool) { return tool && offerTo(*tool, event); };
    if (offer(d_->guard) || offer(d_->handles) || offer(d_->tool)) return true;
    if (event.type() == QEvent::MouseButtonDblClick) return true;
    ViewPane& pane = d_->panes().pointed();
    if (const auto moved = d_->mouse->handle(event, pane.camera)) {
        d_->frames->moves(&pane);
        setCamera(*moved);
    }
    return true;
}

bool SceneView::eventFilter(QObject* watched, QEvent* event) {
    if (watched != widget()) return QObject::eventFilter(watched, event);
    const auto offer = [&](ViewTool* tool) { return tool && offerTo(*tool, *event); };
    switch (event->type()) {
        case QEvent::Resize:
            d_->overlay->resize(d_->size());
            [[fallthrough]];
        case QEvent::Show:
            d_->frames->sizeChanged();
            return false;
        case QEvent::ShortcutOverride:
            if (!d_->tool || !d_->tool->holdsKey(*this, static_cast<QKeyEvent&>(*event))) return false;
            event->accept();
            return true;
        case QEvent::KeyPress:
            return offer(d_->tool) || offer(d_->handles) || offer(d_->guard);
        case QEvent::MouseButtonPress:
        case QEvent::MouseMove:
        case QEvent::MouseButtonRelease:
        case QEvent::MouseButtonDblClick:
        case QEvent::Wheel:
            break;
        default:
            return false;
    }
    d_->fitCameras();
    ViewPanes& panes = d_->panes();
    const bool turn = event->type() == QEvent::Wheel;
    const auto* wheel = turn ? static_cast<QWheelEvent*>(event) : nullptr;
    const auto* mouse = turn ? nullptr : static_cast<QMouseEvent*>(event);
    const QPoint position = turn ? wheel->position().toPoint() : mouse->pos();
    const bool first =
        event->type() == QEvent::MouseButtonPress || event->type() == QEvent::MouseButtonDblClick;
    // What was begun in a pane ends in it.
    const Qt::MouseButtons before = turn    ? wheel->buttons()
                                    : first ? mouse->buttons() & ~mouse->button()
                                            : mouse->buttons();
    const bool dragged = event->type() == QEvent::MouseButtonRelease || before != Qt::NoButton;
    if (!dragged) panes.point(panes.at(position));
    if (first && panes.activate(panes.pointedIndex())) {
        d_->overlay->update();
        emit activePaneChanged();
    }
    const QPoint corner = panes.pointed().place.topLeft();
    d_->lastPlace = position - corner;
    d_->handling = true;
    bool taken = false;
    if (turn) {
        QWheelEvent here(wheel->position() - corner, wheel->globalPosition(), wheel->pixelDelta(),
                         wheel->angleDelta(), wheel->buttons(), wheel->modifiers(), wheel->phase(),
                         wheel->inverted());
        taken = handle(here);
    } else {
        QMouseEvent here(mouse->type(), mouse->localPos() - corner, mouse->windowPos(), mouse->screenPos(),
                         mouse->button(), mouse->buttons(), mouse->modifiers());
        taken = handle(here);
    }
    d_->handling = false;
    return taken;
}

}  // namespace vestige
