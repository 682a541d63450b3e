#include "ui/document/Loader.h"

#include <gtest/gtest.h>

#include <QTest>
#include <fstream>

#include "core/base/AtomicFile.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/LasWriter.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "core/scene/store/CaseStore.h"
#include "tests/support/TestPaths.h"
#include "ui/document/Autosave.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/jobs/ThreadedJobRunner.h"

namespace vestige {
namespace {

constexpr std::uint32_t kMany = 4'200'000;  // more than are read at once

std::filesystem::path writeSquare(const std::filesystem::path& file, std::uint32_t points) {
    PointCloudBuilder builder(Eigen::Vector3d(483000, 4375000, 30));
    builder.resize(points);
    for (std::uint32_t i = 0; i < points; ++i)
        builder.setPoint(i, {483000 + 0.01 * (i % 2000), 4375000 + 0.01 * (i / 2000), 30});
    const PointCloud cloud = std::move(builder).build();
    EXPECT_TRUE(writeLas(file, {{&cloud, {}, 1}}, {}));
    return file;
}

/// A LAS file that says it has many points and is as long as they are, but for the disk: nothing but zeros.
std::filesystem::path writeVast(const std::filesystem::path& file) {
    writeSquare(file, 4);
    const std::uint64_t points = 20'000'000'000;
    {
        std::fstream stream(file, std::ios::binary | std::ios::in | std::ios::out);
        stream.seekp(247);  // number of point records, LAS 1.4
        stream.write(reinterpret_cast<const char*>(&points), sizeof points);
    }
    const auto record = (std::filesystem::file_size(file) - 375) / 4;
    std::filesystem::resize_file(file, 375 + points * record);
    return file;
}

class Loading : public testing::Test {
  public:
    Loading() {
        QObject::connect(&notices, &Notices::informed, [this](const QString& said) { told << said; });
        QObject::connect(&notices, &Notices::warned, [this](const QString& said) { told << said; });
        QObject::connect(&notices, &Notices::withdrawn, [this] { ++withdrawals; });
        QObject::connect(&notices, &Notices::offered,
                         [this](const QString& sentence, const std::vector<Notices::Offer>& made) {
                             offered = sentence;
                             offers = made;
                         });
    }
    void settle(JobRunner& jobs) {
        for (int i = 0; i < 12000 && jobs.busy(); ++i) QTest::qWait(10);
        ASSERT_FALSE(jobs.busy());
    }
    test::TemporaryFolder folder;
    Document document;
    Notices notices;
    QStringList told;
    int withdrawals = 0;
    QString offered;
    std::vector<Notices::Offer> offers;
};

TEST_F(Loading, ALargeFileIsShownBeforeItIsRead) {
    const auto file = writeSquare(folder / "large.las", kMany);
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    std::vector<std::size_t> sizes;
    std::vector<bool> previews;
    QObject::connect(&document, &Document::changed, [&] {
        if (document.state().layers.empty() || !document.state().layers[0].data) return;
        const LayerData& data = *document.state().layers[0].data;
        sizes.push_back(data.points->size());
        previews.push_back(data.isPreview());
        if (!data.isPreview()) return;
        EXPECT_EQ(data.awaitedPoints, kMany);
        EXPECT_EQ(data.stamp, stampOf(file).value()) << "it is watched";
        EXPECT_EQ(&data.octree->cloud(), data.points.get()) << "it can be picked";
    });
    static_cast<void>(loader.addFiles({file}));
    settle(jobs);
    ASSERT_GE(sizes.size(), 2U);
    EXPECT_TRUE(previews.front());
    EXPECT_LT(sizes.front(), 2'500'000U);
    EXPECT_GT(sizes.front(), 500'000U);
    EXPECT_FALSE(previews.back());
    EXPECT_EQ(sizes.back(), kMany);
    const auto whole = document.state().layers[0].data;
    EXPECT_EQ(whole->sha256.size(), 64U);
    EXPECT_EQ(document.undoText(), "add large");
    document.undo();
    EXPECT_TRUE(document.state().layers.empty());
    document.redo();
    EXPECT_EQ(document.state().layers[0].data, whole);
}

TEST_F(Loading, WhatIsChangedMeanwhileStaysAndUndoBringsNoPreviewBack) {
    const auto file = writeSquare(folder / "large.las", kMany);
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    bool hidden = false;
    QObject::connect(
        &document, &Document::changed, &document,
        [&] {
            const auto& layers = document.state().layers;
            if (hidden || layers.empty() || !layers[0].data) return;
            hidden = true;
            Layer renamed = layers[0];
            renamed.name = "night";
            document.perform(changeLayer(renamed, "rename"));
        },
        Qt::QueuedConnection);
    static_cast<void>(loader.addFiles({file}));
    settle(jobs);
    ASSERT_TRUE(hidden);
    EXPECT_EQ(document.state().layers[0].name, "night");
    const auto whole = document.state().layers[0].data;
    EXPECT_FALSE(whole->isPreview());
    document.undo();
    EXPECT_EQ(document.state().layers[0].name, "large");
    EXPECT_EQ(document.state().layers[0].data, whole);
}

TEST_F(Loading, CancelledItLeavesNothing) {
    const auto file = writeSquare(folder / "large.las", kMany);
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    bool shown = false;
    QObject::connect(&document, &Document::changed, [&] {
        if (document.state().layers.empty() || shown) return;
        shown = true;
        jobs.cancel();
    });
    static_cast<void>(loader.addFiles({file}));
    settle(jobs);
    EXPECT_TRUE(shown);
    EXPECT_TRUE(document.state().layers.empty());
    document.redo();
    for (const Layer& layer : document.state().layers) EXPECT_FALSE(layer.data);
}

TEST_F(Loading, ACaseIsThereWhileItsLargeFilesAreRead) {
    writeSquare(folder / "large.las", kMany);
    writeSquare(folder / "small.las", 1000);
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"large.las"},
        {"id":"b","role":"aerial","path":"small.las","keep_every":4},
        {"id":"c","role":"aerial","path":"missing.las"}],"registration":{"target":"a"}})"));
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    int replaced = 0;
    bool early = false;
    QObject::connect(&document, &Document::replaced, [&] {
        ++replaced;
        early = document.state().layers[0].data && document.state().layers[0].data->isPreview();
    });
    ASSERT_TRUE(loader.openCase(folder / "case.json"));
    settle(jobs);
    EXPECT_EQ(replaced, 1);
    EXPECT_TRUE(early);
    ASSERT_EQ(document.state().layers.size(), 3U);
    EXPECT_EQ(document.state().layers[0].data->points->size(), kMany);
    EXPECT_EQ(document.state().layers[1].data->points->size(), 250U);
    EXPECT_FALSE(document.state().layers[2].data);
    EXPECT_FALSE(document.canUndo());
    EXPECT_FALSE(document.modified());
}

