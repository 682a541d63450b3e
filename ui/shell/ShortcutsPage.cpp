#include "ui/shell/ShortcutsPage.h"

#include <QAction>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/Shortcuts.h"
#include "ui/panels/ActionButtons.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
namespace {

QString plain(QString text) {
    return text.remove('&').remove(QChar(0x2026));
}

QString nativeText(const QKeySequence& keys) {
    return keys.toString(QKeySequence::NativeText);
}

QPushButton* button(const QString& text, const QString& tip) {
    auto* made = new QPushButton(text);
    made->setToolTip(tip);
    return made;
}

}  // namespace

ShortcutsPage::ShortcutsPage(const ActionCatalog& actions, Shortcuts& shortcuts, QWidget* parent)
    : QWidget(parent),
      actions_(actions),
      shortcuts_(shortcuts),
      search_(new QLineEdit),
      list_(new QTreeWidget),
      keys_(new QKeySequenceEdit),
      message_(new QLabel),
      set_(button(tr("Set"), tr("Give the chosen action these keys"))),
      none_(button(tr("None"), tr("Take the chosen action's shortcut away"))),
      reset_(button(tr("Reset"), tr("Give the chosen action the keys that it came with"))) {
    search_->setObjectName("shortcut-search");
    search_->setPlaceholderText(tr("Search actions and keys"));
    search_->setToolTip(tr("Words of an action, or keys"));
    search_->setAccessibleName(tr("Search shortcuts"));
    list_->setObjectName("shortcuts");
    list_->setAccessibleName(tr("Shortcuts"));
    list_->setToolTip(tr("Choose an action to change its shortcut"));
    list_->setColumnCount(2);
    list_->setHeaderHidden(true);
    list_->setFrameShape(QFrame::NoFrame);
    list_->setIndentation(0);
    list_->setRootIsDecorated(false);
    list_->setUniformRowHeights(true);
    list_->header()->setStretchLastSection(false);
    list_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    keys_->setObjectName("shortcut-keys");
    keys_->setToolTip(tr("Press the new keys here"));
    keys_->setAccessibleName(tr("Keys of the chosen action"));
    keys_->setFocusPolicy(Qt::StrongFocus);
    if (auto* line = keys_->findChild<QLineEdit*>()) {
        line->setAccessibleName(keys_->accessibleName());
        line->setToolTip(keys_->toolTip());
    }
    message_->setObjectName("shortcut-message");
    message_->setWordWrap(true);
    message_->setProperty("role", "muted");
    set_->setObjectName("shortcut-set");
    set_->setProperty("role", "primary");
    none_->setObjectName("shortcut-none");
    reset_->setObjectName("shortcut-reset");
    auto* all = button(tr("Reset all"), tr("Give every action the keys that it came with"));
    all->setObjectName("shortcut-reset-all");

    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 10, 10);
    column->setSpacing(8);
    column->addWidget(search_);
    column->addWidget(list_, 1);
    auto* edit = new QHBoxLayout;
    edit->setSpacing(6);
    edit->addWidget(keys_, 1);
    edit->addWidget(set_);
    edit->addWidget(none_);
    edit->addWidget(reset_);
    column->addLayout(edit);
    column->addWidget(message_);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(6);
    foot->addWidget(all);
    foot->addStretch(1);
    foot->addWidget(buttonFor(actions["help.shortcut-sheet"]));
    column->addLayout(foot);
    setFocusProxy(search_);

    connect(search_, &QLineEdit::textChanged, this, [this] { filter(); });
    connect(list_, &QTreeWidget::currentItemChanged, this, [this] { showChosen(); });
    connect(keys_, &QKeySequenceEdit::keySequenceChanged, this, [this](const QKeySequence& pressed) {
        // One stroke; those that follow within a second belong to sequences, which the program has none of.
        if (pressed.count() > 1) return keys_->setKeySequence(QKeySequence(pressed[0]));
        judge(pressed);
    });
    connect(set_, &QPushButton::clicked, this, [this] { shortcuts_.set(chosen(), keys_->keySequence()); });
    connect(none_, &QPushButton::clicked, this, [this] { shortcuts_.set(chosen(), {}); });
    connect(reset_, &QPushButton::clicked, this, [this] {
        if (!shortcuts_.reset(chosen())) keys_->setKeySequence(Shortcuts::defaultOf(chosen()));
    });
    connect(all, &QPushButton::clicked, &shortcuts_, &Shortcuts::resetAll);
    connect(&shortcuts_, &Shortcuts::changed, this, [this] { fill(); });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

