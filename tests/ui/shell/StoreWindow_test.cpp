#include <gtest/gtest.h>

#include <QAction>
#include <QLabel>
#include <QPushButton>
#include <QSettings>
#include <QTest>
#include <fstream>

#include "app/offscreen/OffscreenApplication.h"
#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/store/Autosaves.h"
#include "core/scene/store/CaseStore.h"
#include "core/scene/store/Database.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/print/PdfPrinter.h"
#include "ui/shell/NoticeBar.h"

namespace vestige {
namespace {

namespace fs = std::filesystem;

/// Windows that keep edits, one after the other or side by side, as different programs would be.
class StoreWindow : public testing::Test {
  public:
    StoreWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
    }
    std::unique_ptr<test::WindowDriver> start() {
        auto driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), std::make_unique<PdfPrinter>(), nullptr,
            std::make_unique<InlineJobRunner>()));
        driver->window().keepEdits(folder / "user");
        return driver;
    }
    /// Everything that was done is on the disk, and the window knows.
    static void settle(test::WindowDriver& driver) {
        EXPECT_TRUE(driver.window().autosave()->flush(20000));
        for (int i = 0; i < 3; ++i) QApplication::processEvents();
    }
    static void edit(test::WindowDriver& driver, const std::string& operatorName) {
        driver.window().document().perform(setCaseDetails("night", operatorName, {}));
    }
    /// A destroyed window that was not closed: what kill -9 leaves, but for the lock, which goes both ways.
    static void kill(std::unique_ptr<test::WindowDriver>& driver) {
        settle(*driver);
        driver.reset();
    }
    static bool press(test::WindowDriver& driver, const char* name) {
        auto* button = driver.window().findChild<QPushButton*>(name);
        if (!button || !button->isVisible()) return false;
        QTest::mouseClick(button, Qt::LeftButton);
        QApplication::processEvents();
        return true;
    }
    static QString notice(test::WindowDriver& driver) {
        return driver.window().findChild<NoticeBar*>("notice")->text();
    }
    void saveCase(const fs::path& place) {
        auto driver = start();
        ASSERT_TRUE(driver->window().openFiles({scans.target}));
        edit(*driver, "saved");
        driver->answers().casePath = QString::fromStdString(place.string());
        ASSERT_TRUE(driver->trigger("file.save-as"));
        EXPECT_FALSE(driver->window().document().modified());
        driver->window().close();
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
};

TEST_F(StoreWindow, TellsThatEditsAreKeptAndRecoversACaseThatWasNeverSaved) {
    auto driver = start();
    EXPECT_EQ(driver->label("recovery-text"), "");
    ASSERT_TRUE(driver->window().openFiles({scans.target}));
    edit(*driver, "me");
    settle(*driver);
    EXPECT_EQ(driver->label("autosave"), "All changes autosaved");
    kill(driver);

    driver = start();
    EXPECT_TRUE(driver->scene().layers.empty());
    EXPECT_TRUE(driver->label("recovery-text").contains("never saved"))
        << driver->label("recovery-text").toStdString();
    EXPECT_TRUE(driver->label("recovery-text").contains("2 changes were not saved"));
    ASSERT_TRUE(press(*driver, "recovery-accept"));
    EXPECT_EQ(driver->scene().operatorName, "me");
    ASSERT_EQ(driver->scene().layers.size(), 1u);
    EXPECT_NE(driver->scene().layers[0].data, nullptr);
    EXPECT_TRUE(driver->window().document().modified());
    kill(driver);

    driver = start();
    EXPECT_TRUE(driver->label("recovery-text").contains("never saved")) << "until it is saved or discarded";
    ASSERT_TRUE(press(*driver, "recovery-discard"));
    EXPECT_EQ(driver->label("recovery-text"), "");
    driver.reset();
    driver = start();
    EXPECT_EQ(driver->label("recovery-text"), "");
}

