#include "ui/tools/HoverProbe.h"

#include <QMouseEvent>

#include "ui/view/SceneView.h"

namespace vestige {

HoverProbe::HoverProbe(QObject* parent) : QObject(parent) {
    timer_.setSingleShot(true);
    timer_.setInterval(40);
    connect(&timer_, &QTimer::timeout, this, [this] { probe(); });
}

void HoverProbe::moved(SceneView& view, const QMouseEvent& event) {
    if (event.buttons() != Qt::NoButton) return stop();
    view_ = &view;
    position_ = event.pos();
    if (!timer_.isActive()) timer_.start();
}

void HoverProbe::stop() {
    timer_.stop();
}

void HoverProbe::probe() {
    if (view_) emit hovered(view_->pickAt(position_));
}

}  // namespace vestige
