#pragma once

#include <QObject>
#include <string>

#include "ui/tools/CompareTool.h"
#include "ui/tools/HoverProbe.h"
#include "ui/tools/MeasureTool.h"
#include "ui/tools/OrbitTool.h"
#include "ui/tools/PathTool.h"

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

  signals:
    void hovered(const QString& coordinates, const QString& layer);

  private:
    void describe(const std::optional<Pick>& pick);

    Document& document_;
    SceneView& view_;
    HoverProbe probe_;
    OrbitTool orbit_;
    MeasureTool measure_;
    PathTool path_;
    CompareTool compare_;
};

}  // namespace vestige
