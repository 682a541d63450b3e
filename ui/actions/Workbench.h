#pragma once

#include <memory>

class QWidget;

namespace vestige {

class ActionCatalog;
class Attempts;
class Autosave;
class Comparison;
class Document;
class DocumentPrinter;
class Evidence;
class FileChooser;
class FitTrace;
class History;
class JobRunner;
class Loader;
class Notices;
class Outputs;
class PointSelection;
class Presentation;
class Preview;
class RecentFiles;
class Selection;
class ViewRenderer;
struct CleaningSettings;

/// What reactions work with; the window owns all of it.
struct Workbench {
    QWidget& window;
    ActionCatalog& actions;
    Document& document;
    Selection& selection;
    Presentation& presentation;
    Preview& preview;
    Comparison& comparison;
    FitTrace& trace;
    Attempts& attempts;
    JobRunner& jobs;
    Notices& notices;
    Loader& loader;
    Evidence& evidence;
    RecentFiles& recent;
    History& history;
    Outputs& outputs;
    std::unique_ptr<FileChooser>& chooser;  ///< may be exchanged while the window lives
    std::unique_ptr<Autosave>& autosave;    ///< null where edits are not kept
    ViewRenderer* renderer;                 ///< safe to call from a job; may be null, as the printer
    DocumentPrinter* printer;
    PointSelection& points;
    CleaningSettings& cleaning;
};

}  // namespace vestige