TEST_F(Loading, WhatDoesNotFitIsRefusedWithAnOffer) {
    const auto file = writeVast(folder / "vast.las");
    InlineJobRunner jobs;
    Loader loader(document, jobs, notices);
    const Status added = loader.addFiles({file});
    ASSERT_FALSE(added);
    EXPECT_EQ(added.error().code, ErrorCode::input);
    EXPECT_TRUE(document.state().layers.empty());
    EXPECT_TRUE(offered.contains("vast.las")) << offered.toStdString();
    EXPECT_TRUE(offered.contains("20 000 000 000 points need"));
    ASSERT_EQ(offers.size(), 1U);
    EXPECT_TRUE(offers[0].text.startsWith("Load every "));
}

TEST_F(Loading, OffersAreOfTheCaseTheyWereMadeFor) {
    const auto file = writeVast(folder / "vast.las");
    InlineJobRunner jobs;
    Loader loader(document, jobs, notices);
    int started = 0;
    QObject::connect(&jobs, &JobRunner::started, [&] { ++started; });
    ASSERT_FALSE(loader.addFiles({file}));
    ASSERT_EQ(started, 1);
    writeSquare(file, 1000);
    Layer same;
    same.id = "vast";
    same.path = folder / "another.las";
    SceneState other;
    other.layers = {same};
    EXPECT_EQ(withdrawals, 0);
    document.replace(other);
    EXPECT_EQ(withdrawals, 1);
    offers.at(0).take();
    EXPECT_EQ(started, 1);
    EXPECT_EQ(document.state().layers.size(), 1U);
    EXPECT_EQ(document.state().layers[0].keepEvery, 1U);
}

