#include "ui/shell/MainWindow.h"

#include <QAction>
#include <QApplication>
#include <QCloseEvent>
#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMenuBar>
#include <QMimeData>
#include <QStatusBar>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/FileChooser.h"
#include "ui/actions/Situation.h"
#include "ui/actions/Workbench.h"
#include "ui/actions/reactions/CleaningReactions.h"
#include "ui/actions/reactions/CompareReactions.h"
#include "ui/actions/reactions/EditReactions.h"
#include "ui/actions/reactions/ExchangeReactions.h"
#include "ui/actions/reactions/ExportReactions.h"
#include "ui/actions/reactions/FileReactions.h"
#include "ui/actions/reactions/KindReactions.h"
#include "ui/actions/reactions/LanguageReactions.h"
#include "ui/actions/reactions/RegistrationReactions.h"
#include "ui/actions/reactions/SampleReactions.h"
#include "ui/actions/reactions/ViewReactions.h"
#include "ui/actions/reactions/WatchReactions.h"
#include "ui/document/Attempts.h"
#include "ui/document/Autosave.h"
#include "ui/document/Cleaner.h"
#include "ui/document/CleaningSettings.h"
#include "ui/document/Comparison.h"
#include "ui/document/Document.h"
#include "ui/document/Evidence.h"
#include "ui/document/FitTrace.h"
#include "ui/document/History.h"
#include "ui/document/Loader.h"
#include "ui/document/Notices.h"
#include "ui/document/Outputs.h"
#include "ui/document/PointMarks.h"
#include "ui/document/PointSelection.h"
#include "ui/document/Presentation.h"
#include "ui/document/Preview.h"
#include "ui/document/RecentFiles.h"
#include "ui/document/Selection.h"
#include "ui/jobs/ThreadedJobRunner.h"
#include "ui/shell/AboutBox.h"
#include "ui/shell/CleaningTools.h"
#include "ui/shell/GuiThreadRenderer.h"
#include "ui/shell/HeaderBar.h"
#include "ui/shell/RecentMenu.h"
#include "ui/shell/RecoveryBar.h"
#include "ui/shell/ScenePresenter.h"
#include "ui/shell/StatusStrip.h"
#include "ui/shell/Theme.h"
#include "ui/shell/ToolSwitch.h"
#include "ui/shell/ViewControls.h"
#include "ui/shell/WindowReactions.h"
#include "ui/shell/WorkArea.h"
#include "ui/view/SceneView.h"

namespace vestige {

/// Members are destroyed from the last to the first: the job runner, whose destructor waits for the worker,
/// stands below what its jobs use.
struct MainWindow::Private {
    Private(MainWindow& window, const ViewSurfaceFactory& makeSurface, std::unique_ptr<ViewRenderer> pictures,
            std::unique_ptr<DocumentPrinter> pages, std::unique_ptr<JobRunner> runner)
        : renderer(std::move(pictures)),
          printer(std::move(pages)),
          onGuiThread(renderer ? std::make_unique<GuiThreadRenderer>(*renderer) : nullptr),
          chooser(std::make_unique<FileChooser>()),
          jobs(runner ? std::move(runner) : std::make_unique<ThreadedJobRunner>()),
          actions(&window),
          loader(document, *jobs, notices),
          evidence(document, *jobs, notices),
          view(std::make_unique<SceneView>(makeSurface, &window)),
          presenter(std::make_unique<ScenePresenter>(
              ScenePresenter::Models{document, selection, presentation, preview, comparison, attempts, marks},
              *jobs, *view)),
          tools(std::make_unique<ToolSwitch>(actions, document, selection, comparison, notices, *view)),
          bench{window,       actions,  document,          selection,
                presentation, preview,  comparison,        trace,
                attempts,     *jobs,    notices,           loader,
                evidence,     recent,   history,           outputs,
                chooser,      autosave, onGuiThread.get(), printer.get(),
                points,       cleaning},
          files(bench),
          edits(bench),
          registration(bench),
          compares(bench),
          views(bench),
          viewControls(std::make_unique<ViewControls>(bench, *view, *presenter)),
          exports(bench),
          kinds(bench),
          exchange(bench),
          sample(bench),
          ofWindow(window, bench, *view),
          languages(bench),
          cleans(bench),
          cleaningTools(bench, *view, tools->probe()),
          cleaner(document, *jobs, notices),
          watches(bench) {}

