#include "ui/shell/ViewControls.h"

#include <QAction>
#include <QSettings>
#include <QSignalBlocker>

#include "core/geometry/CameraProjection.h"
#include "core/scene/SavedViewEdits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Document.h"
#include "ui/document/Presentation.h"
#include "ui/panels/ViewsPanel.h"
#include "ui/shell/ColorBar.h"
#include "ui/shell/PictureBar.h"
#include "ui/shell/ScenePresenter.h"
#include "ui/shell/SectionBar.h"
#include "ui/shell/ViewArea.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr const char* kMouseKey = "view/mouse";
constexpr double kSlab_m = 0.2;

struct MouseChoice {
    const char* action;
    NavigationPreset preset;
};
constexpr MouseChoice kMice[] = {{"view.mouse-own", NavigationPreset::vestige},
                                 {"view.mouse-cloudcompare", NavigationPreset::cloudCompare},
                                 {"view.mouse-slicer", NavigationPreset::slicer}};

/// Half as long as the scene each way, or nothing would be left when its inside is cut away.
SectionBox middleOf(const BoundingBox& scene) {
    SectionBox box = sectionRound(scene);
    box.halfSize *= 0.5;
    return box;
}

void check(QAction& action, bool on) {
    const QSignalBlocker quiet(action);
    action.setChecked(on);
}

}  // namespace

ViewControls::ViewControls(const Workbench& bench, SceneView& view, ScenePresenter& presenter,
                           QObject* parent)
    : QObject(parent), bench_(bench), view_(view), presenter_(presenter), section_(bench.presentation) {
    view_.setHandles(&section_);
    connectCameras();
    connectSection();
    connectMouse();
    bench_.actions.onTriggered(
        "view.save", [this] { saveView(QString::fromStdString(unusedViewName(bench_.document.state()))); });
    connect(&bench_.document, &Document::replaced, this, [this] {
        view_.setPivot(std::nullopt);
        lastSection_.reset();
        bench_.presentation.setSection(std::nullopt);
    });
}

ViewControls::~ViewControls() {
    view_.setHandles(nullptr);
}

void ViewControls::attach(ViewArea& area, ViewsPanel& panel) {
    area.addBar(new SectionBar(bench_.actions, bench_.presentation));
    area.addBar(new ColorBar(bench_.actions, bench_.presentation, view_));
    area.addBar(new PictureBar(bench_, view_));
    panel_ = &panel;
    connect(&panel, &ViewsPanel::wanted, this, &ViewControls::goTo);
    connect(&panel, &ViewsPanel::updateWanted, this, &ViewControls::saveView);
}

void ViewControls::connectCameras() {
    auto& actions = bench_.actions;
    actions.onTriggered("view.fit", [this] { presenter_.showAll(); });
    actions.onTriggered("view.pivot", [this] { view_.setPivotUnderCursor(); });
    actions.onToggled("view.parallel",
                      [this](bool on) { view_.setCamera(withProjection(view_.camera(), on)); });
    actions.onToggled("view.four",
                      [this](bool on) { view_.setLayout(on ? ViewLayout::four : ViewLayout::one); });
    const auto follow = [this] { check(bench_.actions["view.parallel"], view_.camera().parallel); };
    connect(&view_, &SceneView::cameraChanged, this, follow);
    connect(&view_, &SceneView::activePaneChanged, this, follow);
    connect(&view_, &SceneView::layoutChanged, this,
            [this] { check(bench_.actions["view.four"], view_.layout() == ViewLayout::four); });
}

void ViewControls::connectSection() {
    auto& actions = bench_.actions;
    auto& shown = bench_.presentation;
    actions.onToggled("view.section", [this, &shown](bool on) {
        if (!on) {
            lastSection_ = shown.section();
            shown.setSection(std::nullopt);
        } else if (!shown.section()) {
            shown.setSection(lastSection_.value_or(sectionRound(presenter_.placedBounds())));
        }
    });
    actions.onToggled("view.section-invert", [this, &shown](bool on) {
        SectionBox box = shown.section().value_or(lastSection_.value_or(middleOf(presenter_.placedBounds())));
        box.inverted = on;
        if (on || shown.section()) shown.setSection(box);
    });
    actions.onTriggered("view.section-reset",
                        [this, &shown] { shown.setSection(sectionRound(presenter_.placedBounds())); });
    actions.onTriggered("view.slab-x", [this] { cutTo(SlabAxis::x); });
    actions.onTriggered("view.slab-y", [this] { cutTo(SlabAxis::y); });
    actions.onTriggered("view.slab-z", [this] { cutTo(SlabAxis::z); });
    actions.onTriggered("view.slab-view", [this] { cutTo(SlabAxis::view); });
    actions.onTriggered("view.slab-on", [this] { section_.step(1); });
    actions.onTriggered("view.slab-back", [this] { section_.step(-1); });
    connect(&shown, &Presentation::sectionChanged, this, [this, &shown] {
        const bool on = shown.section().has_value();
        view_.showSectionHandles(on);
        QAction& action = bench_.actions["view.section"];
        if (action.isChecked() != on) action.setChecked(on);
        check(bench_.actions["view.section-invert"], on && shown.section()->inverted);
    });
}

void ViewControls::connectMouse() {
    const QString kept = QSettings().value(kMouseKey).toString();
    const MouseChoice* chosen = &kMice[0];
    for (const MouseChoice& mouse : kMice) {
        if (kept == mouse.action) chosen = &mouse;
        bench_.actions.onToggled(mouse.action, [this, &mouse](bool on) {
            if (!on) return;
            view_.setNavigation(mouse.preset);
            QSettings().setValue(kMouseKey, mouse.action);
        });
    }
    check(bench_.actions[chosen->action], true);
    view_.setNavigation(chosen->preset);
}

/// Through the middle of the section there is, else of the scene.
void ViewControls::cutTo(SlabAxis axis) {
    auto& shown = bench_.presentation;
    SectionBox cut = slab(presenter_.placedBounds(), axis, kSlab_m, view_.camera());
    if (shown.section()) {
        // The other sides stay those of the whole scene; only where it is thin the slab keeps its place.
        const int thin = thinAxis(cut);
        const Eigen::Vector3d across = axisOf(cut, thin);
        cut.inverted = shown.section()->inverted;
        cut.centre += across.dot(shown.section()->centre - cut.centre) * across;
    }
    shown.setSection(cut);
}

void ViewControls::saveView(const QString& name) {
    const SceneState& scene = bench_.document.state();
    const SavedView* known = savedView(scene, name.toStdString());
    SavedView view = known ? *known : SavedView{};
    view.name = name.toStdString();
    view.camera = view_.camera();
    view.section = bench_.presentation.section();
    view.colorMode = std::string(vestige::name(bench_.presentation.colorMode()));
    if (!view.camera.parallel) view.scale.reset();
    bench_.document.perform(setSavedView(std::move(view)));
    if (!known && panel_) panel_->editName(name);
}

void ViewControls::goTo(const QString& name) {
    const SavedView* saved = savedView(bench_.document.state(), name.toStdString());
    if (!saved) return;
    const SavedView view = *saved;
    const ViewCamera now = view_.camera();
    bench_.presentation.setSection(view.section);
    if (const auto mode = colorModeFromName(view.colorMode)) {
        bench_.presentation.setOverlay(Overlay::none);
        bench_.presentation.setColorMode(*mode);
    }
    view_.setCamera(resized(view.camera, now.width_px, now.height_px));
}

}  // namespace vestige
