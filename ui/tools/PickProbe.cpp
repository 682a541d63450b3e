#include "ui/tools/PickProbe.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QWidget>

#include "core/measurement/fit/Snap.h"
#include "core/scene/MeasuredScene.h"
#include "core/scene/PickFrame.h"
#include "ui/document/Document.h"
#include "ui/document/PickChoices.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// Longest between two answers while something is dragged, and how long a fit may take before it is told that
/// it is being made.
constexpr int kFollow_ms = 40;
constexpr int kPatience_ms = 80;

bool same(const Similarity& a, const Similarity& b) {
    return a.scale == b.scale && a.pose.matrix() == b.pose.matrix();
}

/// "No corner was found round the pick: 60 points within 400 mm."
QString sentenceOf(const Error& error) {
    QString text = QString::fromStdString(error.message);
    if (!text.isEmpty()) text[0] = text[0].toUpper();
    if (!error.place.empty()) text += ": " + QString::fromStdString(error.place);
    return text + '.';
}

}  // namespace

/// A feature to be fitted. It keeps what it needs of the layer, so that it can be asked on any thread.
struct PickProbe::Question {
    SnapMode mode;
    std::string layer;
    std::uint32_t point;
    std::shared_ptr<const Octree> octree;
    std::shared_ptr<const std::vector<std::uint8_t>> hidden;  ///< of the octree's points; may be null
    SnapRequest request;
    Similarity pointFromShown;  ///< from where the view shows the layer to the frame of the recorded point

    bool sameAs(const Question& other) const {
        return mode == other.mode && layer == other.layer && point == other.point && octree == other.octree &&
               request.seed == other.request.seed &&
               same(request.sceneFromLayer, other.request.sceneFromLayer) &&
               same(pointFromShown, other.pointFromShown) &&
               request.viewDirection.dot(other.request.viewDirection) > 1 - 1e-6 &&
               request.clips == other.request.clips && hidden == other.hidden;
    }
};

PickProbe::PickProbe(Document& document, const PickChoices& choices, HoverProbe& hover, QObject* parent)
    : QObject(parent), document_(document), choices_(choices), probe_(hover) {
    followTimer_.setSingleShot(true);
    followTimer_.setInterval(kFollow_ms);
    connect(&followTimer_, &QTimer::timeout, this, [this] {
        if (following_) following_();
    });
    connect(&probe_, &HoverProbe::hovered, this, [this](const std::optional<Pick>& under) {
        if (view_)
            ask(
                *view_, probe_.position(), under, [this](const ProbedPlace& place) { emit hovered(place); },
                true);
    });
    connect(&choices_, &PickChoices::changed, this, &PickProbe::renew);
}

PickProbe::~PickProbe() = default;

void PickProbe::hover(SceneView& view, const QMouseEvent& event) {
    if (view_ != &view) {
        connect(&view, &SceneView::cameraChanged, this, &PickProbe::renew, Qt::UniqueConnection);
        view.widget()->installEventFilter(this);
    }
    view_ = event.buttons() == Qt::NoButton ? &view : nullptr;
    if (!view_) ++serial_;
    probe_.moved(view, event);
}

bool PickProbe::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Leave && view_) {
        view_ = nullptr;
        ++serial_;
        probe_.stop();
        emit left();
    }
    return QObject::eventFilter(watched, event);
}

void PickProbe::renew() {
    if (view_ && QGuiApplication::mouseButtons() == Qt::NoButton) probe_.again();
}

void PickProbe::stop() {
    ++generation_;
    ++serial_;
    view_ = nullptr;
    probe_.stop();
    followTimer_.stop();
    following_ = nullptr;
}

void PickProbe::take(SceneView& view, const QPoint& position, Done done) {
    followTimer_.stop();
    following_ = nullptr;
    ask(view, position, view.pickAt(position), std::move(done), false);
}

void PickProbe::follow(SceneView& view, const QPoint& position, Done done) {
    following_ = [this, &view, position, done = std::move(done)] {
        ask(view, position, view.pickAt(position), done, true);
    };
    if (!followTimer_.isActive()) followTimer_.start();
}