    std::unique_ptr<ViewRenderer> renderer;
    std::unique_ptr<DocumentPrinter> printer;
    std::unique_ptr<GuiThreadRenderer> onGuiThread;
    std::unique_ptr<FileChooser> chooser;
    Document document;
    Selection selection;
    Presentation presentation;
    Preview preview;
    Comparison comparison;
    FitTrace trace{document, preview};
    Attempts attempts{document, preview};
    PointSelection points{document};
    PointMarks marks{document, points};
    CleaningSettings cleaning;
    Notices notices;
    RecentFiles recent;
    History history{document};
    Outputs outputs{document};
    std::unique_ptr<Autosave> autosave;
    std::unique_ptr<JobRunner> jobs;
    ActionCatalog actions;
    Loader loader;
    Evidence evidence;
    std::unique_ptr<SceneView> view;
    std::unique_ptr<ScenePresenter> presenter;
    std::unique_ptr<ToolSwitch> tools;
    Workbench bench;
    FileReactions files;
    EditReactions edits;
    RegistrationReactions registration;
    CompareReactions compares;
    ViewReactions views;
    std::unique_ptr<ViewControls> viewControls;
    ExportReactions exports;
    KindReactions kinds;
    ExchangeReactions exchange;
    SampleReactions sample;
    WindowReactions ofWindow;
    LanguageReactions languages;
    CleaningReactions cleans;
    CleaningTools cleaningTools;
    Cleaner cleaner;
    WatchReactions watches;
    HeaderBar* header = nullptr;
    WorkArea* area = nullptr;
    StatusStrip* status = nullptr;
};

MainWindow::MainWindow(const ViewSurfaceFactory& makeSurface, std::unique_ptr<ViewRenderer> renderer,
                       std::unique_ptr<DocumentPrinter> printer, QWidget* parent,
                       std::unique_ptr<JobRunner> jobs)
    : QMainWindow(parent) {
    applyTheme(storedTheme());
    setObjectName("main-window");
    setAcceptDrops(true);
    setMinimumSize(960, 600);
    resize(1400, 875);
    d_ = std::make_unique<Private>(*this, makeSurface, std::move(renderer), std::move(printer),
                                   std::move(jobs));
    Private& d = *d_;
    const auto followTheme = [this] {
        applyTheme(d_->presentation.theme());
        d_->actions.paintIcons(QApplication::palette());
    };
    d.presentation.setTheme(storedTheme());
    followTheme();
    connect(&d.presentation, &Presentation::themeChanged, this, followTheme);
    d.actions.onToggled("view.light", [](bool on) { storeTheme(on ? Theme::light : Theme::dark); });

    d.actions.fill(*menuBar());
    auto* recent = new RecentMenu(d.recent, this);
    connect(recent, &RecentMenu::chosen, this, [this](const QString& path) { open({path}); });
    menuBar()->findChild<QMenu*>("file")->insertMenu(&d.actions["file.save"], recent);
    d.header = new HeaderBar(d.actions, d.document, this);
    addToolBar(d.header);

    auto* area = new WorkArea(d.bench, *d.view, *d.tools);
    connect(area, &WorkArea::chosen, this, [this](const QString& path) { open({path}); });
    setCentralWidget(area);
    d.area = area;
    d.viewControls->attach(area->viewArea(), area->viewsPanel());
    area->follow(d.cleaningTools, d.cleans);
    connect(&d.cleans, &CleaningReactions::boxWanted, d.presenter.get(), &ScenePresenter::showBox);
    connect(&d.points, &PointSelection::changed, d.presenter.get(), &ScenePresenter::refreshPoints);
    auto* status = new StatusStrip(d.document, *d.jobs);
    d.status = status;
    connect(d.tools.get(), &ToolSwitch::hovered, status, &StatusStrip::showCoordinates);
    statusBar()->setSizeGripEnabled(false);
    statusBar()->addPermanentWidget(status, 1);

    connect(&d.sample, &SampleReactions::ready, this, [this](const QString& path) { open({path}); });
    connect(&d.views, &ViewReactions::namedViewWanted, d.presenter.get(), &ScenePresenter::showNamedView);
    d.actions.onTriggered("view.layer", [this] { d_->presenter->showLayer(); });
    d.actions.onTriggered("view.object", [this] { d_->presenter->showObject(); });
    d.actions.onTriggered("help.about", [this] { showAbout(this); });
    const auto update = [this] {
        d_->actions.update(situationOf(d_->document, d_->selection, *d_->jobs, d_->attempts, d_->preview,
                                       d_->comparison, &d_->points));
        setWindowTitle(d_->document.title() + "[*] - Vestige");
        setWindowModified(d_->document.modified());
    };
    connect(&d.document, &Document::changed, this, update);
    connect(&d.selection, &Selection::changed, this, update);
    connect(&d.points, &PointSelection::changed, this, update);
    connect(&d.attempts, &Attempts::changed, this, update);
    connect(&d.preview, &Preview::changed, this, update);
    connect(&d.comparison, &Comparison::switched, this, update);
    connect(d.jobs.get(), &JobRunner::becameBusy, this, update);
    connect(d.jobs.get(), &JobRunner::finished, this, update);
    update();
}

// The view goes before its widget, and the panels before the document that they show.
MainWindow::~MainWindow() {
    hide();
    d_->viewControls.reset();
    d_->tools.reset();
    d_->presenter.reset();
    d_->view.reset();
    delete takeCentralWidget();
}

Status MainWindow::openCase(const std::filesystem::path& file) {
    return d_->loader.openCase(file);
}

Status MainWindow::openFiles(const std::vector<std::filesystem::path>& files) {
    return d_->loader.addFiles(files);
}

void MainWindow::open(const QStringList& paths) {
    d_->files.open(paths);
}

void MainWindow::keepEdits(const std::filesystem::path& folder) {
    Private& d = *d_;
    d.autosave = std::make_unique<Autosave>(d.document, folder);
    d.loader.setAutosave(d.autosave.get());
    auto* bar = new RecoveryBar(*d.autosave, d.loader, [this] { return d_->files.mayLeave(); });
    d.area->addBar(bar);
    connect(d.autosave.get(), &Autosave::changed, this, [this] {
        const auto state = d_->autosave->state();
        d_->status->showAutosave(d_->autosave->text(),
                                 state == Autosave::State::failed || state == Autosave::State::elsewhere);
        d_->header->showReadOnly(d_->autosave->readOnly());
        d_->header->showStored(state == Autosave::State::stored);
    });
    connect(d.autosave.get(), &Autosave::troubled, &d.notices, &Notices::warn);
    connect(&d.loader, &Loader::opened, this, [this] {
        if (const QString reason = d_->autosave->readOnly(); !reason.isEmpty())
            d_->notices.warn(tr("Read-only: %1.").arg(reason));
    });
    bar->offerAbandoned();
}

Autosave* MainWindow::autosave() {
    return d_->autosave.get();
}

void MainWindow::setTheme(Theme theme) {
    d_->presentation.setTheme(theme);
}

void MainWindow::setOverlay(Overlay overlay) {
    d_->presentation.setOverlay(overlay);
}

void MainWindow::setColorMode(ColorMode mode) {
    d_->presentation.setColorMode(mode);
}

void MainWindow::showNamedView(NamedView view) {
    d_->presenter->showNamedView(view);
}

Document& MainWindow::document() {
    return d_->document;
}

SceneView& MainWindow::view() {
    return *d_->view;
}

JobRunner& MainWindow::jobs() {
    return *d_->jobs;
}

void MainWindow::setFileChooser(std::unique_ptr<FileChooser> chooser) {
    d_->chooser = std::move(chooser);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    event->setAccepted(d_->files.mayLeave());
    if (!event->isAccepted()) return;
    d_->jobs->cancel();
    d_->files.leave();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    QStringList paths;
    for (const QUrl& url : event->mimeData()->urls())
        if (url.isLocalFile()) paths << url.toLocalFile();
    event->acceptProposedAction();
    // After the drop is done, so that a question about unsaved changes does not hold the other program.
    QMetaObject::invokeMethod(
        this, [this, paths] { open(paths); }, Qt::QueuedConnection);
}

}  // namespace vestige