std::string ShortcutsPage::chosen() const {
    const QTreeWidgetItem* row = list_->currentItem();
    return row ? row->data(0, Qt::UserRole).toString().toStdString() : std::string();
}

void ShortcutsPage::fill() {
    const std::string before = chosen();
    list_->clear();
    QString menu;
    for (const ActionSpec& spec : actionTable()) {
        if (const QString title = plain(actions_.menuText(spec)); title != menu) {
            menu = title;
            auto* heading = new QTreeWidgetItem({title, {}});
            heading->setFlags(Qt::ItemIsEnabled);
            heading->setForeground(0, quietColor(palette()));
            QFont font = list_->font();
            font.setWeight(QFont::DemiBold);
            heading->setFont(0, font);
            list_->addTopLevelItem(heading);
        }
        const QKeySequence keys = shortcuts_.of(spec.id);
        auto* row = new QTreeWidgetItem({plain(actions_.text(spec)), nativeText(keys)});
        row->setIcon(0, actions_[spec.id].icon());
        row->setData(0, Qt::UserRole, QString(spec.id));
        row->setToolTip(0, actions_[spec.id].statusTip());
        row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
        const bool changed = keys != Shortcuts::defaultOf(spec.id);
        if (changed)
            row->setToolTip(1, tr("Changed; it came with %1").arg(nativeText(Shortcuts::defaultOf(spec.id))));
        row->setForeground(1, changed ? aboveColor(palette()) : quietColor(palette()));
        list_->addTopLevelItem(row);
        if (spec.id == before) list_->setCurrentItem(row);
    }
    filter();
    showChosen();
}

void ShortcutsPage::filter() {
    const QString wanted = search_->text().trimmed();
    QTreeWidgetItem* heading = nullptr;
    for (int i = 0; i < list_->topLevelItemCount(); ++i) {
        QTreeWidgetItem* row = list_->topLevelItem(i);
        if (row->data(0, Qt::UserRole).isNull()) {
            heading = row;
            heading->setHidden(true);
            continue;
        }
        const bool shown = wanted.isEmpty() || row->text(0).contains(wanted, Qt::CaseInsensitive) ||
                           row->text(1).compare(wanted, Qt::CaseInsensitive) == 0;
        row->setHidden(!shown);
        if (shown && heading) heading->setHidden(false);
    }
}

void ShortcutsPage::showChosen() {
    const std::string id = chosen();
    for (QWidget* widget :
         {static_cast<QWidget*>(keys_), static_cast<QWidget*>(none_), static_cast<QWidget*>(reset_)})
        widget->setEnabled(!id.empty());
    keys_->setKeySequence(id.empty() ? QKeySequence() : shortcuts_.of(id));
    judge(keys_->keySequence());
}

void ShortcutsPage::judge(const QKeySequence& keys) {
    const std::string id = chosen();
    const auto taken = id.empty() ? std::nullopt : shortcuts_.holder(keys, id);
    set_->setEnabled(!id.empty() && !taken && !keys.isEmpty() && keys != shortcuts_.of(id));
    if (id.empty())
        message_->setText(tr("Choose an action to change its shortcut."));
    else if (taken)
        message_->setText(tr("%1 belongs to \"%2\": choose other keys, or take them from it first.")
                              .arg(nativeText(keys), plain(actions_[*taken].text())));
    else
        message_->setText(actions_[id].statusTip());
}

}  // namespace vestige
