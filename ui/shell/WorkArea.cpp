#include "ui/shell/WorkArea.h"

#include <QScrollArea>
#include <QSplitter>
#include <QTabWidget>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Evidence.h"
#include "ui/panels/AccuracyPanel.h"
#include "ui/panels/AlignPanel.h"
#include "ui/panels/BudgetPanel.h"
#include "ui/panels/EvidencePanel.h"
#include "ui/panels/FitPanel.h"
#include "ui/panels/LayersPanel.h"
#include "ui/panels/MeasurementsPanel.h"
#include "ui/panels/ObjectsPanel.h"
#include "ui/panels/RegistrationStrip.h"
#include "ui/panels/ViewsPanel.h"
#include "ui/shell/CompareBar.h"
#include "ui/shell/NoticeBar.h"
#include "ui/shell/ToolPalette.h"
#include "ui/shell/ToolSwitch.h"
#include "ui/shell/ViewArea.h"
#include "ui/shell/WelcomePage.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

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
    column->addWidget(new NoticeBar(bench_.notices));
    column_ = column;
    auto* splitter = new QSplitter(Qt::Horizontal);
    splitter->setHandleWidth(1);
    splitter->setChildrenCollapsible(false);
    splitter->addWidget(makeLeft());
    splitter->addWidget(makeMiddle());
    splitter->addWidget(makeRight());
    splitter->setStretchFactor(0, 0);
    splitter->setStretchFactor(1, 1);
    splitter->setStretchFactor(2, 0);
    splitter->setSizes({240, 742, 418});
    column->addWidget(splitter, 1);
}

void WorkArea::addBar(QWidget* bar) {
    column_->insertWidget(0, bar);
}

QWidget* WorkArea::makeLeft() {
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = columnIn(content, 12);
    column->setContentsMargins(0, 6, 0, 10);
    column->addWidget(new LayersPanel(bench_.document, bench_.selection));
    column->addWidget(new ObjectsPanel(bench_.document, bench_.selection));
    column->addWidget(new EvidencePanel(bench_.document, bench_.evidence));
    column->addWidget(new ViewsPanel(bench_.actions));
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setMinimumWidth(190);
    return scroll;
}

QWidget* WorkArea::makeMiddle() {
    auto* middle = new QWidget;
    auto* column = columnIn(middle);
    auto* area = new ViewArea;
    area->setView(view_.widget());
    connect(area, &ViewArea::arranged, &view_, [this, area] { view_.setCovered(area->covered()); });
    area->setTools(new ToolPalette(bench_.actions, bench_.presentation));
    area->setBar(new CompareBar(bench_.actions, bench_.comparison, bench_.preview));
    auto* welcome = new WelcomePage(bench_.actions, bench_.recent);
    area->setWelcome(welcome);
    connect(welcome, &WelcomePage::chosen, this, &WorkArea::chosen);
    connect(&tools_.measure(), &MeasureTool::hintChanged, area, &ViewArea::setHint);
    connect(&tools_.path(), &PathTool::hintChanged, area, &ViewArea::setHint);
    const auto follow = [this, area] { area->showWelcome(bench_.document.state().layers.empty()); };
    connect(&bench_.document, &Document::changed, area, follow);
    follow();
    column->addWidget(area, 1);
    column->addWidget(new RegistrationStrip(bench_.document, bench_.selection, bench_.attempts));
    return middle;
}

QWidget* WorkArea::makeRight() {
    auto* measure = new QWidget;
    auto* column = columnIn(measure, 4);
    column->setContentsMargins(0, 6, 0, 0);
    auto* table = new MeasurementsPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions);
    connect(&tools_.measure(), &MeasureTool::objectCreated, table, &MeasurementsPanel::editName);
    column->addWidget(table, 1);
    connect(&tools_.path(), &PathTool::objectCreated, table, &MeasurementsPanel::editName);
    column->addWidget(new BudgetPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions), 1);
    column->addWidget(new AccuracyPanel(bench_.document, bench_.selection));
    auto* tabs = new QTabWidget;
    tabs->setObjectName("right");
    tabs->setDocumentMode(true);
    tabs->addTab(measure, tr("Measure"));
    tabs->addTab(new AlignPanel(bench_.document, bench_.selection, bench_.notices, bench_.actions),
                 tr("Align"));
    tabs->addTab(
        new FitPanel({bench_.document, bench_.selection, bench_.attempts, bench_.trace, bench_.preview},
                     bench_.actions),
        tr("Fit"));
    tabs->setMinimumWidth(340);
    for (const auto& [id, index] : {std::pair("view.panel-measure", 0), std::pair("view.panel-align", 1),
                                    std::pair("view.panel-fit", 2)})
        bench_.actions.onTriggered(id, [tabs, index = index] { tabs->setCurrentIndex(index); });
    return tabs;
}

}  // namespace vestige
