#include "ui/shell/WorkArea.h"

#include <QAction>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>
#include <algorithm>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/reactions/CleaningReactions.h"
#include "ui/document/Document.h"
#include "ui/document/Evidence.h"
#include "ui/panels/AccuracyPanel.h"
#include "ui/panels/AlignPanel.h"
#include "ui/panels/BudgetPanel.h"
#include "ui/panels/CleanPanel.h"
#include "ui/panels/EvidencePanel.h"
#include "ui/panels/FitPanel.h"
#include "ui/panels/HistoryPanel.h"
#include "ui/panels/ImportPanel.h"
#include "ui/panels/LayersPanel.h"
#include "ui/panels/MeasurementsPanel.h"
#include "ui/panels/ObjectsPanel.h"
#include "ui/panels/PartsPanel.h"
#include "ui/panels/RegistrationStrip.h"
#include "ui/panels/ReportPanel.h"
#include "ui/panels/ViewsPanel.h"
#include "ui/shell/CleaningTools.h"
#include "ui/shell/CompareBar.h"
#include "ui/shell/EmptyCasePage.h"
#include "ui/shell/NoticeBar.h"
#include "ui/shell/SnapButton.h"
#include "ui/shell/StepBar.h"
#include "ui/shell/StepTabs.h"
#include "ui/shell/ToolPalette.h"
#include "ui/shell/ToolSwitch.h"
#include "ui/shell/ViewArea.h"
#include "ui/shell/WelcomePage.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr int kLeft_px = 204;
constexpr int kRight_px = 356;
constexpr int kRoomForChart_px = 660;
constexpr int kRoomForLeft_px = kLeft_px + kRight_px + 300;

QVBoxLayout* columnIn(QWidget* widget, int spacing = 0) {
    auto* column = new QVBoxLayout(widget);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(spacing);
    return column;
}

}  // namespace

WorkArea::WorkArea(const Workbench& bench, SceneView& view, ToolSwitch& tools, QWidget* parent)
    : QWidget(parent), bench_(bench), view_(view), tools_(tools) {
    auto* column = columnIn(this);
    steps_ = new StepBar(bench_.document, bench_.outputs);
    column->addWidget(steps_);
    column->addWidget(new NoticeBar(bench_.notices));
    column_ = column;
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setHandleWidth(1);
    splitter->setChildrenCollapsible(false);
    left_ = makeLeft();
    splitter->addWidget(left_);
    splitter->addWidget(makeMiddle());
    splitter->addWidget(makeRight());
    // In a smaller window the panels give way down to what they need, then the view.
    splitter->setStretchFactor(0, 1);
    splitter->setStretchFactor(1, 3);
    splitter->setStretchFactor(2, 1);
    splitter->setSizes({246, 738, 416});
    column->addWidget(splitter, 1);
    connect(steps_, &StepBar::chosen, tabs_, &StepTabs::showStep);
    connect(steps_, &StepBar::chosen, this, [this] { arriving_ = false; });
    connect(tabs_, &StepTabs::stepShown, steps_, &StepBar::setShown);
    steps_->setShown(WayStep::measure);
    connect(&bench_.document, &Document::replaced, this, [this] {
        begun_ = false;
        arriving_ = !bench_.document.state().layers.empty();
    });
    connect(&bench_.document, &Document::changed, this, [this] { follow(); });
    connect(&bench_.actions["file.new"], &QAction::triggered, this, [this] {
        begun_ = bench_.document.state().layers.empty();
        if (begun_) tabs_->showStep(WayStep::import);
        follow();
    });
    // Less than all of it needs: the left goes first.
    setMinimumWidth(600);
    follow();
}

void WorkArea::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    showLeft();
    // In a low window the table needs the room.
    accuracy_->setCompact(height() < kRoomForChart_px);
}

/// Beside a help dock in a small window there is no room for three columns.
void WorkArea::showLeft() {
    left_->setVisible(begun_ && width() >= kRoomForLeft_px);
}

void WorkArea::follow() {
    const SceneState& scene = bench_.document.state();
    const bool empty = scene.layers.empty();
    // A case opens at what is to be done next.
    if (arriving_ && std::any_of(scene.layers.begin(), scene.layers.end(),
                                 [](const Layer& layer) { return layer.data != nullptr; })) {
        arriving_ = false;
        tabs_->showStep(steps_->next());
    }
    begun_ = begun_ || !empty || bench_.document.canUndo() || bench_.document.canRedo() ||
             !scene.file.empty() || !scene.measurements.empty();
    viewArea_->showWelcome(empty);
    empty_->setCurrentIndex(begun_ ? 1 : 0);
    for (QWidget* widget : {static_cast<QWidget*>(steps_), static_cast<QWidget*>(tabs_)})
        widget->setVisible(begun_);
    showLeft();
    strip_->setVisible(begun_);
}

void WorkArea::addBar(QWidget* bar) {
    column_->insertWidget(1, bar);
}

void WorkArea::follow(CleaningTools& tools, CleaningReactions& reactions) {
    connect(&tools, &CleaningTools::hintChanged, viewArea_, &ViewArea::setHint);
    connect(&reactions, &CleaningReactions::objectMade, parts_, &PartsPanel::editName);
}

