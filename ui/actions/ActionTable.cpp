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
        {"file.new", "&File", "&New case", "Begin an empty case.", "", "Ctrl+N", whenIdle},
        {"file.open-case", "&File", "&Open case…", "Open a case (case.json or .vestige).", "open", "Ctrl+O",
         whenIdle},
        {"file.add-files", "&File", "Add clo&uds and meshes…",
         "Add scans as layers: LAS, LAZ, PLY, PCD, OBJ, STL, VTK, text.", "add", "Ctrl+I", whenIdle},
        {"file.save", "&File", "&Save case", "Save the case where it came from.", "save", "Ctrl+S",
         [](const Situation& s) { return s.layers > 0 && !s.busy; }, false, "", true},
        {"file.save-as", "&File", "Save case &as…", "Save the case under another name.", "", "Ctrl+Shift+S",
         [](const Situation& s) { return s.layers > 0 && !s.busy; }},
        {"file.reopen", "&File", "Reop&en saved case", "Go back to the case as it was saved.", "", "",
         whenIdle},
        {"file.verify", "&File", "&Verify evidence",
         "Hash every file again and compare with what was read (SHA-256).", "shield", "", idleWithLayers,
         false, "", true},
        {"export.report", "&File", "Export &report…",
         "Reconstruct into a folder: PDF, CSV, pictures, fused cloud, manifest.", "report", "Ctrl+R",
         idleWithLayers, false, "", true},
        {"export.csv", "&File", "Export &measurements…", "Write the table of measurements as CSV.", "", "",
         [](const Situation& s) { return s.hasMeasured && !s.busy; }},
        {"file.quit", "&File", "&Quit", "Close the program.", "", "Ctrl+Q", always, false, "", true},

        {"edit.undo", "&Edit", "&Undo", "Take the last change of the case back.", "undo", "Ctrl+Z",
         [](const Situation& s) { return s.canUndo; }},
        {"edit.redo", "&Edit", "&Redo", "Do again what was undone.", "redo", "Ctrl+Shift+Z",
         [](const Situation& s) { return s.canRedo; }},
        {"layer.target", "&Edit", "Make layer the &target", "The other layers are registered to this one.",
         "", "", [](const Situation& s) { return s.layerSelected && !s.busy; }, false, "", true},
        {"layer.remove", "&Edit", "Remove &layer", "Take the selected layer out of the case.", "", "",
         [](const Situation& s) { return s.layerSelected && !s.busy; }},
        {"object.add", "&Edit", "&Add object", "Add an object to measure.", "plus", "Ctrl+Shift+N", always,
         false, "", true},
        {"object.remove", "&Edit", "Remove &object", "Take the selected object out of the table.", "", "",
         withObject},
        {"object.remove-pick", "&Edit", "Remove last &pick", "Take the selected object's last repeat away.",
         "", "Backspace", [](const Situation& s) { return s.hasPicks; }},

        {"register.run", "&Align", "&Register",
         "Register the selected layer, or all that are not yet, to the target.", "register", "Ctrl+G",
         [](const Situation& s) { return !s.busy && s.registrable > 0; }},
        {"register.auto", "&Align", "Register from &any pose",
         "Find where the selected layer belongs, whatever its first pose and unit, and register it there.",
         "", "Ctrl+Shift+G", [](const Situation& s) { return !s.busy && s.registrable > 0; }},
        {"register.watch", "&Align", "&Watch the fit",
         "Show each iteration of a registration in the view and as curves, and keep them to be replayed.",
         "watch", "W", always, true},
        {"register.clear", "&Align", "&Forget registration",
         "Put the selected layer back to where its file has it.", "", "",
         [](const Situation& s) { return !s.busy && s.layerSelected && s.registered > 0; }},
        {"register.tint", "&Align", "&Tint source and target",
         "Show the target and the registered layers in two colours.", "overlay", "T",
         [](const Situation& s) { return s.registered > 0; }, true, "", true},
        {"register.before", "&Align", "Show &before", "Show registered layers at their first pose.", "before",
         "B", [](const Situation& s) { return s.registered > 0; }, true},
        {"register.residual", "&Align", "Colour by &distance to target",
         "Colour registered layers by their distance to the target.", "", "",
         [](const Situation& s) { return s.registered > 0; }, true},

        {"register.freedom", "&Align", "Show fr&ee directions",
         "Arrows along the ways to move that the data do not hold.", "free", "F",
         [](const Situation& s) { return s.registered > 0; }, true},
        {"register.step-back", "&Align", "Watched iteration bac&k",
         "Show the layer one iteration earlier in its watched registration.", "", ",", withFit},
        {"register.step-on", "&Align", "Watched iteration o&n",
         "Show the layer one iteration later in its watched registration.", "", ".", withFit},
        {"register.preview", "&Align", "&Preview refused pose",
         "Show the layer where a registration put it that cannot be relied on, without moving it.", "", "",
         [](const Situation& s) { return s.refused; }, true, "", true},
        {"register.use-candidate", "&Align", "&Use this candidate",
         "Register the layer from the candidate that is chosen.", "", "",
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
         "Compare registered layers at their first pose with where they lie now.", "", "", always, true,
         "compared", true},
        {"compare.layers", "&Compare", "&Target and source",
         "Compare the target alone with the other layers alone: what runs through both fits.", "", "", always,
         true, "compared"},
        {"compare.end", "&Compare", "Back to the &plain view",
         "End the comparison, the replay or the preview.", "", "Esc",
         [](const Situation& s) { return s.comparing || s.previewing; }, false, "", true},

        {"measure.aims", "&Measure", "Take recorded &aims",
         "Resolve the clicks that the case recorded into picks.", "", "",
         [](const Situation& s) { return !s.busy && s.hasAims && s.loadedLayers > 0; }},
        {"tool.orbit", "&Measure", "&Orbit", "Turn, move and zoom the view.", "orbit", "O", always, true,
         "tool", true},
        {"tool.distance", "&Measure", "&Distance",
         "Click the two ends of an object; three repeats make a measurement.", "distance", "D", withLayers,
         true, "tool"},
        {"tool.horizontal", "&Measure", "&Horizontal distance",
         "Click two points; the level part of the way between them is measured.", "kind-horizontal", "",
         withLayers, true, "tool", true},
        {"tool.vertical", "&Measure", "&Vertical height",
         "Click two points; the upright part of the way between them is measured.", "kind-vertical", "",
         withLayers, true, "tool"},
        {"tool.point-plane", "&Measure", "&Point to plane",
         "Click a point, then three or more of a plane; the distance between them is measured.",
         "kind-point-plane", "", withLayers, true, "tool"},
        {"tool.plane-plane", "&Measure", "Plane to pla&ne",
         "Click three points of one plane and three or more of another; distance and angle are measured.",
         "kind-plane-plane", "", withLayers, true, "tool"},
        {"tool.angle", "&Measure", "An&gle", "Click three points; the angle at the second is measured.",
         "kind-angle", "A", withLayers, true, "tool"},
        {"tool.polyline", "&Measure", "Po&lyline",
         "Click along a line, such as a skid mark; its length is measured.", "kind-polyline", "L", withLayers,
         true, "tool"},
        {"tool.arc", "&Measure", "A&rc",
         "Click along an arc, such as a yaw mark; its radius and, with a drag factor, the speed are found.",
         "kind-arc", "Y", withLayers, true, "tool"},
        {"tool.area", "&Measure", "Ar&ea", "Click round an outline; the area within is measured.",
         "kind-area", "U", withLayers, true, "tool"},
        {"tool.circle", "&Measure", "C&ircle",
         "Click points of a rim; the diameter of the circle through them is measured.", "kind-circle", "I",
         withLayers, true, "tool"},
        {"tool.box", "&Measure", "&Box",
         "Click what an upright box is to reach; its length, width and height are measured.", "kind-box", "J",
         withLayers, true, "tool"},
        {"tool.profile", "&Measure", "Cross-&section",
         "Click both ends of a line; the heights of the cloud along it are shown and measured.",
         "kind-profile", "Shift+P", withLayers, true, "tool"},
        {"tool.crush", "&Measure", "Cr&ush profile",
         "Click two undamaged ends, then along the damage; the depths C1 to C6 are measured.", "kind-crush",
         "Shift+C", withLayers, true, "tool"},
        {"tool.volume", "&Measure", "Volu&me",
         "Click round an outline; the space between the cloud and the plane through it is measured.",
         "kind-volume", "Shift+V", withLayers, true, "tool"},
        {"measure.check", "&Measure", "&Known distance",
         "The selected object is a known distance that the survey is checked by; its tape value is the "
         "reference.",
         "known-distance", "", withObject, true, "", true},

        {"view.perspective", "&View", "&Perspective", "View the scene in perspective.", "perspective", "5",
         withLayers},
        {"view.top", "&View", "&Top", "View the scene from above.", "", "7", withLayers},
        {"view.front", "&View", "&Front", "View the scene from the front.", "", "1", withLayers},
        {"view.left", "&View", "&Left", "View the scene from the left.", "", "3", withLayers},
        {"view.iso", "&View", "&Isometric", "View the scene obliquely from above.", "", "9", withLayers},
        {"view.layer", "&View", "Look at the la&yer",
         "Fill the view with the selected layer, else with the one whose registration is described.", "", "Z",
         [](const Situation& s) { return s.layerSelected || s.registered > 0 || s.refused; }},
        {"view.panel-measure", "&View", "&Measure panel", "Measurements and their errors.", "", "Ctrl+1",
         always, false, "", true},
        {"view.panel-align", "&View", "Ali&gn panel", "What a registration depends on.", "", "Ctrl+2",
         always},
        {"view.panel-fit", "&View", "Fit &quality",
         "What the last registration says of itself: verdict, uncertainty, residuals, iterations.", "",
         "Ctrl+3", always},
        {"view.color-source", "&View", "Colour &by layer", "Each layer in its own tint.", "", "Alt+1", always,
         true, "color", true},
        {"view.color-height", "&View", "Colour by &height", "Colour points by their height.", "", "Alt+2",
         always, true, "color"},
        {"view.color-intensity", "&View", "Colour by i&ntensity", "Grey by the strength of the return.", "",
         "Alt+3", always, true, "color"},
        {"view.color-rgb", "&View", "Colour by &RGB", "The colours that the files have.", "", "Alt+4", always,
         true, "color"},
        {"view.edl", "&View", "&Eye-dome lighting", "Shade edges so that shapes stand out.", "edl", "E",
         always, true, "", true},
        {"view.light", "&View", "Light bac&kground",
         "Window and pictures dark on light, for paper, projectors and bright rooms.", "", "Alt+L", always,
         true},
        {"view.larger-points", "&View", "L&arger points", "Draw points larger.", "larger", "+", always},
        {"view.smaller-points", "&View", "&Smaller points", "Draw points smaller.", "smaller", "-", always},

        {"help.about", "&Help", "&About Vestige", "Version and what it is built with.", "", "", always},
    };
    return all;
}

}  // namespace vestige
