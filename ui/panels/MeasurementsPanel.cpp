#include "ui/panels/MeasurementsPanel.h"

#include <QAction>
#include <QComboBox>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QTableView>
#include <QToolButton>

#include "core/measurement/MeasuredText.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/KindEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/MeasurementsModel.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

/// The methods of the measured scene in their order.
QStringList methodsOf(const MeasuredScene& measured) {
    QStringList methods;
    for (const MethodAccuracy& accuracy : measured.accuracy) methods << QString::fromStdString(accuracy.name);
    for (const MeasuredLength& length : measured.lengths)
        if (const QString method = QString::fromStdString(length.method); !methods.contains(method))
            methods << method;
    for (const MeasuredKind& kind : measured.kinds)
        if (const QString method = QString::fromStdString(kind.method);
            !kind.quantities.empty() && !methods.contains(method))
            methods << method;
    return methods;
}

QString repeatsText(const MeasuredScene& measured, const std::string& object, const std::string& method) {
    for (const MeasuredLength& length : measured.lengths) {
        if (length.object != object || length.method != method) continue;
        if (!length.length) return said(length.note);
        QStringList repeats;
        for (const double repeat : length.length->repeats_m)
            repeats << toQt(measuredText(repeat, length.length->expandedUncertainty_m).value);
        for (auto i = length.length->repeats_m.size(); i < 3; ++i) repeats << QString::fromUtf8("–");
        QString text = QObject::tr("Repeats  %1 m").arg(repeats.join(QString::fromUtf8("  ·  ")));
        if (length.length->repeatSd_m)
            text += QObject::tr("    SD %1").arg(distanceText(*length.length->repeatSd_m));
        return text;
    }
    return {};
}

/// Lets digits begin the editing of a cell, where the window would take them as shortcuts.
class TypingTable : public QTableView {
  protected:
    bool event(QEvent* event) override {
        if (event->type() == QEvent::ShortcutOverride) {
            const auto* key = static_cast<QKeyEvent*>(event);
            if (key->modifiers() == Qt::NoModifier && !key->text().isEmpty() && key->text()[0].isPrint()) {
                event->accept();
                return true;
            }
        }
        return QTableView::event(event);
    }
};

}  // namespace

MeasurementsPanel::MeasurementsPanel(Document& document, Selection& selection, Notices& notices,
                                     const ActionCatalog& actions, QWidget* parent)
    : PanelSection(tr("Measurements"), parent),
      document_(document),
      selection_(selection),
      model_(new MeasurementsModel(document, selection, this)),
      table_(new TypingTable),
      methods_(new QComboBox),
      empty_(new QLabel(tr("No lengths yet.\n\nChoose Distance above the view and click the two ends of an "
                           "object, three times. Then type what the tape says."))),
      repeats_(new QLabel),
      verified_(new QLabel) {
    methods_->setObjectName("methods");
    methods_->setAccessibleName(tr("Method"));
    methods_->setToolTip(tr("The method whose figures are shown"));
    methods_->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    addToHeading(methods_);
    auto* add = new QToolButton;
    add->setDefaultAction(&actions["object.add"]);
    add->setAutoRaise(true);
    addToHeading(add);
    makeTable();
    empty_->setProperty("role", "muted");
    empty_->setWordWrap(true);
    empty_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    empty_->setContentsMargins(12, 6, 12, 6);
    repeats_->setObjectName("repeats");
    repeats_->setProperty("role", "muted");
    repeats_->setWordWrap(true);
    repeats_->setContentsMargins(12, 6, 12, 6);
    verified_->setObjectName("verification");
    verified_->setWordWrap(true);
    verified_->setContentsMargins(12, 2, 12, 4);
    table_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(table_, &QWidget::customContextMenuRequested, this,
            [this, &actions](const QPoint& position) { showMenu(position, actions); });
    setContent(table_, 1);
    setContent(empty_, 1);
    setContent(repeats_);
    setContent(verified_);
    onPaletteChange(*this, [this] { showVerification(); });
    connect(model_, &MeasurementsModel::refused, &notices, &Notices::warned);
    connect(methods_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int index) { selection_.setMethod(methods_->itemData(index).toString().toStdString()); });
    connect(&document_, &Document::changed, this, [this] {
        fillMethods();
        follow();
    });
    connect(&selection_, &Selection::changed, this, [this] {
        fillMethods();
        table_->viewport()->update();
        follow();
    });
    fillMethods();
    follow();
}

