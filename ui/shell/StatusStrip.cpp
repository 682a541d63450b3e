#include "ui/shell/StatusStrip.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QStyle>

#include "ui/document/Document.h"
#include "ui/document/Wording.h"
#include "ui/jobs/JobRunner.h"

namespace vestige {
namespace {

constexpr int kTick_ms = 500;

}  // namespace

StatusStrip::StatusStrip(Document& document, JobRunner& jobs, QWidget* parent)
    : QWidget(parent),
      document_(document),
      jobs_(jobs),
      job_(new QLabel),
      bar_(new QProgressBar),
      percent_(new QLabel),
      left_(new QLabel),
      cancel_(new QPushButton(tr("Cancel"))),
      message_(new QLabel),
      autosave_(new QLabel),
      coordinates_(new QLabel),
      layer_(new QLabel) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 3, 12, 3);
    row->setSpacing(14);
    job_->setObjectName("job");
    bar_->setObjectName("progress");
    bar_->setRange(0, 1000);
    bar_->setTextVisible(false);
    bar_->setFixedSize(132, 5);
    percent_->setMinimumWidth(40);
    left_->setObjectName("time-left");
    left_->setProperty("role", "muted");
    cancel_->setObjectName("cancel");
    cancel_->setToolTip(tr("Stop this job; the case stays as it was"));
    coordinates_->setObjectName("coordinates");
    layer_->setProperty("role", "muted");
    row->addWidget(job_);
    row->addWidget(bar_);
    row->addWidget(percent_);
    row->addWidget(left_);
    row->addWidget(cancel_);
    message_->setObjectName("job-message");
    message_->setProperty("role", "muted");
    // A long sentence gives way to the rest of the strip.
    message_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    row->addWidget(message_, 1);
    autosave_->setObjectName("autosave");
    autosave_->setProperty("role", "muted");
    row->addWidget(autosave_);
    row->addWidget(coordinates_);
    row->addWidget(layer_);
    connect(cancel_, &QPushButton::clicked, this, [this] {
        cancel_->setEnabled(false);
        jobs_.cancel();
    });
    clock_.start();
    tick_.setInterval(kTick_ms);
    connect(&tick_, &QTimer::timeout, this, [this] { showTimeLeft(); });
    connect(&jobs_, &JobRunner::started, this, [this](const QString& title) { begin(title); });
    connect(&jobs_, &JobRunner::progressed, this, [this](double fraction, const QString& step) {
        // What a worker's thread reported may arrive after the job's end.
        if (!jobs_.busy()) return;
        share_ = fraction;
        bar_->setValue(static_cast<int>(1000 * fraction));
        percent_->setText(tr("%1 %").arg(static_cast<int>(100 * fraction)));
        job_->setText(step.isEmpty() ? title_ : tr("%1: %2").arg(title_, said(step.toStdString())));
    });
    connect(&jobs_, &JobRunner::messaged, this, [this](const QString& sentence) {
        if (jobs_.busy()) message_->setText(said(sentence.toStdString()));
    });
    connect(&jobs_, &JobRunner::finished, this, [this] { showIdle(); });
    connect(&document_, &Document::changed, this, [this] {
        if (!jobs_.busy())
            showIdle();
        else
            message_->setText(previewText());
    });
    showIdle();
}

void StatusStrip::begin(const QString& title) {
    title_ = title;
    share_ = 0;
    job_->setText(title);
    bar_->setValue(0);
    percent_->clear();
    left_->clear();
    cancel_->setEnabled(true);
    for (QWidget* widget : std::initializer_list<QWidget*>{bar_, percent_, left_, cancel_}) widget->show();
    estimate_.emplace(1e-3 * static_cast<double>(clock_.elapsed()));
    tick_.start();
}

void StatusStrip::showTimeLeft() {
    if (!estimate_) return;
    const double now = 1e-3 * static_cast<double>(clock_.elapsed());
    estimate_->update(now, share_);
    const auto left = estimate_->left_s(now);
    left_->setText(left ? timeLeftText(*left) : QString());
}

/// "Showing 1.5 M of 100 M points" while what is shown is not all yet.
QString StatusStrip::previewText() const {
    std::uint64_t shown = 0;
    std::uint64_t awaited = 0;
    for (const Layer& layer : document_.state().layers) {
        if (!layer.data || !layer.data->isPreview()) continue;
        shown += layer.data->points->size();
        awaited += layer.data->awaitedPoints;
    }
    if (awaited == 0) return {};
    return tr("Showing %1 of %2 points").arg(countText(shown), countText(awaited));
}

void StatusStrip::showIdle() {
    if (jobs_.busy()) return;
    tick_.stop();
    estimate_.reset();
    for (QWidget* widget : std::initializer_list<QWidget*>{bar_, percent_, left_, cancel_}) widget->hide();
    message_->clear();
    std::uint64_t points = 0;
    for (const Layer& layer : document_.state().layers)
        if (layer.data) points += layer.data->points->size();
    const int layers = static_cast<int>(document_.state().layers.size());
    job_->setText(layers == 0   ? tr("Ready")
                  : layers == 1 ? tr("%1 points in one layer").arg(countText(points))
                                : tr("%1 points in %2 layers").arg(countText(points)).arg(layers));
}

void StatusStrip::showAutosave(const QString& text, bool trouble) {
    autosave_->setText(text);
    autosave_->setToolTip(text);
    autosave_->setProperty("role", trouble ? "trouble" : "muted");
    autosave_->style()->unpolish(autosave_);
    autosave_->style()->polish(autosave_);
}

void StatusStrip::showCoordinates(const QString& coordinates, const QString& layer) {
    coordinates_->setText(coordinates);
    layer_->setText(layer);
}

}  // namespace vestige
