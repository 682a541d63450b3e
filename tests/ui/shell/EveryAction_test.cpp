#include <QAction>
#include <QActionGroup>
#include <QDir>
#include <QMenu>
#include <QMessageBox>
#include <QTableView>
#include <QTreeWidget>
#include <fstream>
#include <map>
#include <set>

#include "core/scene/Edits.h"
#include "core/scene/PickFrame.h"
#include "tests/ui/shell/ShellFixture.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/SampleCase.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// Possible only after a registration that found no pose to rely on; FitWindow drives them there.
const std::set<std::string> kAfterRefusal{"register.preview", "register.use-candidate"};

class EveryAction : public test::ShellWindow {
  public:
    ActionCatalog& actions() { return *driver->window().findChild<ActionCatalog*>(); }

    void answer() {
        auto& answers = driver->answers();
        answers.casePath = path("case.vestige");
        answers.files = QStringList{QString::fromStdString(scans.target.string()),
                                    QString::fromStdString(scans.source.string())};
        answers.csv = path("table.csv");
        answers.table = path("list.csv");
        answers.sheet = path("sheet.txt");
        answers.folder = path("report");
        std::ofstream(folder / "list.csv") << "object,tape_m\nBox,2.0\n";
    }
    /// The sample scene with everything that actions ask for: registered, measured, selected, aims.
    void prepare(const std::string& id) {
        Document& document = driver->window().document();
        if (document.state().layers.size() != 2) {
            document.replace(SceneState());
            ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
        }
        const SceneState& scene = document.state();
        const std::string source = scene.layers[1].id;
        auto& layers = widget<QTreeWidget>("layers");
        layers.setCurrentItem(nullptr);
        layers.setCurrentItem(layers.topLevelItem(1));
        if (!scene.layers[1].registration) actions()["register.run"].trigger();
        Measurement box;
        box.object = "Box";
        box.tape_m = 2.0;
        for (int i = 0; i < 3; ++i)
            box.picks[scene.target].push_back({pickAt(scene, scene.target, test::kBoxCorner),
                                               pickAt(scene, scene.target, test::kBoxCornerAlongX)});
        box.aims["lidar"] = {{{"side", {10, 10}, {scene.target}}, {"side", {20, 10}, {scene.target}}}};
        document.perform(setView("side", driver->window().view().camera()));
        document.perform(setMeasurement(box, "measure Box"));
        for (const Measurement& other : std::vector<Measurement>(scene.measurements))
            if (other.object != box.object) document.perform(removeMeasurement(other.object));
        auto& table = widget<QTableView>("measurements");
        table.clearSelection();
        table.setCurrentIndex({});
        table.selectRow(0);
        if (id == "clean.remove" || id == "clean.keep" || id == "clean.make-object" || id == "clean.clear" ||
            id.rfind("part.", 0) == 0) {
            actions()["clean.ground"].trigger();
            driver->settle();
        }
        if (id.rfind("part.", 0) == 0) {
            actions()["clean.make-object"].trigger();
            driver->settle();
        }
        if (id == "edit.redo") document.undo();
        if (id == "compare.end") actions()["compare.swipe"].setChecked(true);
        if (id == "file.reopen" && scene.file.empty()) actions()["file.save"].trigger();
        QApplication::processEvents();
    }
    /// One of a group that is on already does nothing.
    void leave(QAction& action) {
        if (!action.actionGroup() || !action.isChecked()) return;
        for (QAction* other : action.actionGroup()->actions())
            if (other != &action) return other->trigger();
    }
};

TEST_F(EveryAction, HasWordsAnIconAndAReaction) {
    start();
    for (const ActionSpec& spec : actionTable()) {
        QAction& action = actions()[spec.id];
        EXPECT_FALSE(action.text().isEmpty()) << spec.id;
        EXPECT_TRUE(QString::fromUtf8(spec.text).contains('&')) << spec.id << " has no mnemonic";
        EXPECT_FALSE(action.statusTip().isEmpty()) << spec.id;
        EXPECT_STRNE(spec.icon, "") << spec.id << " has no icon";
        EXPECT_FALSE(action.icon().isNull()) << spec.id;
        EXPECT_TRUE(actions().hasReaction(spec.id)) << spec.id << " does nothing";
    }
}

TEST_F(EveryAction, RunsItsReaction) {
    QDir().mkpath(sampleFolder());
    std::ofstream(sampleFolder().toStdString() + "/case.json")
        << R"({"vestige": 1, "layers": [{"id": "yard", "role": "aerial", "path": ")" << scans.target.string()
        << R"("}]})";
    std::ofstream(sampleMark(sampleFolder()).toStdString()) << "";
    start();
    answer();
    for (const ActionSpec& spec : actionTable()) {
        const std::string id = spec.id;
        if (id == "file.quit") continue;  // below
        SCOPED_TRACE(id);
        prepare(id);
        QAction& action = actions()[id];
        leave(action);
        EXPECT_TRUE(action.isEnabled() || kAfterRefusal.contains(id))
            << "is not possible on the sample scene";
        action.setEnabled(true);
        const int before = actions().reactionsOf(id);
        action.trigger();
        EXPECT_TRUE(driver->settle());
        EXPECT_GT(actions().reactionsOf(id), before) << "nothing happened";
        for (QWidget* top : QApplication::topLevelWidgets())
            if (auto* box = qobject_cast<QMessageBox*>(top)) box->close();
        QApplication::processEvents();
    }
    ASSERT_TRUE(driver->window().isVisible());
    actions()["file.quit"].trigger();
    EXPECT_FALSE(driver->window().isVisible());
}

TEST_F(EveryAction, StandsInAMenuWithItsShortcut) {
    start();
    std::map<QString, std::string> keys;
    for (const ActionSpec& spec : actionTable()) {
        QAction& action = actions()[spec.id];
        bool inMenu = false;
        for (const QWidget* place : action.associatedWidgets())
            inMenu |= qobject_cast<const QMenu*>(place) != nullptr;
        EXPECT_TRUE(inMenu) << spec.id;
        if (action.shortcut().isEmpty()) continue;
        const auto [place, isNew] = keys.emplace(action.shortcut().toString(), spec.id);
        EXPECT_TRUE(isNew) << spec.id << " and " << place->second << " share " << place->first.toStdString();
    }
}

}  // namespace
}  // namespace vestige
