#pragma once

#include <QObject>
#include <string>

#include "ui/actions/reactions/SnapReactions.h"
#include "ui/document/PickChoices.h"
#include "ui/tools/CompareTool.h"
#include "ui/tools/HoverProbe.h"
#include "ui/tools/MeasureTool.h"
#include "ui/tools/OrbitTool.h"
#include "ui/tools/PathTool.h"
#include "ui/tools/PickFeedback.h"
#include "ui/tools/PickMover.h"
#include "ui/tools/PickProbe.h"

namespace vestige {

class ActionCatalog;
class Comparison;

/// Which tool has the mouse, by the actions of the group "tool"; and what is under the cursor, in words.
class ToolSwitch : public QObject {
    Q_OBJECT

  public:
    ToolSwitch(ActionCatalog& actions, Document& document, Selection& selection, Comparison& comparison,
               Notices& notices, SceneView& view, QObject* parent = nullptr);
    ~ToolSwitch() override;
    MeasureTool& measure() { return measure_; }
    PathTool& path() { return path_; }
    /// What every tool asks for the point under the cursor; hovered() says it in words.
    HoverProbe& probe() { return probe_; }

  signals:
    /// What the next click of the active tool does; empty for a tool that needs no words.
    void hintChanged(const QString& hint);
    /// The active tool picks, or not: what it snaps to can be chosen.
    void picking(bool on);
    void hovered(const QString& coordinates, const QString& layer);

  private:
    void describe(const std::optional<Pick>& pick);

    Document& document_;
    SceneView& view_;
    PickChoices choices_;
    SnapReactions snaps_;
    HoverProbe probe_;
    PickProbe picks_;
    PickFeedback feedback_;
    PickMover mover_;
    OrbitTool orbit_;
    MeasureTool measure_;
    PathTool path_;
    CompareTool compare_;
};

}  // namespace vestige
