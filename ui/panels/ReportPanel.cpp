#include "ui/panels/ReportPanel.h"

#include <QDesktopServices>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <QUrl>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Outputs.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/CaseForm.h"
#include "ui/panels/PanelSection.h"
#include "ui/panels/StepsList.h"

namespace vestige {
namespace {

/// File and what it holds, as the contract of the main job lists them.
QWidget* contentsList() {
    auto* list = new CompactList({});
    QTreeWidget& tree = list->tree();
    tree.setObjectName("report-contents");
    tree.setAccessibleName(QObject::tr("Files of a report"));
    tree.setSelectionMode(QAbstractItemView::NoSelection);
    tree.setFocusPolicy(Qt::NoFocus);
    const std::pair<const char*, QString> rows[] = {
        {"report.pdf", QObject::tr("method, lengths, errors, pictures")},
        {"measurements.csv", QObject::tr("every length, every digit")},
        {"quantities.csv", QObject::tr("every figure of every kind")},
        {"uncertainty.csv", QObject::tr("what each uncertainty is made of")},
        {"accuracy.csv", QObject::tr("errors by method")},
        {"registration.json", QObject::tr("poses and what they are worth")},
        {"fused.las", QObject::tr("all registered scans as one cloud")},
        {"screenshots", QObject::tr("the scene and each object")},
        {"manifest.json", QObject::tr("hashes of inputs and outputs")},
    };
    for (const auto& [file, what] : rows) {
        auto* row = new QTreeWidgetItem({file, what});
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        for (const int column : {0, 1}) row->setToolTip(column, file + QString(": ") + what);
        tree.addTopLevelItem(row);
    }
    // Names whole; of what they hold the end gives way.
    tree.header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    tree.header()->setSectionResizeMode(1, QHeaderView::Stretch);
    list->fit();
    return list;
}

}  // namespace

ReportPanel::ReportPanel(Document& document, Notices& notices, Outputs& outputs, const ActionCatalog& actions,
                         QWidget* parent)
    : QWidget(parent),
      document_(document),
      outputs_(outputs),
      missing_(new StepsList),
      written_(new CompactList(
          tr("Nothing was written in this session. Export report (Ctrl+R) makes a folder."))) {
    auto* content = new QWidget;
    content->setObjectName("panel-content");
    auto* column = new QVBoxLayout(content);
    column->setContentsMargins(0, 6, 0, 6);
    column->setSpacing(6);
    addSection(*column, tr("Case"), new CaseForm(document, notices));
    addSection(*column, tr("Missing"), missing_);
    auto* contents = new PanelSection(tr("What is written"));
    contents->setContent(contentsList());
    column->addWidget(contents);
    auto* written = new PanelSection(tr("Written"));
    written_->tree().setObjectName("outputs");
    written_->tree().setAccessibleName(tr("Outputs of this session"));
    written_->tree().setToolTip(tr("A double click, or Return, opens it"));
    written->setContent(written_);
    column->addWidget(written);
    column->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setWidget(content);
    scroll->setWidgetResizable(true);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);

    auto* report = buttonFor(actions["export.report"]);
    report->setProperty("role", "primary");
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(0, 0, 0, 0);
    whole->addWidget(scroll, 1);
    auto* foot = new QHBoxLayout;
    foot->setContentsMargins(12, 6, 12, 8);
    foot->setSpacing(8);
    foot->addWidget(buttonFor(actions["file.verify"]), 1);
    foot->addWidget(buttonFor(actions["export.csv"]), 1);
    whole->addLayout(foot);
    auto* last = new QHBoxLayout;
    last->setContentsMargins(12, 0, 12, 12);
    last->addWidget(report);
    whole->addLayout(last);

    connect(missing_, &StepsList::chosen, this, &ReportPanel::stepWanted);
    connect(&written_->tree(), &QTreeWidget::itemActivated, this, [](QTreeWidgetItem* row) {
        QDesktopServices::openUrl(QUrl::fromLocalFile(row->data(0, Qt::UserRole).toString()));
    });
    connect(&document_, &Document::changed, this, [this] { follow(); });
    connect(&outputs_, &Outputs::changed, this, [this] {
        follow();
        fillOutputs();
    });
    follow();
    fillOutputs();
}

void ReportPanel::follow() {
    missing_->setSteps(stepsOf(document_.state(), document_.measured(), outputs_.reported()));
}

void ReportPanel::fillOutputs() {
    written_->tree().clear();
    for (const Outputs::Output& output : outputs_.all()) {
        auto* row =
            new QTreeWidgetItem({QFileInfo(output.path).fileName(), output.written.toString("HH:mm:ss")});
        row->setData(0, Qt::UserRole, output.path);
        row->setToolTip(0, output.path);
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        written_->tree().addTopLevelItem(row);
    }
    written_->fit();
}

}  // namespace vestige
