#include "ui/document/Evidence.h"

#include <gtest/gtest.h>

#include <QTest>
#include <fstream>

#include "core/pipeline/LoadLayers.h"
#include "tests/support/TestPaths.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/jobs/InlineJobRunner.h"

namespace vestige {
namespace {

/// A document with one layer of a file of three points, which is loaded.
class EvidenceOfALayer : public testing::Test {
  public:
    EvidenceOfALayer() {
        write();
        QObject::connect(&notices, &Notices::warned, [this](const QString& said) { warnings << said; });
        Layer layer;
        layer.id = "a";
        layer.path = file;
        layer.data = read();
        SceneState scene;
        scene.layers = {layer};
        document.replace(scene);
    }
    void write() const { std::ofstream(file) << "0 0 0\n1 0 0\n0 1 0\n"; }
    std::shared_ptr<const LayerData> read() const { return loadLayerData(file, {}, {}).value(); }
    std::shared_ptr<const LayerData> firstLook() const {
        auto look = std::make_shared<LayerData>(*read());
        look->sha256.clear();
        look->awaitedPoints = 3;
        return look;
    }
    void wait(int warned) {
        for (int i = 0; i < 100 && warnings.size() < warned; ++i) QTest::qWait(50);
    }

    test::TemporaryFolder folder;
    std::filesystem::path file = folder / "a.xyz";
    Document document;
    InlineJobRunner jobs;
    Notices notices;
    QStringList warnings;
    Evidence evidence{document, jobs, notices};
};

TEST_F(EvidenceOfALayer, WhatIsReadAgainAfterAChangeIsTouchedNoMore) {
    ASSERT_EQ(evidence.stateOf("a"), EvidenceState::hashed);
    write();
    wait(1);
    ASSERT_EQ(evidence.stateOf("a"), EvidenceState::touched);
    document.attachData("a", document.state().layers[0].data);
    EXPECT_EQ(evidence.stateOf("a"), EvidenceState::touched) << "the same data";
    int told = 0;
    QObject::connect(&evidence, &Evidence::changed, [&] { ++told; });
    document.attachData("a", read());
    EXPECT_EQ(evidence.stateOf("a"), EvidenceState::hashed);
    EXPECT_EQ(told, 1);
}

TEST_F(EvidenceOfALayer, AFirstLookIsNotVerified) {
    document.attachData("a", firstLook());
    evidence.verify();
    EXPECT_EQ(evidence.stateOf("a"), EvidenceState::notRead);
}

}  // namespace
}  // namespace vestige
