#include <QAction>
#include <QComboBox>
#include <QFile>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTreeWidget>

#include "tests/ui/shell/ShellFixture.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

class HelpWindow : public test::ShellWindow {
  public:
    void press(int key, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        QTest::keyClick(driver->window().view().widget(), static_cast<Qt::Key>(key), modifiers);
        QApplication::processEvents();
    }
    QTreeWidgetItem* row(const QString& id) {
        auto& list = widget<QTreeWidget>("shortcuts");
        for (int i = 0; i < list.topLevelItemCount(); ++i)
            if (list.topLevelItem(i)->data(0, Qt::UserRole).toString() == id) return list.topLevelItem(i);
        return nullptr;
    }
};

TEST_F(HelpWindow, F1ShowsTheGuideInTheWindow) {
    startLoaded();
    press(Qt::Key_F1);
    auto& text = widget<QTextBrowser>("guide-text");
    ASSERT_TRUE(text.isVisible());
    EXPECT_TRUE(text.toPlainText().contains("Import"));
    auto& contents = widget<QComboBox>("guide-contents");
    ASSERT_GT(contents.count(), 4);
    EXPECT_EQ(contents.itemText(0).trimmed(), "User guide");
    auto& search = widget<QLineEdit>("guide-search");
    QTest::keyClicks(&search, "checkerboard");
    QTest::keyClick(&search, Qt::Key_Return);
    EXPECT_EQ(text.textCursor().selectedText().toLower(), "checkerboard");
    QTest::keyClick(&text, Qt::Key_Escape);
    EXPECT_FALSE(text.isVisible());
}

TEST_F(HelpWindow, TheTutorialLeadsThroughTheStepsAndItsLinksToTheGuide) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("help.tutorial"));
    auto& text = widget<QTextBrowser>("tutorial-text");
    ASSERT_TRUE(text.isVisible());
    const QString words = text.toPlainText();
    for (const char* step : {"Import", "Align", "Clean", "Measure", "Report"})
        EXPECT_TRUE(words.contains(step)) << step;
    emit text.anchorClicked(QUrl("guide.md#picking"));
    QApplication::processEvents();
    EXPECT_FALSE(text.isVisible());
    auto& guide = widget<QTextBrowser>("guide-text");
    ASSERT_TRUE(guide.isVisible());
    EXPECT_EQ(guide.textCursor().block().text(), "Picking");
}

TEST_F(HelpWindow, ShortcutsAreChangedThereAndConflictsSaidAtOnce) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("help.shortcuts"));
    auto& list = widget<QTreeWidget>("shortcuts");
    ASSERT_TRUE(row("file.save"));
    list.setCurrentItem(row("file.save"));
    auto& keys = widget<QKeySequenceEdit>("shortcut-keys");
    auto& set = widget<QPushButton>("shortcut-set");
    keys.setKeySequence(QKeySequence("Ctrl+G"));
    EXPECT_FALSE(set.isEnabled());
    EXPECT_TRUE(widget<QLabel>("shortcut-message").text().contains("belongs to \"Register\""))
        << widget<QLabel>("shortcut-message").text().toStdString();
    keys.setKeySequence(QKeySequence("Ctrl+Alt+S"));
    ASSERT_TRUE(set.isEnabled());
    QTest::mouseClick(&set, Qt::LeftButton);
    EXPECT_EQ(driver->window().findChild<QAction*>("file.save")->shortcut(), QKeySequence("Ctrl+Alt+S"));
    EXPECT_EQ(row("file.save")->text(1), "Ctrl+Alt+S");
    QTest::mouseClick(&widget<QPushButton>("shortcut-reset"), Qt::LeftButton);
    EXPECT_EQ(driver->window().findChild<QAction*>("file.save")->shortcut(), QKeySequence("Ctrl+S"));
    QTest::keyClicks(&widget<QLineEdit>("shortcut-search"), "blink");
    EXPECT_FALSE(row("compare.blink")->isHidden());
    EXPECT_TRUE(row("file.save")->isHidden());
}

TEST_F(HelpWindow, AChangedShortcutWorks) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("help.shortcuts"));
    widget<QTreeWidget>("shortcuts").setCurrentItem(row("view.edl"));
    widget<QKeySequenceEdit>("shortcut-keys").setKeySequence(QKeySequence("Ctrl+Alt+E"));
    QTest::mouseClick(&widget<QPushButton>("shortcut-set"), Qt::LeftButton);
    const QAction* edl = driver->window().findChild<QAction*>("view.edl");
    const bool before = edl->isChecked();
    press(Qt::Key_E, Qt::ControlModifier | Qt::AltModifier);
    EXPECT_NE(edl->isChecked(), before);
    press(Qt::Key_E);
    EXPECT_NE(edl->isChecked(), before) << "the old key does nothing any more";
}

TEST_F(HelpWindow, TheSheetIsWrittenAndTheScreenFilled) {
    startLoaded();
    driver->answers().sheet = path("keys.html");
    ASSERT_TRUE(driver->trigger("help.shortcut-sheet"));
    EXPECT_TRUE(QFile::exists(path("keys.html")));
    press(Qt::Key_F11);
    EXPECT_TRUE(driver->window().isFullScreen());
    press(Qt::Key_F11);
    EXPECT_FALSE(driver->window().isFullScreen());
}

TEST_F(HelpWindow, TIsFreeAndTintsWithAlt) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("register.run"));
    const QAction* tint = driver->window().findChild<QAction*>("register.tint");
    const bool before = tint->isChecked();
    press(Qt::Key_T, Qt::AltModifier);
    EXPECT_NE(tint->isChecked(), before);
}

}  // namespace
}  // namespace vestige