QWidget* WorkArea::makeLeft() {
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = columnIn(content, 12);
    column->setContentsMargins(0, 6, 0, 10);
    column->addWidget(new LayersPanel(bench_.document, bench_.selection));
    column->addWidget(new ObjectsPanel(bench_.document, bench_.selection));
    parts_ = new PartsPanel(bench_.document, bench_.points, bench_.actions);
    column->addWidget(parts_);
    column->addWidget(new EvidencePanel(bench_.document, bench_.evidence));
    viewsPanel_ = new ViewsPanel(bench_.actions, bench_.document);
    column->addWidget(viewsPanel_);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    auto* history = new HistoryPanel(bench_.history, bench_.actions);
    history->setFixedHeight(250);
    history->hide();
    bench_.actions.onToggled("edit.history", [history](bool on) {
        history->setVisible(on);
        if (on) history->findChild<QWidget*>("history")->setFocus();
    });
    auto* left = new QWidget;
    auto* parts = columnIn(left);
    parts->addWidget(scroll, 1);
    parts->addWidget(history);
    left->setMinimumWidth(kLeft_px);
    return left;
}

QWidget* WorkArea::makeMiddle() {
    auto* middle = new QWidget;
    auto* column = columnIn(middle);
    auto* area = new ViewArea;
    viewArea_ = area;
    area->setView(view_.widget());
    connect(area, &ViewArea::arranged, &view_, [this, area] { view_.setCovered(area->covered()); });
    area->setTools(new ToolPalette(bench_.actions, bench_.presentation));
    area->addBar(new CompareBar(bench_.actions, bench_.comparison, bench_.preview));
    auto* welcome = new WelcomePage(bench_.actions, bench_.recent);
    empty_ = new QStackedWidget;
    empty_->addWidget(welcome);
    empty_->addWidget(new EmptyCasePage(bench_.document, bench_.notices, bench_.actions));
    area->setWelcome(empty_);
    connect(welcome, &WelcomePage::chosen, this, &WorkArea::chosen);
    auto* snap = new SnapButton(bench_.actions);
    area->setChooser(snap);
    connect(&tools_, &ToolSwitch::picking, area, &ViewArea::showChooser);
    connect(&tools_, &ToolSwitch::hintChanged, area, &ViewArea::setHint);
    column->addWidget(area, 1);
    strip_ = new RegistrationStrip(bench_.document, bench_.selection, bench_.attempts);
    column->addWidget(strip_);
    return middle;
}

QWidget* WorkArea::makeRight() {
    auto* measure = new QWidget;
    auto* column = columnIn(measure, 4);
    column->setContentsMargins(0, 6, 0, 0);
    auto* table = new MeasurementsPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions);
    connect(&tools_.measure(), &MeasureTool::objectCreated, table, [this, table](const std::string& object) {
        tabs_->showStep(WayStep::measure);
        table->editName(object);
    });
    column->addWidget(table, 1);
    connect(&tools_.path(), &PathTool::objectCreated, table, [this, table](const std::string& object) {
        tabs_->showStep(WayStep::measure);
        table->editName(object);
    });
    accuracy_ = new AccuracyPanel(bench_.document, bench_.selection);
    column->addWidget(accuracy_);
    auto* tabs = new StepTabs;
    tabs_ = tabs;
    tabs->setObjectName("right");
    tabs->addPanel(WayStep::measure, measure, tr("Measurements"));
    tabs->addPanel(WayStep::align,
                   new AlignPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions),
                   tr("Registration"));
    tabs->addPanel(
        WayStep::align,
        new FitPanel({bench_.document, bench_.selection, bench_.attempts, bench_.trace, bench_.preview},
                     bench_.actions),
        tr("Fit"));
    tabs->addPanel(WayStep::import, new ImportPanel(bench_.document, bench_.selection, bench_.actions),
                   tr("Import"));
    tabs->addPanel(WayStep::clean,
                   new CleanPanel(bench_.document, bench_.selection, bench_.points, bench_.cleaning,
                                  bench_.notices, bench_.actions),
                   tr("Clean"));
    auto* report = new ReportPanel(bench_.document, bench_.notices, bench_.outputs, bench_.actions);
    tabs->addPanel(WayStep::report, report, tr("Report"));
    tabs->addPanel(WayStep::measure,
                   new BudgetPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions),
                   tr("Selected object"));
    connect(report, &ReportPanel::stepWanted, tabs, &StepTabs::showStep);
    tabs->setMinimumWidth(kRight_px);
    for (const auto& [id, index] :
         {std::pair("view.panel-measure", 0), std::pair("view.panel-align", 1),
          std::pair("view.panel-fit", 2), std::pair("view.panel-import", 3), std::pair("view.panel-clean", 4),
          std::pair("view.panel-report", 5), std::pair("view.panel-object", 6)})
        bench_.actions.onTriggered(id, [tabs, index = index] { tabs->setCurrentIndex(index); });
    return tabs;
}

}  // namespace vestige
