#pragma once

#include <QKeySequence>
#include <QString>
#include <vector>

namespace vestige {

/// What actions may depend on; filled from document, selection and jobs whenever one of them changes.
struct Situation {
    bool busy = false;
    int layers = 0;
    int loadedLayers = 0;
    int registrable = 0;  ///< loaded layers besides the loaded target
    int registered = 0;
    bool refused = false;     ///< the registration described found no pose to rely on
    bool candidates = false;  ///< of it, to choose from
    bool comparing = false;
    bool previewing = false;
    bool canUndo = false;
    bool canRedo = false;
    bool modified = false;
    bool layerSelected = false;
    bool objectSelected = false;
    bool hasPicks = false;  ///< of the selected object
    bool hasMeasured = false;
    bool hasAims = false;
    bool anyPicks = false;  ///< of any object
    bool pointsSelected = false;
    bool partSelected = false;  ///< a separated object
    bool cleaned = false;       ///< points of some layer are taken out
};

/// One thing the user can do, said once: menus, tool bars, tool tips and the documentation read it here.
struct ActionSpec {
    const char* id;  ///< "file.open-case"; also the QAction's object name
    const char* menu;
    const char* text;
    const char* help;      ///< one sentence: tool tip and status bar
    const char* icon;      ///< resources/icons/NAME.svg; empty for none
    const char* shortcut;  ///< portable text; empty for none
    bool (*enabled)(const Situation&);
    bool checkable = false;
    const char* group = "";  ///< checkable actions of one group exclude each other
    bool separatorBefore = false;
};

/// Every action, in the order of the menus.
const std::vector<ActionSpec>& actionTable();

}  // namespace vestige