TEST_F(Loading, LayersOfOneFileGetTheirOwnPartOfIt) {
    writeSquare(folder / "small.las", 1000);
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"small.las"},
        {"id":"b","role":"aerial","path":"small.las","keep_every":4},
        {"id":"c","role":"aerial","path":"small.las","box":[483000,4374999,0,483001.005,4375009,99]}],
        "registration":{"target":"a"}})"));
    InlineJobRunner jobs;
    Loader loader(document, jobs, notices);
    const Status opened = loader.openCase(folder / "case.json");
    ASSERT_TRUE(opened) << opened.error().sentence();
    std::vector<std::size_t> sizes;
    for (const Layer& layer : document.state().layers) sizes.push_back(layer.data->points->size());
    EXPECT_EQ(sizes, (std::vector<std::size_t>{1000, 250, 101}));
}

TEST_F(Loading, APartThatWasUndoneWhileItWasReadGoesToNoWholeLayer) {
    const auto file = writeVast(folder / "vast.las");
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"vast.las"}],"registration":{"target":"a"}})"));
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    ASSERT_TRUE(loader.openCase(folder / "case.json"));
    settle(jobs);
    ASSERT_EQ(offers.size(), 1U);
    writeSquare(file, 1000);
    offers[0].take();
    ASSERT_GT(document.state().layers[0].keepEvery, 1U);
    document.undo();
    settle(jobs);
    EXPECT_EQ(document.state().layers[0].keepEvery, 1U);
    EXPECT_FALSE(document.state().layers[0].data);
    document.redo();
    ASSERT_TRUE(document.state().layers[0].data) << "it is there when it is wanted";
    EXPECT_LT(document.state().layers[0].data->points->size(), 1000U);
}

TEST_F(Loading, ACancelledCaseSaysWhatWasNotReadAndIsOpen) {
    writeSquare(folder / "large.las", kMany);
    writeSquare(folder / "small.las", 1000);
    ASSERT_TRUE(writeTextFile(folder / "case.json", R"({"vestige":1,"layers":[
        {"id":"a","role":"aerial","path":"large.las"},
        {"id":"b","role":"aerial","path":"small.las"}],"registration":{"target":"a"}})"));
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    QStringList opened;
    QObject::connect(&loader, &Loader::opened, [&](const QString& path) { opened << path; });
    QObject::connect(&document, &Document::replaced, [&] { jobs.cancel(); });
    ASSERT_TRUE(loader.openCase(folder / "case.json"));
    settle(jobs);
    EXPECT_EQ(document.state().layers.size(), 2U);
    EXPECT_EQ(opened.size(), 1);
    EXPECT_EQ(told, QStringList("Cancelled; 2 layers were not read."));
}

TEST_F(Loading, CancellingTakesOnlyTheAddedLayersBack) {
    const auto file = writeSquare(folder / "large.las", kMany);
    ThreadedJobRunner jobs;
    Loader loader(document, jobs, notices);
    bool edited = false;
    QObject::connect(
        &document, &Document::changed, &document,
        [&] {
            if (edited || document.state().layers.empty()) return;
            edited = true;
            document.begin("add large");  // the same words
            document.perform(setCaseDetails("night", "somebody", {}));
            document.end();
            jobs.cancel();
        },
        Qt::QueuedConnection);
    static_cast<void>(loader.addFiles({file}));
    settle(jobs);
    ASSERT_TRUE(edited);
    EXPECT_EQ(document.state().operatorName, "somebody");
    ASSERT_EQ(document.state().layers.size(), 1U);
    EXPECT_FALSE(document.state().layers[0].data);
    EXPECT_EQ(told, QStringList("Cancelled; 1 layer was not read."));
}

/// Documents that keep their edits, one after the other as in different programs.
class KeptLoading : public Loading {
  public:
    struct Window {
        explicit Window(KeptLoading& test)
            : autosave(document, test.folder / "user"), loader(document, jobs, test.notices) {
            loader.setAutosave(&autosave);
        }
        Document document;
        ThreadedJobRunner jobs;
        Autosave autosave;
        Loader loader;
    };
    std::unique_ptr<Window> start() { return std::make_unique<Window>(*this); }
    std::filesystem::path writeNight() {
        writeSquare(folder / "small.las", 1000);
        Layer layer;
        layer.id = layer.name = "a";
        layer.method = defaultMethod(layer.role);
        layer.path = folder / "small.las";
        SceneState scene;
        scene.layers = {layer};
        scene.target = "a";
        EXPECT_TRUE(writeCase(folder / "night.vestige", scene));
        return folder / "night.vestige";
    }
    void open(Window& window, const std::filesystem::path& place) {
        const Status opened = window.loader.openCase(place);
        ASSERT_TRUE(opened) << opened.error().sentence();
        settle(window.jobs);
    }
};