/// Fills what is known of `place` at once; nothing when there is nothing to fit.
std::shared_ptr<const PickProbe::Question> PickProbe::question(SceneView& view, ProbedPlace& place) const {
    const auto& layers = view.description().layers;
    if (!place.under || place.under->layer >= layers.size()) {
        place.problem = tr("There is no point within 6 pixels of the cursor.");
        return nullptr;
    }
    const ViewLayer& shown = layers[place.under->layer];
    const SceneState& scene = document_.state();
    const Layer* layer = scene.layer(shown.id);
    if (!layer || !layer->data) return nullptr;
    // Where the layer is shown before its registration, the point is taken to where the case has the layer.
    const Similarity sceneFromShown = sceneFromLayer(*layer) * shown.worldFromLayer.inverse();
    // A first look is thinner than the cloud: the spacing is then taken from what the layer holds later.
    const bool whole = !layer->data->isPreview();
    const auto spacing = whole ? std::optional(place.under->localSpacing_m) : std::nullopt;
    ProbedPick pick{pickAt(scene, layer->id, sceneFromShown * place.under->world, spacing),
                    place.under->world, std::nullopt};
    if (place.snap == SnapMode::point) {
        place.pick = std::move(pick);
        return nullptr;
    }
    if (!whole) {
        place.problem = tr("Features can be fitted once all points of this layer are read.");
        return nullptr;
    }
    if (!pointsErrApart(layer->role)) {
        place.problem =
            tr("Points of photogrammetry err together, which no fit averages out: snap to points.");
        return nullptr;
    }
    auto asked = std::make_shared<Question>();
    asked->mode = place.snap;
    asked->layer = layer->id;
    asked->point = place.under->point;
    asked->octree = layer->data->octree;
    asked->request.octree = asked->octree.get();
    if (shown.hidden && shown.hidden->size() == asked->octree->cloud().size()) asked->hidden = shown.hidden;
    asked->request.hidden = asked->hidden.get();
    asked->request.sceneFromLayer = shown.worldFromLayer;
    const ViewRay ray = view.camera().ray({place.position.x() + 0.5, place.position.y() + 0.5});
    asked->request.seed = place.under->world;
    // Of the point hit only how far away it is: the eye is on the cursor.
    if (place.snap == SnapMode::surface)
        asked->request.seed = ray.from + ray.direction.dot(place.under->world - ray.from) * ray.direction;
    asked->request.viewDirection = ray.direction;
    asked->request.sensorNoise_m = sensorNoise_m(layer->role);
    asked->request.radius_m = 0;
    if (view.description().section) asked->request.clips = view.description().section->region();
    asked->pointFromShown = sceneFromPick(scene, pick.point).inverse() * sceneFromShown;
    place.pick = std::move(pick);
    return asked;
}

void PickProbe::ask(SceneView& view, const QPoint& position, const std::optional<Pick>& under, Done done,
                    bool passing) {
    ProbedPlace place;
    place.position = position;
    place.snap = choices_.snap();
    place.under = under;
    const int serial = passing ? ++serial_ : serial_;
    const std::shared_ptr<const Question> asked = question(view, place);
    if (!asked) return done(place);
    if (last_ && last_->sameAs(*asked)) return done(answered(*asked, place, *lastFeature_));
    place.fitting = true;
    answeredSerial_ = -1;
    if (passing)
        QTimer::singleShot(kPatience_ms, this, [this, serial, place, done] {
            if (serial == serial_ && serial != answeredSerial_) done(place);
        });
    worker_.ask([asked] { return snapFeature(asked->request, asked->mode); },
                [this, asked, place, done, passing, serial,
                 generation = generation_](const Result<FittedFeature>& feature) {
                    last_ = asked;
                    lastFeature_ = feature;
                    if (generation != generation_ || (passing && serial != serial_)) return;
                    answeredSerial_ = serial;
                    done(answered(*asked, place, feature));
                },
                passing);
}

ProbedPlace PickProbe::answered(const Question& question, ProbedPlace place,
                                const Result<FittedFeature>& feature) const {
    place.fitting = false;
    if (!feature) {
        place.pick.reset();
        place.problem = sentenceOf(feature.error());
        return place;
    }
    place.pick->feature = *feature;
    place.pick->point.fitted = moved(*feature, question.pointFromShown);
    return place;
}

}  // namespace vestige
