#include "ui/panels/CleanPanel.h"

#include <QAction>
#include <QGridLayout>
#include <QLineEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>

#include "core/base/Numbers.h"
#include "core/report/Wording.h"
#include "core/scene/Cleaning.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/CleaningSettings.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/PointSelection.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/forms/ParameterForm.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/PanelSection.h"

namespace vestige {
namespace {

QLabel* words(const char* name, bool muted) {
    auto* label = new QLabel;
    label->setObjectName(name);
    label->setWordWrap(true);
    if (muted) label->setProperty("role", "muted");
    return label;
}

}  // namespace

CleanPanel::CleanPanel(Document& document, Selection& selection, PointSelection& points,
                       CleaningSettings& settings, Notices& notices, const ActionCatalog& actions,
                       QWidget* parent)
    : QWidget(parent), document_(document), selection_(selection), points_(points) {
    auto* outline = formFor(settings.outline, notices);
    // What no limit means is said in the place of "automatic".
    if (auto* depth = outline->findChild<QLineEdit*>("depth_m")) depth->setPlaceholderText(tr("no limit"));
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 6, 0, 6);
    column->setSpacing(6);
    addSection(
        *column, tr("Select by hand"),
        makeStep(actions, tr("Draw round what does not belong to the scene: a passer-by, a moving car."),
                 outline, {"tool.lasso", "tool.box-select"}));
    addSection(*column, tr("Outliers"),
               makeStep(actions, tr("Single points in the air: echoes of rain, dust and edges."),
                        formFor(settings.outliers, notices), {"clean.outliers"}));
    addSection(*column, tr("Ground"),
               makeStep(actions, tr("The surface that everything else stands on."),
                        formFor(settings.ground, notices), {"clean.ground"}));
    addSection(
        *column, tr("Objects"),
        makeStep(
            actions,
            tr("What stands on the ground and hangs together becomes an object: vehicles, debris, poles."),
            formFor(settings.objects, notices), {"clean.objects"}));
    addSection(*column, tr("Taken out"), makeRemoved(actions));
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->setSpacing(0);
    whole->addWidget(scroll, 1);
    whole->addWidget(makeSelected(actions));
    connect(&points_, &PointSelection::changed, this, [this] { describeSelected(); });
    connect(&document_, &Document::changed, this, [this] { describeRemoved(); });
    connect(&selection_, &Selection::changed, this, [this] { describeRemoved(); });
    describeSelected();
    describeRemoved();
}

ParameterForm* CleanPanel::formFor(ParameterSet& settings, Notices& notices) {
    // What is drawn by hand needs its settings each time; what is found is found with the defaults.
    using Keys = std::vector<std::string>;
    const bool byHand = settings.table().front().key == "side";
    auto* form = new ParameterForm(settings.table(), byHand ? std::nullopt : std::optional<Keys>(Keys{}));
    form->setValues(settings);
    connect(form, &ParameterForm::edited, this, [&settings](const std::string& key, const auto& value) {
        static_cast<void>(settings.set(key, value));
    });
    connect(form, &ParameterForm::refused, &notices,
            [&notices](const QString& sentence) { emit notices.warned(sentence + "."); });
    return form;
}

QWidget* CleanPanel::makeStep(const ActionCatalog& actions, const QString& meaning, ParameterForm* form,
                              const std::vector<const char*>& ids) {
    auto* step = new QWidget;
    auto* column = new QVBoxLayout(step);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* label = new QLabel(meaning);
    label->setProperty("role", "muted");
    label->setWordWrap(true);
    column->addWidget(label);
    column->addWidget(form);
    auto* row = new QHBoxLayout;
    row->setSpacing(6);
    for (const char* id : ids) row->addWidget(buttonFor(actions[id]), 1);
    column->addLayout(row);
    return step;
}

QWidget* CleanPanel::makeSelected(const ActionCatalog& actions) {
    auto* foot = new QWidget;
    foot->setObjectName("clean-selected");
    auto* column = new QVBoxLayout(foot);
    column->setContentsMargins(12, 8, 12, 12);
    column->setSpacing(6);
    selected_ = words("selected-points", false);
    reach_ = words("selected-reach", true);
    behind_ = words("selected-behind", false);
    behind_->setProperty("role", "trouble");
    column->addWidget(selected_);
    column->addWidget(behind_);
    column->addWidget(reach_);
    auto* grid = new QGridLayout;
    grid->setSpacing(6);
    auto* remove = buttonFor(actions["clean.remove"]);
    remove->setProperty("role", "primary");
    grid->addWidget(remove, 0, 0);
    grid->addWidget(buttonFor(actions["clean.keep"]), 0, 1);
    grid->addWidget(buttonFor(actions["clean.make-object"]), 0, 2);
    grid->addWidget(buttonFor(actions["clean.invert"]), 1, 0, 1, 2);
    grid->addWidget(buttonFor(actions["clean.clear"]), 1, 2);
    column->addLayout(grid);
    return foot;
}

QWidget* CleanPanel::makeRemoved(const ActionCatalog& actions) {
    auto* part = new QWidget;
    auto* column = new QVBoxLayout(part);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    removed_ = words("removed-points", true);
    column->addWidget(removed_);
    column->addWidget(buttonFor(actions["clean.restore"]));
    return part;
}

void CleanPanel::describeSelected() {
    const std::size_t count = points_.size();
    behind_->setVisible(count > 0 && points_.behind() > 0);
    behind_->setText(
        tr("Up to %1 of them lie more than 1 m behind what is seen from there. A Depth leaves them out; "
           "none takes everything under the outline.")
            .arg(QString::fromStdString(grouped(points_.behind()))));
    if (count == 0) {
        selected_->setText(tr("Nothing is selected"));
        reach_->setText(
            tr("Draw round points with the lasso (T), or let a step find them. What is selected is "
               "shown in magenta; then remove it, keep only it, or make it an object."));
        return;
    }
    const QString by = said(points_.step().how);
    selected_->setText(
        tr("%1 points selected").arg(QString::fromStdString(grouped(count))) +
        (points_.layerCount() > 1 ? tr(" of %1 layers").arg(points_.layerCount()) : QString()));
    const auto reach = points_.reach();
    reach_->setText(reach ? tr("By %1, from %2 m to %3 m from the eye")
                                .arg(by, QString::fromStdString(fixedText(reach->first, 2)),
                                     QString::fromStdString(fixedText(reach->second, 2)))
                          : tr("By %1").arg(by));
}

void CleanPanel::describeRemoved() {
    QStringList lines;
    for (const Layer& layer : document_.state().layers) {
        if (!layer.cleaning) continue;
        QStringList steps;
        for (const CleaningStep& step : layer.cleaning->steps)
            steps << tr("%1 by %2").arg(QString::fromStdString(grouped(step.points)), said(step.how));
        lines << tr("%1: %2 of %3 points (%4)")
                     .arg(QString::fromStdString(layer.name),
                          QString::fromStdString(grouped(layer.cleaning->removed.size())),
                          QString::fromStdString(grouped(layer.cleaning->loadedPoints)), steps.join(", "));
    }
    removed_->setText(lines.isEmpty()
                          ? tr("Nothing yet. The files keep every point whatever is taken out here.")
                          : lines.join("\n"));
}

}  // namespace vestige
