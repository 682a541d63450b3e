#include "ui/actions/Shortcuts.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QSettings>
#include <QTextDocument>
#include <QWidget>

#include "tests/support/TestPaths.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/actions/ShortcutSheet.h"

namespace vestige {
namespace {

class ShortcutsOfAWindow : public testing::Test {
  public:
    ShortcutsOfAWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
    }
    test::TemporaryFolder folder;
    QWidget window;
};

TEST_F(ShortcutsOfAWindow, AreThoseOfTheTableUntilTheyAreChanged) {
    ActionCatalog actions(&window);
    Shortcuts shortcuts(actions);
    for (const ActionSpec& spec : actionTable())
        EXPECT_EQ(shortcuts.of(spec.id), Shortcuts::defaultOf(spec.id)) << spec.id;
    EXPECT_TRUE(shortcuts.set("file.save", QKeySequence("Ctrl+Alt+S")));
    EXPECT_EQ(actions["file.save"].shortcut(), QKeySequence("Ctrl+Alt+S"));
    EXPECT_TRUE(actions["file.save"].toolTip().contains("Ctrl+Alt+S")) << "the tool tip follows";
    // The next window has it, too.
    QWidget other;
    ActionCatalog next(&other);
    Shortcuts again(next);
    EXPECT_EQ(again.of("file.save"), QKeySequence("Ctrl+Alt+S"));
    EXPECT_TRUE(again.reset("file.save"));
    EXPECT_EQ(again.of("file.save"), QKeySequence("Ctrl+S"));
    QWidget third;
    ActionCatalog last(&third);
    EXPECT_EQ(Shortcuts(last).of("file.save"), QKeySequence("Ctrl+S"));
}

TEST_F(ShortcutsOfAWindow, KeysBelongToOneActionOnly) {
    ActionCatalog actions(&window);
    Shortcuts shortcuts(actions);
    int told = 0;
    QObject::connect(&shortcuts, &Shortcuts::changed, &shortcuts, [&told] { ++told; });
    EXPECT_EQ(shortcuts.holder(QKeySequence("Ctrl+G"), "file.save"), "register.run");
    EXPECT_FALSE(shortcuts.set("file.save", QKeySequence("Ctrl+G")));
    EXPECT_EQ(shortcuts.of("file.save"), QKeySequence("Ctrl+S"));
    EXPECT_EQ(told, 0);
    EXPECT_TRUE(shortcuts.set("register.run", {})) << "no keys are nobody's";
    EXPECT_TRUE(shortcuts.set("file.save", QKeySequence("Ctrl+G")));
    EXPECT_FALSE(shortcuts.reset("register.run")) << "its own keys are another's now";
    shortcuts.resetAll();
    EXPECT_EQ(shortcuts.of("register.run"), QKeySequence("Ctrl+G"));
    EXPECT_EQ(shortcuts.of("file.save"), QKeySequence("Ctrl+S"));
}

TEST_F(ShortcutsOfAWindow, TheSheetHasEveryShortcut) {
    ActionCatalog actions(&window);
    Shortcuts shortcuts(actions);
    shortcuts.set("file.save", QKeySequence("Ctrl+Alt+S"));
    QTextDocument page;
    page.setHtml(shortcutSheetHtml(actions));
    for (const QString& text : {page.toPlainText(), shortcutSheetText(actions)}) {
        for (const ActionSpec& spec : actionTable()) {
            const QString keys = shortcuts.of(spec.id).toString(QKeySequence::NativeText);
            EXPECT_TRUE(text.contains(keys)) << spec.id;
        }
        EXPECT_TRUE(text.contains("Ctrl+Alt+S"));
    }
    for (const char* name : {"sheet.pdf", "sheet.html", "sheet.txt"}) {
        const QString file = QString::fromStdString((folder / name).string());
        ASSERT_TRUE(writeShortcutSheet(actions, file)) << name;
        QFile written(file);
        ASSERT_TRUE(written.open(QIODevice::ReadOnly));
        const QByteArray bytes = written.readAll();
        EXPECT_GT(bytes.size(), 500) << name;
        EXPECT_EQ(bytes.startsWith("%PDF"), QString(name).endsWith("pdf"));
    }
    const Status refused = writeShortcutSheet(actions, "sheet.doc");
    ASSERT_FALSE(refused);
    EXPECT_NE(refused.error().sentence().find(".pdf, .html or .txt"), std::string::npos);
}

}  // namespace
}  // namespace vestige
