#include "ui/panels/FitTraceView.h"

#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QPushButton>
#include <QSignalBlocker>
#include <QSlider>
#include <QVBoxLayout>

#include "ui/document/FitTrace.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

constexpr int kPlayEvery_ms = 150;

FitChart chartOf(const FitTrace::Steps& steps, std::optional<std::size_t> cursor) {
    FitChart chart;
    for (const RegistrationStep& step : steps) {
        if (chart.points.empty() || step.level != steps[chart.points.size() - 1].level)
            chart.levels.push_back(chart.points.size());
        chart.points.push_back({step.score, step.voxel_m, step.trustRadius_m, step.step_m, step.taken});
    }
    if (cursor && *cursor < chart.points.size()) chart.cursor = cursor;
    return chart;
}

/// Steps become much smaller than what distanceText() tells apart.
QString sizeText(double metres) {
    if (metres >= 1e-4) return distanceText(metres);
    return QString::number(1e6 * metres, 'g', 2) + QString::fromUtf8(" µm");
}

QString describe(const RegistrationStep& step) {
    const QString tried = step.step_m > 0 ? QObject::tr("step %1%2")
                                                .arg(sizeText(step.step_m))
                                                .arg(step.taken ? QString() : QObject::tr(", not taken"))
                                          : QObject::tr("start of this size");
    return QObject::tr("Voxels %1 · trust radius %2 · %3 · score %4")
        .arg(distanceText(step.voxel_m), sizeText(step.trustRadius_m), tried,
             QString::number(step.score, 'g', 6));
}

}  // namespace

FitCurve::FitCurve(QWidget* parent) : QWidget(parent) {
    setObjectName("fit-curve");
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    setToolTip(tr("Score, voxel size, trust radius and step at each iteration; click to see one"));
}

void FitCurve::setChart(FitChart chart) {
    chart_ = std::move(chart);
    update();
}

QRectF FitCurve::area() const {
    return QRectF(rect()).adjusted(0, 2, 0, -2);
}

void FitCurve::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    paintFitChart(painter, area(), chart_, panelChartStyle(font(), palette()));
}

void FitCurve::mousePressEvent(QMouseEvent* event) {
    if (const auto at = iterationAt(area(), chart_, panelChartStyle(font(), palette()), event->localPos()))
        emit wanted(*at);
}

void FitCurve::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() & Qt::LeftButton) mousePressEvent(event);
}

FitTraceView::FitTraceView(FitTrace& trace, QWidget* parent)
    : QWidget(parent),
      trace_(trace),
      content_(new QWidget),
      curve_(new FitCurve),
      slider_(new QSlider(Qt::Horizontal)),
      play_(new QPushButton(tr("Replay"))),
      step_(new QLabel),
      empty_(new QLabel(tr("Not watched. Switch on “Watch the fit” (W) and register again."))) {
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(content_);
    whole->addWidget(empty_);
    empty_->setWordWrap(true);
    empty_->setProperty("role", "muted");
    auto* column = new QVBoxLayout(content_);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    column->addWidget(curve_);
    auto* row = new QHBoxLayout;
    slider_->setObjectName("fit-slider");
    slider_->setAccessibleName(tr("Iteration"));
    slider_->setToolTip(tr("Shows the layer where the fit had it at this iteration"));
    play_->setObjectName("fit-replay");
    play_->setToolTip(tr("Shows all iterations one after the other; Esc ends it"));
    row->addWidget(slider_, 1);
    row->addWidget(play_);
    column->addLayout(row);
    step_->setObjectName("fit-step");
    step_->setProperty("role", "muted");
    step_->setWordWrap(true);
    column->addWidget(step_);
    timer_.setInterval(kPlayEvery_ms);
    connect(&timer_, &QTimer::timeout, this, [this] {
        const auto at = trace_.cursor(layer_);
        const std::size_t count = trace_.steps(layer_).size();
        if (!at || *at + 1 >= count) return timer_.stop();
        trace_.replay(layer_, *at + 1);
    });
    connect(slider_, &QSlider::valueChanged, this, [this](int value) {
        timer_.stop();
        trace_.replay(layer_, static_cast<std::size_t>(value));
    });
    connect(curve_, &FitCurve::wanted, this, [this](std::size_t iteration) {
        timer_.stop();
        trace_.replay(layer_, iteration);
    });
    connect(play_, &QPushButton::clicked, this, [this] { play(); });
    connect(&trace_, &FitTrace::changed, this, [this] { fill(); });
    fill();
}

void FitTraceView::setLayer(const std::string& layer) {
    if (layer == layer_) return;
    layer_ = layer;
    timer_.stop();
    fill();
}

void FitTraceView::play() {
    trace_.replay(layer_, 0);
    timer_.start();
}

void FitTraceView::fill() {
    const FitTrace::Steps& steps = trace_.steps(layer_);
    content_->setVisible(!steps.empty());
    empty_->setVisible(steps.empty());
    if (steps.empty()) return timer_.stop();
    const auto cursor = trace_.cursor(layer_);
    const std::size_t shown = cursor.value_or(steps.size() - 1);
    curve_->setChart(chartOf(steps, cursor));
    const QSignalBlocker quiet(slider_);
    slider_->setRange(0, static_cast<int>(steps.size()) - 1);
    slider_->setValue(static_cast<int>(shown));
    slider_->setEnabled(!trace_.live());
    play_->setEnabled(!trace_.live());
    step_->setText(describe(steps[shown]));
}

}  // namespace vestige