TEST_F(KeptLoading, EditsMadeWhileAnotherCaseIsReadAreKept) {
    const auto night = writeNight();
    ASSERT_TRUE(writeTextFile(folder / "day.json", R"({"vestige":1,"layers":[
        {"id":"b","role":"aerial","path":"small.las"}],"registration":{"target":"b"}})"));
    auto window = start();
    open(*window, night);
    window->document.perform(setCaseDetails("night", "agreed to leave", {}));
    ASSERT_TRUE(window->loader.openCase(folder / "day.json"));
    window->document.perform(setCaseDetails("night", "made meanwhile", {}));
    settle(window->jobs);
    ASSERT_EQ(window->document.state().layers.at(0).id, "b");
    ASSERT_EQ(told.size(), 1) << told.join("\n").toStdString();
    EXPECT_TRUE(told[0].contains("are kept")) << told[0].toStdString();
    ASSERT_TRUE(window->autosave.flush(20000));
    window = start();
    open(*window, night);
    EXPECT_EQ(window->document.state().operatorName, "made meanwhile");
    window->document.undo();
    EXPECT_EQ(window->document.state().operatorName, "");
}

TEST_F(KeptLoading, EditsThatTheUserHasAgreedToLeaveAreForgotten) {
    const auto night = writeNight();
    ASSERT_TRUE(writeTextFile(folder / "day.json", R"({"vestige":1,"layers":[
        {"id":"b","role":"aerial","path":"small.las"}],"registration":{"target":"b"}})"));
    auto window = start();
    open(*window, night);
    window->document.perform(setCaseDetails("night", "agreed to leave", {}));
    open(*window, folder / "day.json");
    EXPECT_TRUE(told.isEmpty()) << told.join("\n").toStdString();
    ASSERT_TRUE(window->autosave.flush(20000));
    window = start();
    open(*window, night);
    EXPECT_EQ(window->document.state().operatorName, "");
}

TEST_F(KeptLoading, EditsMadeWhileTheCaseIsOpenedAgainComeBackAsAStep) {
    const auto night = writeNight();
    auto window = start();
    open(*window, night);
    ASSERT_TRUE(window->loader.openCase(night));
    window->document.perform(setCaseDetails("night", "made meanwhile", {}));
    settle(window->jobs);
    EXPECT_EQ(window->document.state().operatorName, "made meanwhile");
    EXPECT_EQ(told.size(), 1) << told.join("\n").toStdString();
    window->document.undo();
    EXPECT_EQ(window->document.state().operatorName, "");
    window->document.redo();
    ASSERT_TRUE(window->autosave.flush(20000));
    window = start();
    open(*window, night);
    EXPECT_EQ(window->document.state().operatorName, "made meanwhile") << "after a crash, too";
}

TEST_F(KeptLoading, ARecoveredPartIsThatPartAndUndoneTheWhole) {
    const auto night = writeNight();
    auto window = start();
    open(*window, night);
    Layer part = window->document.state().layers.at(0);
    part.keepEvery = 4;
    part.data = nullptr;
    ASSERT_TRUE(window->document.perform(changeLayer(part, "load a part")));
    ASSERT_TRUE(window->autosave.flush(20000));
    window = start();
    open(*window, night);
    const auto& layers = window->document.state().layers;
    ASSERT_TRUE(layers.at(0).data);
    EXPECT_EQ(layers[0].keepEvery, 4U);
    EXPECT_EQ(layers[0].data->points->size(), 250U);
    window->document.undo();
    ASSERT_TRUE(layers.at(0).data);
    EXPECT_EQ(layers[0].keepEvery, 1U);
    EXPECT_EQ(layers[0].data->points->size(), 1000U);
}

TEST_F(KeptLoading, TheHashThatComesAfterAFirstLookIsKeptToo) {
    const auto file = writeSquare(folder / "large.las", kMany);
    std::string sha256;
    {
        const auto window = start();
        static_cast<void>(window->loader.addFiles({file}));
        settle(window->jobs);
        sha256 = window->document.state().layers.at(0).evidence->sha256;
        ASSERT_TRUE(window->autosave.flush(20000));
    }
    const auto window = start();
    const auto left = window->autosave.opener().abandoned();
    ASSERT_EQ(left.size(), 1U);
    EXPECT_NE(left[0].content.drafts.at(0).find(sha256), std::string::npos);
}

}  // namespace
}  // namespace vestige