void MeasurementsPanel::makeTable() {
    table_->setObjectName("measurements");
    table_->setAccessibleName(tr("Measurements"));
    table_->setModel(model_);
    table_->setFrameShape(QFrame::NoFrame);
    table_->setShowGrid(false);
    table_->setWordWrap(true);
    table_->setSelectionBehavior(QAbstractItemView::SelectRows);
    table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
    table_->setEditTriggers(QAbstractItemView::DoubleClicked | QAbstractItemView::EditKeyPressed |
                            QAbstractItemView::AnyKeyPressed | QAbstractItemView::SelectedClicked);
    table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    table_->verticalHeader()->hide();
    table_->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table_->verticalHeader()->setMinimumSectionSize(28);
    auto* header = table_->horizontalHeader();
    header->setHighlightSections(false);
    header->setMinimumSectionSize(40);
    header->setSectionResizeMode(QHeaderView::ResizeToContents);
    header->setSectionResizeMode(MeasurementsModel::object, QHeaderView::Stretch);
    connect(table_->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
            [this](const QModelIndex& current) {
                if (!following_ && current.isValid()) selection_.setObject(model_->objectAt(current.row()));
            });
}

void MeasurementsPanel::fillMethods() {
    const QStringList methods = methodsOf(document_.measured());
    QStringList shown;
    for (int i = 0; i < methods_->count(); ++i) shown << methods_->itemData(i).toString();
    if (methods != shown) {
        methods_->clear();
        for (const QString& method : methods) methods_->addItem(said(method.toStdString()), method);
    }
    methods_->setVisible(methods.size() > 1);
    const QString wanted = QString::fromStdString(selection_.method());
    if (!methods.isEmpty() && !methods.contains(wanted))
        selection_.setMethod(methods.front().toStdString());
    else
        methods_->setCurrentIndex(methods_->findData(wanted));
}

void MeasurementsPanel::follow() {
    following_ = true;
    const int row = model_->rowOf(selection_.object());
    if (row >= 0 && table_->currentIndex().row() != row) table_->selectRow(row);
    if (row < 0) table_->clearSelection();
    following_ = false;
    const bool any = model_->rowCount() > 0;
    table_->setVisible(any);
    empty_->setVisible(!any);
    const QString text = repeatsText(document_.measured(), selection_.object(), selection_.method());
    repeats_->setText(text);
    repeats_->setVisible(!text.isEmpty());
    showVerification();
}

void MeasurementsPanel::showVerification() {
    const auto& measured = document_.measured();
    const std::string method = selection_.method();
    verified_->setVisible(model_->rowCount() > 0);
    QColor color = quietColor(palette());
    QString text =
        tr("Not verified: no known distance of this method has been checked. Mark an object whose "
           "length is known as \"Known distance\".");
    switch (verification(measured.checks, method)) {
        case Verification::verified:
            color = goodColor(palette());
            text = tr("Verified: the known distance agrees within its tolerance.");
            break;
        case Verification::failed:
            color = aboveColor(palette());
            text = tr("CHECK FAILED:");
            for (const DistanceCheck& check : measured.checks)
                if (check.method == method && check.verdict == DistanceCheck::Verdict::failed)
                    text += tr(" %1 is off by %2, %3 allowed.")
                                .arg(toQt(check.object), distanceText(*check.difference_m),
                                     distanceText(check.tolerance_m));
            break;
        case Verification::notChecked:
            break;
    }
    QPalette colors = palette();
    colors.setColor(QPalette::WindowText, color);
    verified_->setPalette(colors);
    verified_->setText(text);
}

void MeasurementsPanel::showMenu(const QPoint& position, const ActionCatalog& actions) {
    const QModelIndex index = table_->indexAt(position);
    if (!index.isValid()) return;
    table_->setCurrentIndex(index);
    const std::string object = model_->objectAt(index.row());
    const Measurement* measurement = document_.state().measurement(object);
    if (!measurement) return;
    QMenu menu(this);
    QMenu* kinds = menu.addMenu(tr("Kind"));
    for (const KindSpec& spec : kindTable()) {
        QAction* action = kinds->addAction(said(spec.label));
        action->setCheckable(true);
        action->setChecked(spec.kind == measurement->kind);
        connect(action, &QAction::triggered, this,
                [this, object, kind = spec.kind] { document_.perform(setKind(object, kind)); });
    }
    menu.addAction(&actions["measure.check"]);
    menu.addSeparator();
    menu.addAction(&actions["object.remove-pick"]);
    menu.addAction(&actions["object.remove"]);
    menu.exec(table_->viewport()->mapToGlobal(position));
}

void MeasurementsPanel::editName(const std::string& object) {
    const int row = model_->rowOf(object);
    if (row < 0) return;
    const QModelIndex index = model_->index(row, MeasurementsModel::object);
    table_->setFocus();
    table_->setCurrentIndex(index);
    table_->edit(index);
}

}  // namespace vestige
