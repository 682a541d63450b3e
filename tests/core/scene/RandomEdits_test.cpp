#include <gtest/gtest.h>

#include "core/base/Random.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "core/scene/PickFrame.h"
#include "tests/core/scene/SampleScene.h"

using namespace vestige;
using vestige::test::equal;
using vestige::test::sampleLayer;
using vestige::test::sampleResult;
using vestige::test::sampleScene;

namespace {

/// Draws edits from small pools of names, so that they often meet what others added, removed or renamed.
class EditGenerator {
  public:
    explicit EditGenerator(std::uint64_t seed) : random_(seed) {}

    std::unique_ptr<SceneEdit> next(const SceneState& scene) {
        switch (random_.below(21)) {
            case 0:
                return addLayer(newLayer());
            case 1:
                return removeLayer(layerId());
            case 2:
                return changeLayer(newLayer(), "change layer");
            case 3:
                return setLayerVisible(layerId(), random_.below(2) == 0);
            case 4:
            case 5:
                return setRegistration(layerId(), result());
            case 6:
                return setTarget(layerId());
            case 7:
                return setPreprocessParameter("voxel_m", 0.1 * static_cast<double>(random_.below(4)));
            case 8:
                return setRegistrationParameter("method", std::string(random_.below(2) == 0 ? "icp" : "ndt"));
            case 9: {
                Measurement measurement;
                measurement.object = object();
                return setMeasurement(std::move(measurement), "measure");
            }
            case 10:
                return removeMeasurement(object());
            case 11:
                return renameMeasurement(object(), object());
            case 12:
            case 13:
                return addPick(object(), layerId(), {pick(scene), pick(scene)});
            case 14:
                if (random_.below(2) == 0) return removePick(object(), layerId(), random_.below(3));
                return movePick(object(), layerId(), random_.below(3), random_.below(2) == 0, pick(scene));
            case 15:
            case 16:
                return addPath(object(), layerId(), {pick(scene), pick(scene), pick(scene)});
            case 17:
                return removePath(object(), layerId(), random_.below(3));
            case 18:
                return setKind(object(), kindTable()[random_.below(kindTable().size())].kind);
            case 19:
                return setKindSetting(
                    object(), random_.below(2) == 0 ? "drag_factor" : "stations",
                    random_.below(3) == 0 ? std::nullopt : std::optional(random_.below(2) == 0 ? 4.0 : 0.5));
            case 20:
                return setCheck(
                    object(), random_.below(3) == 0 ? std::nullopt : std::optional(random_.uniform(-0.1, 1)));
            default:
                return random_.below(2) == 0 ? setTape(object(), random_.uniform(0, 5))
                                             : setView(object(), ViewCamera{});
        }
    }
    std::uint64_t below(std::uint64_t count) { return random_.below(count); }

  private:
    std::string layerId() {
        constexpr std::array kIds{"aerial", "front", "photo", "rear"};
        return kIds[random_.below(kIds.size())];
    }
    std::string object() {
        constexpr std::array kObjects{"Length of the vehicle", "Right rearview mirror", "Box", "Wheel"};
        return kObjects[random_.below(kObjects.size())];
    }
    Layer newLayer() {
        Layer layer = sampleLayer(layerId(), random_.below(2) == 0 ? LayerRole::handheld : LayerRole::aerial);
        layer.name = object();
        return layer;
    }
    std::optional<RegistrationResult> result() {
        if (random_.below(4) == 0) return std::nullopt;
        return sampleResult(random_.uniform(-5, 5), random_.uniform(-1, 1));
    }
    PickedPoint pick(const SceneState& scene) {
        return pickAt(scene, layerId(), {random_.normal(), random_.normal(), random_.normal()}, 0.01);
    }

    Random random_;
};

}  // namespace

TEST(RandomEdits, UndoingAllGivesTheStartAndRedoingAllTheEnd) {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        Scene scene(sampleScene());
        EditGenerator generator(seed);
        for (int i = 0; i < 60; ++i) {
            const bool grouped = generator.below(8) == 0;
            if (grouped) scene.begin("several");
            for (int k = 0; k < (grouped ? 3 : 1); ++k) scene.perform(generator.next(scene.state()));
            if (grouped) scene.end();
            if (generator.below(5) == 0) scene.undo();
        }
        while (scene.canRedo()) scene.redo();
        const SceneState end = scene.state();
        while (scene.canUndo()) scene.undo();
        ASSERT_TRUE(equal(scene.state(), sampleScene())) << "seed " << seed;
        while (scene.canRedo()) scene.redo();
        ASSERT_TRUE(equal(scene.state(), end)) << "seed " << seed;
    }
}

TEST(RandomEdits, EveryStepIsUndoneAndRedoneExactly) {
    for (std::uint64_t seed = 100; seed < 140; ++seed) {
        Scene scene(sampleScene());
        EditGenerator generator(seed);
        std::vector<SceneState> states{scene.state()};
        for (int i = 0; i < 80; ++i)
            if (scene.perform(generator.next(scene.state()))) states.push_back(scene.state());
        ASSERT_GT(states.size(), 15U) << "most edits must have changed something";
        for (std::size_t i = states.size() - 1; i-- > 0;) {
            scene.undo();
            ASSERT_TRUE(equal(scene.state(), states[i])) << "seed " << seed << ", undo to " << i;
        }
        for (std::size_t i = 1; i < states.size(); ++i) {
            scene.redo();
            ASSERT_TRUE(equal(scene.state(), states[i])) << "seed " << seed << ", redo to " << i;
        }
    }
}
