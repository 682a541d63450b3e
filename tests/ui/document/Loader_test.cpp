#include "ui/document/Loader.h"

#include <gtest/gtest.h>

#include <QTest>
#include <fstream>

#include "core/base/AtomicFile.h"
#include "core/geometry/PointCloudBuilder.h"
#include "core/io/LasWriter.h"
#include "core/scene/CaseFile.h"
#include "core/scene/Edits.h"
#include "tests/support/TestPaths.h"
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

}  // namespace
}  // namespace vestige
