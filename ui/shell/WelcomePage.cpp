#include "ui/shell/WelcomePage.h"

#include <QAction>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/RecentFiles.h"
#include "ui/document/Steps.h"
#include "ui/panels/PanelColors.h"
#include "ui/shell/StartButton.h"

namespace vestige {
namespace {

QLabel* text(const QString& words, const QString& role) {
    auto* label = new QLabel(words);
    label->setProperty("role", role);
    label->setWordWrap(true);
    return label;
}

/// "today 14:02", "yesterday 9:15", "17 Mar 2025".
QString dateText(const QDateTime& when) {
    if (!when.isValid()) return {};
    const qint64 days = when.date().daysTo(QDate::currentDate());
    if (days == 0) return QObject::tr("today %1").arg(when.toString("HH:mm"));
    if (days == 1) return QObject::tr("yesterday %1").arg(when.toString("HH:mm"));
    return QLocale().toString(when.date(), "d MMM yyyy");
}

/// A case lies in its folder as case.json: the folder's name says more.
QString nameOf(const QFileInfo& file) {
    return file.fileName() == "case.json" ? file.dir().dirName() : file.completeBaseName();
}

QString placeOf(const QFileInfo& file) {
    QString folder = file.path();
    const QString home = QDir::homePath();
    if (folder == home || folder.startsWith(home + "/")) folder.replace(0, home.size(), "~");
    return folder;
}

}  // namespace

WelcomePage::WelcomePage(const ActionCatalog& actions, RecentFiles& recent, QWidget* parent)
    : QWidget(parent),
      recent_(recent),
      list_(new QTreeWidget),
      none_(text(tr("Cases and scans that you open will stand here."), "muted")) {
    setObjectName("welcome");
    setAttribute(Qt::WA_StyledBackground);
    auto* begin = new QVBoxLayout;
    begin->setSpacing(10);
    begin->addWidget(text(tr("Begin"), "heading"));
    begin->addWidget(
        new StartButton(actions["file.new"], tr("New case"), tr("Name it and add its scans"), true));
    begin->addWidget(new StartButton(actions["file.open-case"], tr("Open case"),
                                     tr("A saved case, .vestige or case.json"), false));
    begin->addWidget(new StartButton(actions["file.add-files"], tr("Open scans"),
                                     tr("Look at clouds and meshes at once"), false));
    begin->addWidget(new StartButton(actions["file.sample"], tr("Sample case"),
                                     tr("A night collision with known lengths"), false));
    begin->addStretch(1);
    list_->setObjectName("recent");
    list_->setAccessibleName(tr("Recent cases and files"));
    list_->setToolTip(tr("A click, or Return, opens it"));
    list_->setColumnCount(3);
    list_->setHeaderHidden(true);
    list_->setRootIsDecorated(false);
    list_->setIndentation(0);
    list_->setUniformRowHeights(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    list_->setTextElideMode(Qt::ElideMiddle);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::ResizeToContents);
    list_->header()->setSectionResizeMode(1, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(2, QHeaderView::ResizeToContents);
    auto* last = new QVBoxLayout;
    last->setSpacing(10);
    last->addWidget(text(tr("Recent"), "heading"));
    last->addWidget(list_, 1);
    last->addWidget(none_);
    last->addStretch(0);
    auto* columns = new QHBoxLayout;
    columns->setSpacing(36);
    columns->addLayout(begin, 4);
    columns->addLayout(last, 6);

    auto* card = new QWidget;
    card->setMaximumWidth(940);
    card->setMinimumWidth(700);
    card->setMinimumHeight(470);
    auto* column = new QVBoxLayout(card);
    column->setSpacing(6);
    column->addWidget(text(tr("From scans to a report that stands up in court"), "title"));
    column->addWidget(
        text(tr("Everything happens on this computer; files are only ever read, and each is hashed. "
                "Scans and cases can also be dropped into the window."),
             "muted"));
    column->addSpacing(20);
    column->addLayout(columns, 1);
    column->addSpacing(14);
    column->addWidget(makeWay());
    auto* whole = new QVBoxLayout(this);
    whole->setContentsMargins(40, 28, 40, 28);
    whole->addStretch(2);
    auto* middle = new QHBoxLayout;
    middle->addStretch(1);
    middle->addWidget(card, 100);
    middle->addStretch(1);
    whole->addLayout(middle, 10);
    whole->addStretch(3);

    const auto chose = [this](const QTreeWidgetItem* row) {
        // What is opened may change the list that reports the click.
        const QString path = row->data(0, Qt::UserRole).toString();
        const bool exists = row->data(1, Qt::UserRole).toBool();
        QMetaObject::invokeMethod(
            this, [this, path, exists] { choose(path, exists); }, Qt::QueuedConnection);
    };
    connect(list_, &QTreeWidget::itemClicked, this, chose);
    connect(list_, &QTreeWidget::itemActivated, this, chose);
    connect(&recent_, &RecentFiles::changed, this, [this] { fillRecent(); });
    onPaletteChange(*this, [this] { fillRecent(); });
    fillRecent();
}

QWidget* WelcomePage::makeWay() const {
    auto* way = new QWidget;
    auto* row = new QHBoxLayout(way);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(18);
    const std::pair<WayStep, QString> steps[] = {
        {WayStep::import, tr("Scans of any scanner; the first is the frame")},
        {WayStep::align, tr("Register them, and see whether the fit is good")},
        {WayStep::clean, tr("Take away what disturbs; the files stay")},
        {WayStep::measure, tr("Three repeats each, with their uncertainty")},
        {WayStep::report, tr("PDF, tables, pictures and every hash")},
    };
    for (const auto& [step, words] : steps) {
        auto* part = new QVBoxLayout;
        part->setSpacing(2);
        part->addWidget(
            text(QString("%1  %2").arg(static_cast<int>(step) + 1).arg(titleOf(step)), "figure-small"));
        part->addWidget(text(words, "caption"));
        part->addStretch(1);
        row->addLayout(part, 1);
    }
    return way;
}

void WelcomePage::fillRecent() {
    list_->clear();
    for (const RecentFiles::Entry& entry : recent_.entries()) {
        const QFileInfo file(entry.path);
        auto* row = new QTreeWidgetItem;
        row->setText(0, nameOf(file));
        row->setText(1, placeOf(file));
        row->setText(2, entry.exists ? dateText(entry.opened) : tr("not found"));
        row->setTextAlignment(2, Qt::AlignRight | Qt::AlignVCenter);
        row->setForeground(1, quietColor(palette()));
        row->setForeground(2, entry.exists ? quietColor(palette()) : aboveColor(palette()));
        if (!entry.exists) row->setForeground(0, quietColor(palette()));
        row->setData(0, Qt::UserRole, entry.path);
        row->setData(1, Qt::UserRole, entry.exists);
        const QString tip = entry.exists
                                ? entry.path
                                : tr("%1 is not there now. A click takes it off the list.").arg(entry.path);
        for (int column = 0; column < 3; ++column) row->setToolTip(column, tip);
        list_->addTopLevelItem(row);
    }
    const bool any = list_->topLevelItemCount() > 0;
    list_->setVisible(any);
    none_->setVisible(!any);
}

void WelcomePage::choose(const QString& path, bool exists) {
    // It may have been plugged in meanwhile.
    if (exists || QFileInfo::exists(path))
        emit chosen(path);
    else
        recent_.remove(path);
}

}  // namespace vestige
