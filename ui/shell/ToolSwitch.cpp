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
      orbit_(probe_),
      measure_(document, selection, notices, probe_),
      path_(document, selection, notices, probe_),
      compare_(comparison) {
    view_.setGuard(&compare_);
    actions.onToggled("tool.orbit", [this](bool on) {
        if (on) view_.setTool(&orbit_);
    });
    actions.onToggled("tool.distance", [this](bool on) {
        if (on) view_.setTool(&measure_);
    });
    for (const auto& [id, kind] : kindTools())
        actions.onToggled(id, [this, kind = kind](bool on) {
            if (!on) return;
            path_.setKind(kind);
            view_.setTool(&path_);
        });
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
