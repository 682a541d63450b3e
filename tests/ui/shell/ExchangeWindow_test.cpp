#include <QClipboard>
#include <QListWidget>
#include <QTableView>
#include <QTreeWidget>
#include <fstream>

#include "core/base/AtomicFile.h"
#include "core/scene/CaseFile.h"
#include "tests/ui/shell/ShellFixture.h"
#include "ui/document/Document.h"
#include "ui/shell/NoticeBar.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

class ExchangeWindow : public test::ShellWindow {
  public:
    QString notice() { return driver->window().findChild<NoticeBar*>()->text(); }
    std::string textOf(const char* name) { return readTextFile(folder / name).value_or("?"); }
};

TEST_F(ExchangeWindow, PicksGoOutAndComeBackInOneStep) {
    startLoaded();
    pickBox(3);
    const auto before = driver->scene().measurements;
    ASSERT_EQ(before.size(), 1u);
    driver->answers().csv = path("picks.csv");
    ASSERT_TRUE(driver->trigger("file.export-picks"));
    EXPECT_EQ(textOf("picks.csv").substr(0, 13), "label,x,y,z\r\n");
    ASSERT_TRUE(driver->trigger("object.remove"));
    driver->answers().table = path("picks.csv");
    ASSERT_TRUE(driver->trigger("file.import-picks"));
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    const auto& [key, pairs] = *driver->scene().measurements[0].picks.begin();
    ASSERT_EQ(pairs.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
        EXPECT_LT((pairs[i].a.position - before[0].picks.at(key)[i].a.position).norm(), 1e-9);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo import picks");
    ASSERT_TRUE(driver->trigger("edit.undo"));
    EXPECT_TRUE(driver->scene().measurements.empty());
    ASSERT_TRUE(driver->trigger("edit.redo"));
    ASSERT_TRUE(driver->trigger("file.import-picks"));
    EXPECT_EQ(notice().toStdString(), "The case has all of these picks already.");
}

TEST_F(ExchangeWindow, AListOfPlainPointsIsTakenForTheSelectedLayer) {
    startLoaded();
    std::ofstream(folder / "points.txt") << "0 -1 -0.5 0.8\n1 1 -0.5 0.8\n2 -1 -0.5 0.8\n3 1 -0.5 0.8\n";
    driver->answers().table = path("points.txt");
    ASSERT_TRUE(driver->trigger("file.import-picks"));
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    EXPECT_EQ(driver->scene().measurements[0].picks.at("yard").size(), 2u);
    EXPECT_NEAR(driver->window().document().measured().lengths[0].length->mean_m, 2.0, 1e-12);
    EXPECT_EQ(notice().toStdString(), "2 repeats of Length 1 were taken.");
}

TEST_F(ExchangeWindow, AWrongListIsRefusedWithItsLine) {
    startLoaded();
    std::ofstream(folder / "wrong.csv") << "x,y,z\n1,2,3\n1,2\n";
    driver->answers().table = path("wrong.csv");
    const std::string before = caseText(driver->scene());
    for (const char* id : {"file.import-picks", "file.import-measurements"}) {
        ASSERT_TRUE(driver->trigger(id));
        EXPECT_TRUE(notice().contains("wrong.csv line ")) << notice().toStdString();
    }
    EXPECT_EQ(caseText(driver->scene()), before);
}

TEST_F(ExchangeWindow, MeasurementsThatWereWrittenReadBackAsTapeValues) {
    startLoaded();
    ASSERT_TRUE(driver->trigger("register.run"));
    pickBox(3);
    driver->typeInto(0, 1, "2.004");
    const std::string object = driver->scene().measurements[0].object;
    driver->answers().csv = driver->answers().table = path("measurements.csv");
    ASSERT_TRUE(driver->trigger("export.csv"));
    ASSERT_TRUE(driver->trigger("file.import-measurements"));
    EXPECT_EQ(notice().toStdString(), "The case has all of these values already.");
    ASSERT_TRUE(driver->trigger("file.new"));
    ASSERT_TRUE(driver->trigger("file.import-measurements"));
    ASSERT_EQ(driver->scene().measurements.size(), 1u);
    EXPECT_EQ(driver->scene().measurements[0].object, object);
    EXPECT_EQ(driver->scene().measurements[0].tape_m, 2.004);
    EXPECT_EQ(driver->textOf("edit.undo"), "Undo import tape values");
}

TEST_F(ExchangeWindow, TableAndViewGoToTheClipboard) {
    startLoaded();
    pickBox(3);
    driver->typeInto(0, 1, "2.004");
    auto& table = widget<QTableView>("measurements");
    table.setFocus();
    QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
    const QStringList lines = QApplication::clipboard()->text().split('\n');
    ASSERT_EQ(lines.size(), 3) << QApplication::clipboard()->text().toStdString();
    EXPECT_TRUE(lines[0].startsWith("Object\tTape m\t")) << lines[0].toStdString();
    EXPECT_TRUE(lines[1].contains("\t2.004\t")) << lines[1].toStdString();
    EXPECT_EQ(lines[0].count('\t'), lines[1].count('\t'));
    ASSERT_TRUE(driver->trigger("edit.copy-view"));
    const QImage copied = QApplication::clipboard()->image();
    ASSERT_FALSE(copied.isNull());
    EXPECT_EQ(copied.size(), driver->window().view().grab().size());
}

TEST_F(ExchangeWindow, TheHistoryShowsEveryStepAndGoesThere) {
    startLoaded();
    pickBox(3);
    ASSERT_FALSE(widget<QWidget>("history-panel").isVisible());
    QTest::keyClick(driver->window().view().widget(), Qt::Key_F8);
    auto& list = widget<QListWidget>("history");
    ASSERT_TRUE(list.isVisible());
    ASSERT_GE(list.count(), 5) << "opened, files, three repeats";
    EXPECT_EQ(list.currentRow(), list.count() - 1);
    EXPECT_TRUE(list.currentItem()->font().bold());
    const int all = list.count();
    const QRect second = list.visualItemRect(list.item(1));
    list.scrollToItem(list.item(1));
    QTest::mouseClick(list.viewport(), Qt::LeftButton, Qt::NoModifier, second.center());
    QApplication::processEvents();
    EXPECT_EQ(driver->scene().layers.size(), 2u);
    EXPECT_TRUE(driver->scene().measurements.empty());
    EXPECT_EQ(list.count(), all) << "what is undone stays to be seen";
    EXPECT_EQ(list.currentRow(), 1);
    list.setCurrentRow(all - 1);
    QTest::keyClick(&list, Qt::Key_Return);
    QApplication::processEvents();
    EXPECT_EQ(driver->scene().measurements.size(), 1u);
}

}  // namespace
}  // namespace vestige
