#include "ui/tools/PickFeedback.h"

#include <QPainter>

#include "ui/document/PickChoices.h"
#include "ui/tools/FeatureMarks.h"
#include "ui/tools/Loupe.h"
#include "ui/tools/PickWords.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr double kMagnification = 6;

}  // namespace

PickFeedback::PickFeedback(const PickChoices& choices, QObject* parent) : QObject(parent), choices_(choices) {
    // What is shown was found for another choice.
    connect(&choices_, &PickChoices::changed, this, &PickFeedback::hide);
}

PickFeedback::~PickFeedback() = default;

void PickFeedback::show(SceneView& view, const ProbedPlace& place) {
    if (view_ != &view) {
        if (view_) view_->disconnect(this);
        delete loupe_;
        view_ = &view;
        // A magnified picture of where the camera was would be wrong from now on.
        connect(&view, &SceneView::cameraChanged, this, &PickFeedback::hide);
    }
    shown_ = place;
    view.updateOverlay();
    if (choices_.loupe())
        showLoupe(view, place);
    else if (loupe_)
        loupe_->hide();
}

void PickFeedback::hide() {
    if (loupe_) loupe_->hide();
    if (!shown_) return;
    shown_.reset();
    if (view_) view_->updateOverlay();
}

void PickFeedback::paint(QPainter& painter, const ViewCamera& camera, const ViewTheme& theme) const {
    if (shown_ && shown_->pick) paintFeature(painter, theme, camera, *shown_->pick);
}

void PickFeedback::showLoupe(SceneView& view, const ProbedPlace& place) {
    if (!loupe_) loupe_ = new Loupe(view.widget());
    QPointF centre(place.position.x() + 0.5, place.position.y() + 0.5);
    const bool taken = place.pick.has_value() && !place.fitting;
    if (place.pick)
        if (const auto seen = view.camera().project(place.pick->place()))
            centre = {seen->pixel.x(), seen->pixel.y()};
    const double ratio = loupe_->devicePixelRatioF();
    const int side = static_cast<int>(Loupe::kDiameter_px * ratio);
    loupe_->show(picture_.draw(view, centre, ratio * kMagnification, side), captionOf(place), taken,
                 viewTheme(view.description().theme));
    loupe_->placeBeside(place.position, view.covered());
}

}  // namespace vestige
