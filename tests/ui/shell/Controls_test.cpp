#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSlider>
#include <QAccessible>
#include <QComboBox>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QTabBar>
#include <QTextEdit>
#include <algorithm>
#include <set>

#include "tests/ui/shell/ShellFixture.h"

namespace vestige {
namespace {

bool isControl(const QWidget* widget) {
    if (qobject_cast<const QScrollBar*>(widget)) return false;
    return qobject_cast<const QAbstractButton*>(widget) || qobject_cast<const QLineEdit*>(widget) ||
           qobject_cast<const QComboBox*>(widget) || qobject_cast<const QAbstractItemView*>(widget) ||
           qobject_cast<const QAbstractSlider*>(widget) || qobject_cast<const QTabBar*>(widget) ||
           qobject_cast<const QTextEdit*>(widget);
}

/// What Qt puts into its own widgets: the list of a combo box, the arrows of a tab bar, a table's corner.
bool isInner(const QWidget* widget) {
    if (widget->objectName().startsWith("qt_") || widget->inherits("QTableCornerButton") ||
        widget->inherits("QHeaderView"))
        return true;
    for (const QWidget* parent = widget->parentWidget(); parent; parent = parent->parentWidget())
        if (qobject_cast<const QComboBox*>(parent) || qobject_cast<const QMenu*>(parent)) return true;
    return widget->parentWidget() && qobject_cast<const QTabBar*>(widget->parentWidget());
}

QString nameOf(QWidget* widget) {
    QAccessibleInterface* interface = QAccessible::queryAccessibleInterface(widget);
    return interface ? interface->text(QAccessible::Name) : QString();
}

std::string pathOf(const QWidget* widget) {
    std::string path;
    for (; widget; widget = widget->parentWidget())
        path = std::string("/") + widget->metaObject()->className() + "#" +
               widget->objectName().toStdString() + path;
    return path;
}

class Controls : public test::ShellWindow {
  public:
    void startFull() {
        startLoaded();
        driver->trigger("register.run");
        pickBox(1);
        for (const char* id : {"edit.history", "help.guide", "help.shortcuts", "compare.blink"})
            driver->trigger(id);
    }
    std::vector<QWidget*> controls() {
        std::vector<QWidget*> all;
        for (QWidget* widget : driver->window().findChildren<QWidget*>())
            if (isControl(widget) && !isInner(widget)) all.push_back(widget);
        return all;
    }
};

TEST_F(Controls, HaveANameThatAScreenReaderSays) {
    startFull();
    ASSERT_GT(controls().size(), 40u);
    for (QWidget* widget : controls()) {
        const QString name = nameOf(widget);
        const bool speaks = std::any_of(name.begin(), name.end(), [](QChar c) { return c.isLetter(); });
        EXPECT_TRUE(speaks) << pathOf(widget) << " is called '" << name.toStdString() << "'";
    }
}

TEST_F(Controls, SayWhatTheyDo) {
    startFull();
    for (const QWidget* widget : controls()) {
        const bool helps = qobject_cast<const QAbstractItemView*>(widget) ||
                           qobject_cast<const QTabBar*>(widget) || qobject_cast<const QTextEdit*>(widget);
        if (!helps) {
            EXPECT_FALSE(widget->toolTip().isEmpty() && widget->accessibleDescription().isEmpty())
                << pathOf(widget);
        }
    }
}

TEST_F(Controls, AreReachedWithTab) {
    startFull();
    const QWidget* first = driver->window().focusWidget();
    std::set<const QWidget*> reached;
    const QWidget* widget = first ? first : driver->window().nextInFocusChain();
    for (int i = 0; i < 2000; ++i) {
        if (widget->focusPolicy() & Qt::TabFocus) reached.insert(widget);
        widget = widget->nextInFocusChain();
        if (widget == first) break;
    }
    for (const char* name : {"layers", "objects", "evidence", "measurements", "history", "step-0", "step-4"})
        EXPECT_TRUE(reached.contains(driver->window().findChild<QWidget*>(name))) << name;
}

}  // namespace
}  // namespace vestige
