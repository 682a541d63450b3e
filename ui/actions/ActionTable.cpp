#include "ui/actions/ActionSpec.h"

namespace vestige {
namespace {

bool always(const Situation&) {
    return true;
}
bool whenIdle(const Situation& s) {
    return !s.busy;
}
bool withLayers(const Situation& s) {
    return s.loadedLayers > 0;
}
bool idleWithLayers(const Situation& s) {
    return !s.busy && s.loadedLayers > 0;
}
bool withFit(const Situation& s) {
    return !s.busy && (s.registered > 0 || s.refused);
}
bool whenComparable(const Situation& s) {
    return s.registrable > 0;
}
bool withObject(const Situation& s) {
    return s.objectSelected;
}

}  // namespace

const std::vector<ActionSpec>& actionTable() {
    static const std::vector<ActionSpec> all{
        {"file.new", "&File", "&New case", "Begin an empty case.", "new", "Ctrl+N", whenIdle},
        {"file.open-case", "&File", "&Open case…", "Open a case (case.json or .vestige).", "open", "Ctrl+O",
         whenIdle},
        {"file.add-files", "&File", "Add clo&uds and meshes…",
         "Add scans as layers: LAS, LAZ, PLY, PCD, OBJ, STL, VTK, text.", "add", "Ctrl+I", whenIdle},
        {"file.save", "&File", "&Save case", "Save the case where it came from.", "save", "Ctrl+S",
         [](const Situation& s) { return s.layers > 0 && !s.busy; }, false, "", true},
        {"file.save-as", "&File", "Save case &as…", "Save the case under another name.", "save-as",
         "Ctrl+Shift+S", [](const Situation& s) { return s.layers > 0 && !s.busy; }},
        {"file.reopen", "&File", "Reop&en saved case", "Go back to the case as it was saved.", "reopen", "",
         whenIdle},
        {"file.verify", "&File", "&Verify evidence",
         "Hash every file again and compare with what was read (SHA-256).", "shield", "", idleWithLayers,
         false, "", true},
        {"export.report", "&File", "Export &report…",
         "Reconstruct into a folder: PDF, CSV, pictures, fused cloud, manifest.", "report", "Ctrl+R",
         idleWithLayers, false, "", true},
        {"export.csv", "&File", "Export &measurements…", "Write the table of measurements as CSV.",
         "table-out", "", [](const Situation& s) { return s.hasMeasured && !s.busy; }},
        {"file.sample", "&File", "Open sample &case",
         "Open the sample scene; where it is not there yet, it is simulated first (some minutes).", "sample",
         "", whenIdle, false, "", true},
        {"file.import-picks", "&File", "&Import picks…",
         "Take picked points from a list (x,y,z with index or label): each two are a repeat.", "picks-in", "",
         idleWithLayers},
        {"file.export-picks", "&File", "Export pic&ks…",
         "Write all picked points as label,x,y,z, which reads back.", "picks-out", "",
         [](const Situation& s) { return s.anyPicks; }},
        {"file.import-measurements", "&File", "Import ta&pe values…",
         "Take objects and what the tape says from a table, or from exported measurements.", "table-in", "",
         whenIdle},
        {"file.quit", "&File", "&Quit", "Close the program.", "quit", "Ctrl+Q", always, false, "", true},

        {"edit.undo", "&Edit", "&Undo", "Take the last change of the case back.", "undo", "Ctrl+Z",
         [](const Situation& s) { return s.canUndo; }},
        {"edit.redo", "&Edit", "&Redo", "Do again what was undone.", "redo", "Ctrl+Shift+Z",
         [](const Situation& s) { return s.canRedo; }},
        {"layer.target", "&Edit", "Make layer the &target", "The other layers are registered to this one.",
         "target", "", [](const Situation& s) { return s.layerSelected && !s.busy; }, false, "", true},
        {"layer.remove", "&Edit", "Remove &layer", "Take the selected layer out of the case.", "layer-remove",
         "", [](const Situation& s) { return s.layerSelected && !s.busy; }},
        {"object.add", "&Edit", "&Add object", "Add an object to measure.", "plus", "Ctrl+Shift+N", always,
         false, "", true},
        {"object.remove", "&Edit", "Remove &object", "Take the selected object out of the table.",
         "object-remove", "", withObject},
        {"object.remove-pick", "&Edit", "Remove last &pick", "Take the selected object's last repeat away.",
         "pick-remove", "Backspace", [](const Situation& s) { return s.hasPicks; }},

        {"edit.history", "&Edit", "&History", "Every step of the case; a click goes there.", "history", "F8",
         always, true, "", true},
        {"edit.copy-view", "&Edit", "Copy &view", "Copy the picture of the view to the clipboard.",
         "copy-view", "Ctrl+Shift+C", withLayers},
        {"edit.copy-table", "&Edit", "&Copy table",
         "Copy the selected rows of a table, or all of the measurements, with headings and units.",
         "copy-table", "Ctrl+C", always},

        {"register.run", "&Align", "&Register",
         "Register the selected layer, or all that are not yet, to the target.", "register", "Ctrl+G",
         [](const Situation& s) { return !s.busy && s.registrable > 0; }},
        {"register.auto", "&Align", "Register from &any pose",
         "Find where the selected layer belongs, whatever its first pose and unit, and register it there.",
         "register-auto", "Ctrl+Shift+G", [](const Situation& s) { return !s.busy && s.registrable > 0; }},
        {"register.watch", "&Align", "&Watch the fit",
         "Show each iteration of a registration in the view and as curves, and keep them to be replayed.",
         "watch", "W", always, true},
        {"register.clear", "&Align", "&Forget registration",
         "Put the selected layer back to where its file has it.", "register-clear", "",
         [](const Situation& s) { return !s.busy && s.layerSelected && s.registered > 0; }},
        {"register.tint", "&Align", "&Tint source and target",
         "Show the target and the registered layers in two colours.", "overlay", "Alt+T",
         [](const Situation& s) { return s.registered > 0; }, true, "", true},
        {"register.before", "&Align", "Show &before", "Show registered layers at their first pose.", "before",
         "B", [](const Situation& s) { return s.registered > 0; }, true},
        {"register.residual", "&Align", "Colour by &distance to target",
         "Colour registered layers by their distance to the target.", "residual", "",
         [](const Situation& s) { return s.registered > 0; }, true},

        {"register.freedom", "&Align", "Show fr&ee directions",
         "Arrows along the ways to move that the data do not hold.", "free", "F",
         [](const Situation& s) { return s.registered > 0; }, true},
        {"register.step-back", "&Align", "Watched iteration bac&k",
         "Show the layer one iteration earlier in its watched registration.", "step-back", ",", withFit},
        {"register.step-on", "&Align", "Watched iteration o&n",
         "Show the layer one iteration later in its watched registration.", "step-on", ".", withFit},
        {"register.preview", "&Align", "&Preview refused pose",
         "Show the layer where a registration put it that cannot be relied on, without moving it.", "preview",
         "", [](const Situation& s) { return s.refused; }, true, "", true},
        {"register.use-candidate", "&Align", "&Use this candidate",
         "Register the layer from the candidate that is chosen.", "choose", "",
         [](const Situation& s) { return s.candidates && !s.busy; }},

        {"compare.swipe", "&Compare", "&Swipe",
         "Two pictures beside a divider that the mouse drags; Left and Right move it, too.", "swipe", "S",
         whenComparable, true},
        {"compare.blink", "&Compare", "&Blink",
         "Two pictures in turn; Left and Right change the speed, Space holds one.", "blink", "K",
         whenComparable, true},
        {"compare.checkerboard", "&Compare", "&Checkerboard",
         "Two pictures in tiles; Left and Right change their size.", "checker", "C", whenComparable, true},
        {"compare.poses", "&Compare", "Before and &after",
         "Compare registered layers at their first pose with where they lie now.", "before-after", "", always,
         true, "compared", true},
        {"compare.layers", "&Compare", "&Target and source",
         "Compare the target alone with the other layers alone: what runs through both fits.", "layers", "",
         always, true, "compared"},
        {"compare.end", "&Compare", "Back to the &plain view",
         "End the comparison, the replay or the preview.", "plain-view", "Esc",
         [](const Situation& s) { return s.comparing || s.previewing; }, false, "", true},

        {"measure.aims", "&Measure", "Take recorded &aims",
         "Resolve the clicks that the case recorded into picks.", "aims", "",
         [](const Situation& s) { return !s.busy && s.hasAims && s.loadedLayers > 0; }},
        {"tool.orbit", "&Measure", "&Orbit", "Turn, move and zoom the view.", "orbit", "O", always, true,
         "tool", true},
        {"tool.distance", "&Measure", "&Distance",
         "Click the two ends of an object; three repeats make a measurement.", "distance", "D", withLayers,
         true, "tool"},

        {"snap.point", "&Picks", "Nearest &point", "A pick is the measured point under the cursor.",
         "snap-point", "", always, true, "snap"},
        {"snap.plane", "&Picks", "Local p&lane", "A pick lies on the plane through the points round it.",
         "snap-plane", "", always, true, "snap"},
        {"snap.edge", "&Picks", "&Edge", "A pick lies on the edge where two planes meet.", "snap-edge", "",
         always, true, "snap"},
        {"snap.corner", "&Picks", "C&orner", "A pick is the corner where three planes meet.", "snap-corner",
         "", always, true, "snap"},
        {"snap.highest", "&Picks", "&Highest", "A pick is the highest place of what lies round it.",
         "snap-highest", "", always, true, "snap"},
        {"snap.lowest", "&Picks", "Lo&west", "A pick is the lowest place of what lies round it.",
         "snap-lowest", "", always, true, "snap"},
        {"snap.circle", "&Picks", "C&ircle centre",
         "A pick is the centre of the circle on whose rim it lies.", "snap-circle", "", always, true, "snap"},
        {"snap.centroid", "&Picks", "Cen&troid", "A pick is the centroid of the points round it.",
         "snap-centroid", "", always, true, "snap"},
        {"snap.next", "&Picks", "&Next snap", "Snap picks to the next kind of feature.", "snap-next", "N",
         always, false, "", true},
        {"pick.move", "&Picks", "&Move picks",
         "Drag the ends of the selected object, or nudge them with the arrow keys, without the measuring "
         "tool.",
         "move-pick", "", always, true, "", true},
        {"pick.loupe", "&Picks", "Lo&upe", "A magnified picture of the place that a click would take.",
         "loupe", "", always, true},

        {"view.perspective", "&View", "&Perspective", "View the scene in perspective.", "perspective", "5",
         withLayers},
        {"view.top", "&View", "&Top", "View the scene from above.", "view-top", "7", withLayers},
        {"view.front", "&View", "&Front", "View the scene from the front.", "view-front", "1", withLayers},
        {"view.left", "&View", "&Left", "View the scene from the left.", "view-left", "3", withLayers},
        {"view.iso", "&View", "&Isometric", "View the scene obliquely from above.", "view-iso", "9",
         withLayers},
        {"view.layer", "&View", "Look at the la&yer",
         "Fill the view with the selected layer, else with the one whose registration is described.", "focus",
         "Z", [](const Situation& s) { return s.layerSelected || s.registered > 0 || s.refused; }},
        {"view.panel-measure", "&View", "&Measure panel", "Measurements and their errors.", "ruler", "Ctrl+1",
         always, false, "", true},
        {"view.panel-align", "&View", "Ali&gn panel", "What a registration depends on.", "sliders", "Ctrl+2",
         always},
        {"view.panel-fit", "&View", "Fit &quality",
         "What the last registration says of itself: verdict, uncertainty, residuals, iterations.",
         "histogram", "Ctrl+3", always},
        {"view.color-source", "&View", "Colour &by layer", "Each layer in its own tint.", "color-layer",
         "Alt+1", always, true, "color", true},
        {"view.color-height", "&View", "Colour by &height", "Colour points by their height.", "color-height",
         "Alt+2", always, true, "color"},
        {"view.color-intensity", "&View", "Colour by i&ntensity", "Grey by the strength of the return.",
         "color-intensity", "Alt+3", always, true, "color"},
        {"view.color-rgb", "&View", "Colour by &RGB", "The colours that the files have.", "color-rgb",
         "Alt+4", always, true, "color"},
        {"view.edl", "&View", "&Eye-dome lighting", "Shade edges so that shapes stand out.", "edl", "E",
         always, true, "", true},
        {"view.light", "&View", "Light bac&kground",
         "Window and pictures dark on light, for paper, projectors and bright rooms.", "sun", "Alt+L", always,
         true},
        {"view.larger-points", "&View", "L&arger points", "Draw points larger.", "larger", "+", always},
        {"view.smaller-points", "&View", "&Smaller points", "Draw points smaller.", "smaller", "-", always},
        {"view.language-en", "&View", "English", "Window, messages and reports in English.", "language", "",
         always, true, "language", true},
        {"view.language-zh", "&View", "Simplified Chinese",
         "Window, messages and reports in Simplified Chinese.", "language", "", always, true, "language"},

        {"view.panel-import", "&View", "Imp&ort panel", "The files of the case and what they are.", "import",
         "Ctrl+0", always, false, "", true},
        {"view.panel-report", "&View", "Case an&d report",
         "The case's details, what is missing, and what a report writes.", "report", "Ctrl+5", always},
        {"view.full-screen", "&View", "F&ull screen", "Use the whole screen, or go back.", "full-screen",
         "F11", always, true},

        {"help.guide", "&Help", "&User guide", "Show the user guide beside the view.", "guide", "F1", always},
        {"help.shortcuts", "&Help", "&Keyboard shortcuts", "Show all shortcuts, and change them.", "keyboard",
         "?", always},
        {"help.shortcut-sheet", "&Help", "Save shortcut &sheet…",
         "Write the shortcuts as a page to print: PDF, HTML or text.", "print", "", always},
        {"help.about", "&Help", "&About Vestige", "Version and what it is built with.", "about", "", always},
    };
    return all;
}

}  // namespace vestige
