#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <QAbstractButton>
#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QSettings>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/Translation.h"
#include "core/scene/Scene.h"
#include "tests/support/EnglishLeft.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/actions/ActionText.h"
#include "ui/document/Document.h"
#include "ui/document/LanguageSetting.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/shell/UseLanguage.h"

namespace vestige {
namespace {

class LanguageWindow : public testing::Test {
  public:
    LanguageWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        QSettings().clear();
        scans = test::writeSampleScans(folder.path());
    }
    ~LanguageWindow() override {
        driver.reset();
        useLanguage(Language::english);
    }

    void start(Language language) {
        driver.reset();
        useLanguage(language);
        driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    }

    /// Every text of the window, shown or not, with where it stands.
    std::vector<std::pair<QString, QString>> texts() {
        std::vector<std::pair<QString, QString>> found;
        const auto add = [&](const QObject* where, const QString& text) {
            if (!text.isEmpty())
                found.emplace_back(where->metaObject()->className() + (" " + where->objectName()), text);
        };
        for (const QAction* action : driver->window().findChildren<QAction*>()) {
            add(action, withoutMnemonic(action->text()));
            add(action, action->toolTip());
            add(action, action->statusTip());
        }
        for (const QWidget* widget : driver->window().findChildren<QWidget*>()) {
            add(widget, widget->toolTip());
            add(widget, widget->accessibleName());
            if (const auto* label = qobject_cast<const QLabel*>(widget)) add(label, label->text());
            if (const auto* button = qobject_cast<const QAbstractButton*>(widget))
                add(button, button->text());
            if (const auto* field = qobject_cast<const QLineEdit*>(widget))
                add(field, field->placeholderText());
            if (const auto* menu = qobject_cast<const QMenu*>(widget))
                add(menu, withoutMnemonic(menu->title()));
            if (const auto* list = qobject_cast<const QComboBox*>(widget))
                for (int i = 0; i < list->count(); ++i) add(list, list->itemText(i));
        }
        return found;
    }

    /// "QLabel name: English words" of each text that is not Chinese.
    QStringList leftInEnglish() {
        // Programs, keys, formats and published colour maps.
        std::set<std::string> names{"Hokuyo", "CloudCompare", "Slicer",  "F3D",     "Del",    "PgUp",
                                    "PgDown", "HTML",         "Viridis", "Cividis", "Plasma", "label,x,y,z"};
        for (const Layer& layer : driver->scene().layers) {
            names.insert(layer.name);
            names.insert(layer.path.string());
            names.insert(layer.path.filename().string());
            names.insert(layer.path.parent_path().filename().string());
        }
        QStringList left;
        for (const auto& [where, text] : texts())
            for (const std::string& word : test::englishLeft(text.toStdString(), names))
                left << where + ": " + QString::fromStdString(word) + " in " + text.left(120);
        left.removeDuplicates();
        return left;
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
    std::unique_ptr<test::WindowDriver> driver;
};

TEST_F(LanguageWindow, SaysNothingInEnglishWhereItIsChinese) {
    start(Language::simplifiedChinese);
    EXPECT_GT(texts().size(), 200u);
    EXPECT_EQ(leftInEnglish().join("\n").toStdString(), "");
    ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    ASSERT_TRUE(driver->settle());
    driver->trigger("register.run");
    ASSERT_TRUE(driver->settle());
    driver->trigger("view.panel-fit");
    driver->trigger("object.add");
    QApplication::processEvents();
    EXPECT_EQ(leftInEnglish().join("\n").toStdString(), "");
}

TEST_F(LanguageWindow, KeepsMnemonicsOfMenusApart) {
    start(Language::simplifiedChinese);
    for (const QAction* top : driver->window().menuBar()->actions()) {
        std::set<QChar> letters;
        for (const QAction* action : top->menu()->actions()) {
            const int at = action->text().indexOf('&');
            if (at < 0) continue;
            EXPECT_TRUE(letters.insert(action->text()[at + 1]).second)
                << action->text().toStdString() << " in " << top->text().toStdString();
        }
    }
}

TEST_F(LanguageWindow, WritesItsHistoryInEnglishAndShowsItInChinese) {
    start(Language::simplifiedChinese);
    ASSERT_TRUE(driver->trigger("object.add"));
    EXPECT_EQ(driver->window().document().lastEdit().rfind("add ", 0), 0u);
    EXPECT_TRUE(driver->textOf("edit.undo").contains("撤销 添加"))
        << driver->textOf("edit.undo").toStdString();
}

TEST_F(LanguageWindow, KeepsTheChoiceForTheNextStart) {
    start(Language::english);
    EXPECT_EQ(driver->textOf("view.language-zh"), "简体中文");
    ASSERT_TRUE(driver->trigger("view.language-zh"));
    EXPECT_EQ(storedLanguage(), Language::simplifiedChinese);
    EXPECT_EQ(language(), Language::english) << "what is shown does not change halfway";
    bool told = false;
    for (const QLabel* label : driver->window().findChildren<QLabel*>())
        told = told || label->text().contains("下次启动");
    EXPECT_TRUE(told);
    start(storedLanguage());
    EXPECT_EQ(driver->textOf("file.new"), "新建案件(N)");
    EXPECT_TRUE(driver->window().findChild<QAction*>("view.language-zh")->isChecked());
}

TEST_F(LanguageWindow, OpensTheWindowAgainWhenItIsAskedTo) {
    start(Language::english);
    ASSERT_TRUE(driver->trigger("view.language-zh"));
    QAbstractButton* again = nullptr;
    for (QAbstractButton* button : driver->window().findChildren<QAbstractButton*>())
        if (button->text().contains("重新打开窗口")) again = button;
    ASSERT_TRUE(again);
    QMetaObject::invokeMethod(again, "click", Qt::QueuedConnection);
    EXPECT_EQ(QApplication::exec(), kOpenAgain);
    EXPECT_FALSE(driver->window().isVisible());
    QApplication::setQuitOnLastWindowClosed(true);
}

}  // namespace
}  // namespace vestige
