#include "ui/actions/FilePeek.h"

#include <gtest/gtest.h>

#include <QFileDialog>
#include <QLabel>
#include <QTest>
#include <atomic>
#include <condition_variable>
#include <fstream>
#include <mutex>

#include "tests/support/TestPaths.h"
#include "ui/actions/FilePeekPanel.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

using Rows = std::vector<std::pair<QString, QString>>;

QString valueOf(const Rows& rows, const QString& label) {
    for (const auto& [name, value] : rows)
        if (name == label) return value;
    return {};
}

/// A disk as slow as the test wants it.
class Gate {
  public:
    void open() {
        const std::lock_guard lock(mutex_);
        open_ = true;
        changed_.notify_all();
    }
    void pass() {
        std::unique_lock lock(mutex_);
        changed_.wait(lock, [this] { return open_; });
    }

  private:
    std::mutex mutex_;
    std::condition_variable changed_;
    bool open_ = false;
};

Result<FileInfo> infoOf(const std::filesystem::path& file) {
    FileInfo info;
    info.path = file;
    info.points = 7;
    return info;
}

TEST(FilePeek, OnlyWhatIsStillWantedArrives) {
    const auto gate = std::make_shared<Gate>();
    const auto looked = std::make_shared<std::atomic<int>>(0);
    FilePeek peek(nullptr, [gate, looked](const std::filesystem::path& file, const JobControl&) {
        ++*looked;
        gate->pass();
        return infoOf(file);
    });
    QStringList told;
    QObject::connect(&peek, &FilePeek::told,
                     [&](const QString& path, const Result<FileInfo>&) { told << path; });
    for (const char* name : {"a", "b", "c", "d"}) peek.look(name);
    QTest::qWait(50);
    EXPECT_TRUE(told.isEmpty());
    gate->open();
    for (int i = 0; i < 200 && told.isEmpty(); ++i) QTest::qWait(10);
    QTest::qWait(50);
    EXPECT_EQ(told, QStringList{"d"});
    EXPECT_EQ(*looked, 2) << "a, which was begun, and d";
    peek.look("e");
    peek.look({});
    QTest::qWait(100);
    EXPECT_EQ(told, QStringList{"d"}) << "called off";
    peek.look("e");
    for (int i = 0; i < 200 && told.size() < 2; ++i) QTest::qWait(10);
    EXPECT_EQ(told.back(), "e");
}

TEST(FilePeek, MayGoWhileADiskStillThinks) {
    const auto gate = std::make_shared<Gate>();
    const auto ended = std::make_shared<std::atomic<bool>>(false);
    {
        FilePeek peek(nullptr, [gate, ended](const std::filesystem::path& file, const JobControl& control) {
            gate->pass();
            EXPECT_TRUE(control.cancelled());
            *ended = true;
            return infoOf(file);
        });
        peek.look("a");
        QTest::qWait(20);
    }
    gate->open();
    for (int i = 0; i < 200 && !*ended; ++i) QTest::qWait(10);
    EXPECT_TRUE(*ended);
    QTest::qWait(20);
}

TEST(FilePeekPanel, TellsOfTheSelectedFileBesideTheList) {
    VESTIGE_SHARED_OR_SKIP(cloud, "formats/text/ptx/multiple-and-transform.ptx");
    const test::TemporaryFolder folder;
    const auto file = folder / "Straße 9.ply";
    std::ofstream(file) << "ply\nformat ascii 1.0\nelement vertex 2\nproperty float x\nproperty float y\n"
                           "property float z\nproperty float intensity\nend_header\n1 2 3 4\n5 6 7 8\n";
    std::filesystem::copy_file(cloud, folder / "scans.ptx");
    std::ofstream(folder / "broken.ply") << "ply\nnonsense\n";
    QFileDialog dialog(nullptr, "Add", toQt(folder.path()));
    FilePeekPanel* panel = addPeekPanel(dialog);
    dialog.setFileMode(QFileDialog::ExistingFiles);
    dialog.show();
    const auto* title = panel->findChild<QLabel*>("peekTitle");
    const auto* text = panel->findChild<QLabel*>("peekText");
    ASSERT_TRUE(title && text);
    const auto select = [&](const std::filesystem::path& path) {
        const QString name = toQt(path.filename());
        emit dialog.currentChanged(toQt(path));
        for (int i = 0; i < 300 && title->text() != name; ++i) QTest::qWait(10);
        return title->text() == name ? text->text() : QString();
    };
    const QString ply = select(file);
    EXPECT_TRUE(ply.contains("PLY 1.0, ascii")) << ply.toStdString();
    EXPECT_TRUE(ply.contains("intensity"));
    EXPECT_TRUE(ply.contains("of memory"));
    EXPECT_TRUE(select(folder / "scans.ptx").contains("first scan 2 x 2"));
    EXPECT_TRUE(select(folder / "broken.ply").contains("line 2"));
    emit dialog.currentChanged(toQt(folder.path()));
    EXPECT_TRUE(text->text().isEmpty());
}

TEST(PeekRows, NameWhatCountsBeforeLoading) {
    FileInfo info;
    info.format = "LAS";
    info.version = "1.4, point format 7";
    info.points = 130000000;
    info.bounds.add(Eigen::Vector3d(483400, 4375661, 30));
    info.bounds.add(Eigen::Vector3d(483500, 4375761, 42.5));
    info.crs = "PROJCS[\"WGS 84 / UTM zone 32N\",GEOGCS[\"WGS 84\"]]";
    info.metresPerUnit = 0.3048;
    ScanInfo scan;
    scan.sensorVendor = "DJI";
    scan.sensorModel = "L1";
    info.scans = {scan, scan};
    LoadEstimate estimate = estimateLoad(info, {});
    estimate.availableBytes = 1;
    estimate.keepEveryToFit = 7;
    const Rows rows = peekRows(info, estimate, 4420000000);
    EXPECT_EQ(valueOf(rows, "Format"), "LAS 1.4, point format 7");
    EXPECT_EQ(valueOf(rows, "Size"), "4.42 GB");
    EXPECT_EQ(valueOf(rows, "Extent"), QString::fromUtf8("100.00 × 100.00 × 12.50 ft"));
    EXPECT_EQ(valueOf(rows, "Reference"), "WGS 84 / UTM zone 32N");
    EXPECT_EQ(valueOf(rows, "Unit"), "feet");
    EXPECT_EQ(valueOf(rows, "Sensor"), "DJI L1");
    EXPECT_EQ(valueOf(rows, "Scans"), "2");
    EXPECT_TRUE(valueOf(rows, "Memory").contains("one point in 7 would"));
    EXPECT_EQ(valueOf(peekRows({}, {}, 12), "Points"), "told once it is loaded");
    EXPECT_EQ(valueOf(peekRows({}, {}, 12), "Size"), "12 bytes");
    EXPECT_TRUE(valueOf(peekRows({}, {}, 12), "Memory").isEmpty());
}

}  // namespace
}  // namespace vestige
