#include "ui/tools/HoverProbe.h"

#include <QMouseEvent>

#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr int kInterval_ms = 40;
/// A view that moves tells so at every frame; the answer is wanted when it stands still.
constexpr int kRest_ms = 120;

}  // namespace

HoverProbe::HoverProbe(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, [this] { probe(); });
}

void HoverProbe::moved(SceneView& view, const QMouseEvent& event) {
    if (event.buttons() != Qt::NoButton) return stop();
    view_ = &view;
    position_ = event.pos();
    if (!timer_.isActive()) timer_.start(kInterval_ms);
}

void HoverProbe::again() {
    if (view_) timer_.start(kRest_ms);
}

void HoverProbe::stop() {
    timer_.stop();
    view_ = nullptr;
}

void HoverProbe::probe() {
    if (view_) emit hovered(view_->pickAt(position_));
}

}  // namespace vestige