TEST_F(StoreWindow, EditsAfterTheLastSaveComeBackAsAStepThatCanBeUndone) {
    for (const char* name : {"night.vestige", "night.json"}) {
        const fs::path place = folder / name;
        saveCase(place);
        auto driver = start();
        ASSERT_TRUE(driver->window().openCase(place));
        EXPECT_EQ(driver->label("recovery-text"), "");
        EXPECT_EQ(driver->label("autosave"), "All changes saved");
        edit(*driver, "later");
        ASSERT_TRUE(driver->window().openFiles({scans.source}));
        kill(driver);
        EXPECT_EQ(readCase(place)->operatorName, "saved") << name;

        driver = start();
        ASSERT_TRUE(driver->window().openCase(place));
        EXPECT_EQ(driver->scene().operatorName, "later") << name;
        ASSERT_EQ(driver->scene().layers.size(), 2u);
        EXPECT_NE(driver->scene().layers[1].data, nullptr);
        EXPECT_TRUE(driver->label("recovery-text").contains("2 changes were not saved")) << name;
        EXPECT_TRUE(driver->trigger("edit.undo"));
        EXPECT_EQ(driver->scene().operatorName, "saved");
        EXPECT_TRUE(driver->trigger("edit.redo"));
        ASSERT_TRUE(press(*driver, "recovery-discard"));
        EXPECT_EQ(driver->scene().operatorName, "saved");
        EXPECT_FALSE(driver->window().document().modified());
        driver->window().close();
        driver = start();
        ASSERT_TRUE(driver->window().openCase(place));
        EXPECT_EQ(driver->label("recovery-text"), "") << name;
    }
}

TEST_F(StoreWindow, TheBarOfRecoveredEditsGoesWithTheirCaseAndWithSaving) {
    const fs::path place = folder / "night.vestige";
    for (const char* end : {"file.new", "file.save"}) {
        saveCase(place);
        auto driver = start();
        ASSERT_TRUE(driver->window().openCase(place));
        edit(*driver, "later");
        kill(driver);
        driver = start();
        ASSERT_TRUE(driver->window().openCase(place));
        EXPECT_NE(driver->label("recovery-text"), "");
        ASSERT_TRUE(driver->trigger(end));
        EXPECT_EQ(driver->label("recovery-text"), "") << end;
        if (driver->scene().file.empty()) edit(*driver, "first of the next case");
        const std::string now = driver->scene().operatorName;
        EXPECT_FALSE(driver->window().autosave()->canDiscardRecovered());
        driver->window().autosave()->discardRecovered();
        EXPECT_EQ(driver->scene().operatorName, now) << end;
        kill(driver);
        EXPECT_EQ(readCaseStore(place)->unsaved, 0);
        fs::remove_all(place);
        driver = start();
        press(*driver, "recovery-discard");
    }
}

TEST_F(StoreWindow, EditsOfACaseThatCannotBeReadAnyMoreComeBackWithoutAPlace) {
    const fs::path place = folder / "night.json";
    saveCase(place);
    auto driver = start();
    ASSERT_TRUE(driver->window().openCase(place));
    edit(*driver, "later");
    kill(driver);
    ASSERT_TRUE(writeTextFile(place, "{ half"));
    driver = start();
    ASSERT_TRUE(press(*driver, "recovery-accept"));
    EXPECT_EQ(driver->scene().operatorName, "later");
    EXPECT_EQ(driver->scene().layers.size(), 1u);
    EXPECT_TRUE(driver->scene().file.empty());
    EXPECT_TRUE(driver->window().document().modified());
    EXPECT_TRUE(notice(*driver).contains("night.json")) << notice(*driver).toStdString();
    EXPECT_TRUE(notice(*driver).contains("case without a place"));
    kill(driver);
    driver = start();
    EXPECT_TRUE(driver->label("recovery-text").contains("never saved")) << "it is still kept";
}

TEST_F(StoreWindow, AnOfferThatCannotBeReadIsToldAndStays) {
    auto driver = start();
    edit(*driver, "me");
    kill(driver);
    const fs::path left = Autosaves(folder / "user").abandoned().at(0).folder;
    Database(left / "case.db", Database::Access::write).run("UPDATE journal SET case_text='{ half'");
    driver = start();
    edit(*driver, "present");
    ASSERT_TRUE(press(*driver, "recovery-accept"));
    EXPECT_TRUE(notice(*driver).contains("none of the states")) << notice(*driver).toStdString();
    EXPECT_EQ(driver->scene().operatorName, "present") << "the open case is not given up for nothing";
    EXPECT_NE(driver->label("recovery-text"), "");
    edit(*driver, "next");
    settle(*driver);
    EXPECT_TRUE(fs::exists(left / "case.db"));
}

TEST_F(StoreWindow, ClosingAndDiscardingForgetsSavingKeeps) {
    const fs::path place = folder / "night.vestige";
    saveCase(place);
    auto driver = start();
    ASSERT_TRUE(driver->window().openCase(place));
    edit(*driver, "discarded");
    driver->answers().unsaved = FileChooser::Unsaved::discard;
    EXPECT_TRUE(driver->window().close());
    driver = start();
    ASSERT_TRUE(driver->window().openCase(place));
    EXPECT_EQ(driver->scene().operatorName, "saved");
    edit(*driver, "kept");
    driver->answers().unsaved = FileChooser::Unsaved::save;
    EXPECT_TRUE(driver->window().close());
    EXPECT_EQ(readCase(place)->operatorName, "kept");
    driver.reset();
    EXPECT_TRUE(!fs::exists(folder / "user") || fs::is_empty(folder / "user"));
    EXPECT_FALSE(fs::exists(place / "lock"));
}

