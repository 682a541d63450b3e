#include "ui/shell/ToolSwitch.h"

#include <QAction>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/KindTools.h"
#include "ui/document/Document.h"
#include "ui/document/Wording.h"
#include "ui/view/SceneView.h"

namespace vestige {

ToolSwitch::ToolSwitch(ActionCatalog& actions, Document& document, Selection& selection,
                       Comparison& comparison, Notices& notices, SceneView& view, QObject* parent)
    : QObject(parent),
      document_(document),
      view_(view),
      snaps_(actions, choices_),
      picks_(document, choices_, probe_),
      feedback_(choices_),
      mover_(document, selection, picks_, feedback_),
      orbit_(probe_, mover_, choices_),
      measure_(document, selection, {choices_, picks_, feedback_, mover_}),
      path_(document, selection, notices, {choices_, picks_, feedback_, mover_}),
      compare_(comparison) {
    view_.setGuard(&compare_);
    actions.onToggled("tool.orbit", [this](bool on) {
        if (on) view_.setTool(&orbit_);
    });
    actions.onToggled("tool.distance", [this](bool on) {
        if (on) view_.setTool(&measure_);
        emit picking(on);
    });
    for (const auto& [id, kind] : kindTools())
        actions.onToggled(id, [this, kind = kind](bool on) {
            if (on) {
                path_.setKind(kind);
                view_.setTool(&path_);
            }
            emit picking(on);
        });
    connect(&path_, &PathTool::hintChanged, this, &ToolSwitch::hintChanged);
    QAction& distance = actions["tool.distance"];
    distance.setShortcuts({distance.shortcut(), QKeySequence(Qt::Key_M)});
    connect(&measure_, &MeasureTool::hintChanged, this, &ToolSwitch::hintChanged);
    // Not at once: the tool may be in the middle of an event of the view that it would leave.
    const auto orbit = [&actions] { actions["tool.orbit"].setChecked(true); };
    connect(&measure_, &MeasureTool::finished, this, orbit, Qt::QueuedConnection);
    connect(&path_, &PathTool::finished, this, orbit, Qt::QueuedConnection);
    connect(&mover_, &PickMover::told, this, [this](const QString& sentence) {
        if (view_.tool() == &orbit_) emit hintChanged(sentence);
    });
    connect(&choices_, &PickChoices::changed, &view_, &SceneView::updateOverlay);
    connect(&probe_, &HoverProbe::hovered, this, [this](const auto& pick) { describe(pick); });
    actions["tool.orbit"].setChecked(true);
}

ToolSwitch::~ToolSwitch() {
    view_.setTool(nullptr);
    view_.setGuard(nullptr);
}

void ToolSwitch::describe(const std::optional<Pick>& pick) {
    const auto& layers = view_.description().layers;
    if (!pick || pick->layer >= layers.size()) {
        emit hovered({}, {});
        return;
    }
    emit hovered(coordinateText(pick->world.x(), pick->world.y(), pick->world.z()),
                 QString::fromStdString(layers[pick->layer].name));
}

}  // namespace vestige
