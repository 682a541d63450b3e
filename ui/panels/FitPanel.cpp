#include "ui/panels/FitPanel.h"

#include <QCheckBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Attempts.h"
#include "ui/document/Document.h"
#include "ui/document/FitTrace.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/FiguresRow.h"
#include "ui/panels/FitTraceView.h"
#include "ui/panels/FitWords.h"
#include "ui/panels/PanelSection.h"
#include "ui/panels/ResidualView.h"
#include "ui/panels/VerdictBadge.h"

namespace vestige {
namespace {

QLabel* wordsLabel(const char* name) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    return label;
}

QWidget* columnOf(std::initializer_list<QWidget*> widgets) {
    auto* box = new QWidget;
    auto* column = new QVBoxLayout(box);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    for (QWidget* widget : widgets) column->addWidget(widget);
    return box;
}

}  // namespace

FitPanel::FitPanel(const Models& models, const ActionCatalog& actions, QWidget* parent)
    : QWidget(parent),
      models_(models),
      empty_(new QLabel(tr("Nothing is registered yet. Register (Ctrl+G) aligns the other layers with the "
                           "target; here it then says how far to trust it."))),
      content_(new QWidget),
      layer_(new QLabel),
      badge_(new VerdictBadge),
      reasons_(wordsLabel("reasons")),
      refused_(checkBoxFor(actions["register.preview"])),
      candidates_(new CompactList(QString())),
      useCandidate_(buttonFor(actions["register.use-candidate"])),
      uncertainty_(wordsLabel("uncertainty")),
      freedom_(wordsLabel("freedom")),
      arrows_(checkBoxFor(actions["register.freedom"])),
      figures_(new FiguresRow),
      residuals_(new ResidualView),
      restarts_(wordsLabel("restarts")),
      trace_(new FitTraceView(models.trace)) {
    content_->setObjectName("panel-content");
    empty_->setWordWrap(true);
    empty_->setProperty("role", "muted");
    empty_->setContentsMargins(12, 12, 12, 12);
    layer_->setProperty("role", "heading");
    restarts_->setProperty("role", "muted");
    candidates_->tree().setObjectName("candidates");
    candidates_->tree().setAccessibleName(tr("Candidates"));
    candidates_->tree().setToolTip(tr("A click shows the layer there, without moving it"));
    figures_->setObjectName("fit-figures");
    figures_->layout()->setContentsMargins(0, 2, 0, 2);
    auto* column = new QVBoxLayout(content_);
    column->setContentsMargins(0, 6, 0, 6);
    column->setSpacing(6);
    auto* verdict = columnOf({layer_, badge_, reasons_, refused_});
    verdict->setContentsMargins(12, 4, 12, 4);
    column->addWidget(verdict);
    candidatesSection_ = addSection(*column, tr("Candidates"), columnOf({candidates_, useCandidate_}));
    uncertaintySection_ = addSection(*column, tr("Uncertainty of the pose, 95 %"), uncertainty_);
    freedomSection_ = addSection(*column, tr("What the data leave free"), columnOf({freedom_, arrows_}));
    addSection(*column, tr("Residuals"),
               columnOf({figures_, residuals_, restarts_, checkBoxFor(actions["register.residual"])}));
    addSection(*column, tr("Iterations"), trace_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content_);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(empty_);
    whole->addWidget(scroll, 1);

    connect(&candidates_->tree(), &QTreeWidget::itemClicked, this, [this](QTreeWidgetItem* row) {
        const ShownFit fit = shownFit(models_.document, models_.selection, models_.attempts);
        const int place = candidates_->tree().indexOfTopLevelItem(row);
        if (fit.layer && place >= 0) models_.attempts.choose(fit.layer->id, static_cast<std::size_t>(place));
    });
    // The curves come into sight once the layout knows where they are.
    wanted_.setSingleShot(true);
    wanted_.setInterval(0);
    connect(&wanted_, &QTimer::timeout, this, [this, scroll] { scroll->ensureWidgetVisible(trace_, 0, 0); });
    connect(&models_.document, &Document::changed, this, [this] { fill(); });
    connect(&models_.selection, &Selection::changed, this, [this] { fill(); });
    connect(&models_.attempts, &Attempts::changed, this, [this] { fill(); });
    connect(&models_.trace, &FitTrace::changed, this, [this] {
        if (models_.trace.live()) fill();
        if (models_.trace.live() || models_.preview.owner() == &models_.trace) wanted_.start();
    });
    fill();
}

void FitPanel::fill() {
    const ShownFit fit = shownFit(models_.document, models_.selection, models_.attempts);
    const std::string watched = models_.trace.live() ? models_.trace.liveLayer() : std::string();
    empty_->setVisible(!fit.layer && watched.empty());
    content_->setVisible(fit.layer || !watched.empty());
    trace_->setLayer(!watched.empty() ? watched : fit.layer ? fit.layer->id : std::string());
    // While the first registration runs there are only its iterations.
    for (QWidget* widget : {static_cast<QWidget*>(layer_), static_cast<QWidget*>(badge_),
                            static_cast<QWidget*>(reasons_), static_cast<QWidget*>(figures_)})
        widget->setVisible(fit.layer != nullptr);
    refused_->setVisible(fit.layer && !fit.entered);
    if (fit.layer) {
        const Layer* target = models_.document.state().layer(models_.document.state().target);
        layer_->setText(tr("%1 on %2")
                            .arg(QString::fromStdString(fit.layer->name),
                                 target ? QString::fromStdString(target->name) : QString()));
        badge_->setVerdict(fit.result->verdict);
        reasons_->setText(reasonsText(*fit.result));
        reasons_->setVisible(!fit.result->reasons.empty());
        figures_->setFigures(residualFigures(*fit.result), "figure-small");
    }
    fillCandidates(fit);
    fillQuality(fit);
}

void FitPanel::fillCandidates(const ShownFit& fit) {
    const bool choose = fit.layer && !fit.entered && !fit.result->candidates.empty();
    candidatesSection_->setVisible(choose);
    if (!choose) return;
    QTreeWidget& tree = candidates_->tree();
    tree.clear();
    for (std::size_t i = 0; i < fit.result->candidates.size(); ++i) {
        auto* row = new QTreeWidgetItem({candidateText(*fit.result, i),
                                         tr("%1 % fit").arg(qRound(100 * fit.result->candidates[i].score))});
        tree.addTopLevelItem(row);
        if (i == models_.attempts.chosen(fit.layer->id) && models_.attempts.previewed(fit.layer->id))
            tree.setCurrentItem(row);
    }
    candidates_->fit();
}

void FitPanel::fillQuality(const ShownFit& fit) {
    const RegistrationQuality* quality = fit.layer && fit.result->quality ? &*fit.result->quality : nullptr;
    // Of a pose that does not exist there is nothing to say.
    const bool failed = quality && fit.result->verdict == Verdict::failed;
    uncertaintySection_->setVisible(quality && !failed);
    freedomSection_->setVisible(quality && !failed);
    residuals_->setVisible(quality && !quality->residuals.counts.empty());
    restarts_->setVisible(quality && quality->restarts.runs > 0);
    if (!quality) return;
    uncertainty_->setText(uncertaintyText(quality->uncertainty));
    freedom_->setText(freedomText(*quality));
    arrows_->setVisible(leavesFree(*quality));
    residuals_->setResiduals(quality->residuals);
    restarts_->setText(restartsText(quality->restarts));
}

}  // namespace vestige