TEST_F(StoreWindow, TheSecondWindowLooksAndSavesUnderAnotherName) {
    const fs::path place = folder / "night.vestige";
    saveCase(place);
    auto first = start();
    ASSERT_TRUE(first->window().openCase(place));
    EXPECT_EQ(first->label("read-only"), "");
    auto second = start();
    ASSERT_TRUE(second->window().openCase(place));
    QApplication::processEvents();
    EXPECT_EQ(second->scene().operatorName, "saved");
    EXPECT_EQ(second->label("read-only"), "read-only");
    EXPECT_TRUE(notice(*second).contains("open in another window since")) << notice(*second).toStdString();
    edit(*second, "second");
    second->answers().casePath = "";
    second->trigger("file.save");
    EXPECT_EQ(readCase(place)->operatorName, "saved");
    EXPECT_TRUE(second->window().document().modified());
    second->answers().casePath = QString::fromStdString((folder / "other.vestige").string());
    second->trigger("file.save");
    EXPECT_EQ(readCase(folder / "other.vestige")->operatorName, "second");
    QApplication::processEvents();
    EXPECT_EQ(second->label("read-only"), "");
    edit(*first, "first");
    first->trigger("file.save");
    EXPECT_EQ(readCase(place)->operatorName, "first");
    // The other way round, the name is refused.
    second->answers().casePath = QString::fromStdString(place.string());
    edit(*second, "again");
    second->trigger("file.save-as");
    EXPECT_TRUE(notice(*second).contains("open in another window"));
    EXPECT_EQ(readCase(place)->operatorName, "first");
}

TEST_F(StoreWindow, AutosaveThatFailsIsToldUntilItWorks) {
    ASSERT_TRUE(writeTextFile(folder / "user", "a file where the folder should be"));
    auto driver = start();
    edit(*driver, "one");
    settle(*driver);
    EXPECT_TRUE(driver->label("autosave").startsWith("Autosave failed: "))
        << driver->label("autosave").toStdString();
    EXPECT_TRUE(notice(*driver).startsWith("Autosave failed: "));
    EXPECT_EQ(driver->scene().operatorName, "one") << "the edits stay";
    fs::remove(folder / "user");
    for (int i = 0; i < 100 && driver->label("autosave") != "All changes autosaved"; ++i) QTest::qWait(100);
    EXPECT_EQ(driver->label("autosave"), "All changes autosaved");
    kill(driver);
    driver = start();
    ASSERT_TRUE(press(*driver, "recovery-accept"));
    EXPECT_EQ(driver->scene().operatorName, "one");
}

TEST_F(StoreWindow, AFileThatIsNotTheOneImportedIsShown) {
    const fs::path place = folder / "night.vestige";
    saveCase(place);
    auto driver = start();
    ASSERT_TRUE(driver->window().openCase(place));
    EXPECT_EQ(notice(*driver), "");
    const std::string expected = driver->scene().layers[0].evidence->sha256;
    driver.reset();
    std::ofstream(scans.target, std::ios::app) << "0 0 0\n";
    driver = start();
    ASSERT_TRUE(driver->window().openCase(place));
    const QString told = notice(*driver);
    EXPECT_TRUE(told.contains("layer 'yard'")) << told.toStdString();
    EXPECT_TRUE(told.contains(QString::fromStdString(scans.target.string())));
    EXPECT_TRUE(told.contains(QString::fromStdString(expected)));
    driver->trigger("file.save");
    EXPECT_EQ(readCase(place)->layers[0].evidence->sha256, expected) << "saving does not settle it";
}

TEST_F(StoreWindow, AFileThatChangesWhileTheCaseIsOpenIsTold) {
    auto driver = start();
    ASSERT_TRUE(driver->window().openFiles({scans.target}));
    std::ofstream(scans.target, std::ios::app) << "0 0 0\n";
    for (int i = 0; i < 50 && notice(*driver).isEmpty(); ++i) QTest::qWait(100);
    EXPECT_TRUE(notice(*driver).contains("changed by another program after it was read"))
        << notice(*driver).toStdString();
    EXPECT_EQ(driver->scene().layers.size(), 1u);
}

}  // namespace
}  // namespace vestige
