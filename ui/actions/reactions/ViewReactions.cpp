#include "ui/actions/reactions/ViewReactions.h"

#include <QSignalBlocker>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Presentation.h"

namespace vestige {
namespace {

std::string colorAction(ColorMode mode) {
    return "view.color-" + std::string(name(mode));
}

constexpr ColorMode kColorModes[] = {ColorMode::source, ColorMode::height, ColorMode::intensity,
                                     ColorMode::rgb, ColorMode::classification};
constexpr NamedView kViews[] = {NamedView::perspective, NamedView::top,  NamedView::front, NamedView::left,
                                NamedView::iso,         NamedView::back, NamedView::right, NamedView::bottom};

}  // namespace

ViewReactions::ViewReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    auto& shown = bench_.presentation;
    for (const ColorMode mode : kColorModes)
        actions.onTriggered(colorAction(mode), [&shown, mode] {
            shown.setOverlay(Overlay::none);
            shown.setColorMode(mode);
        });
    for (const NamedView view : kViews)
        actions.onTriggered("view." + std::string(name(view)), [this, view] { emit namedViewWanted(view); });
    actions.onToggled("view.edl", [&shown](bool on) { shown.setEyeDomeLighting(on); });
    actions.onToggled("view.grid", [&shown](bool on) { shown.setGrid(on); });
    actions.onToggled("view.north", [&shown](bool on) { shown.setNorthArrow(on); });
    actions.onToggled("view.near-size", [&shown](bool on) { shown.setSizeByDistance(on); });
    actions.onTriggered("view.larger-points", [&shown] { shown.setPointSize(shown.pointSize_px() + 1); });
    actions.onTriggered("view.smaller-points", [&shown] { shown.setPointSize(shown.pointSize_px() - 1); });
    actions.onToggled("view.light", [&shown](bool on) { shown.setTheme(on ? Theme::light : Theme::dark); });
    actions.onToggled("register.tint",
                      [&shown](bool on) { shown.setOverlay(on ? Overlay::registration : Overlay::none); });
    actions.onToggled("register.residual",
                      [&shown](bool on) { shown.setOverlay(on ? Overlay::residual : Overlay::none); });
    actions.onToggled("register.before", [&shown](bool on) { shown.setBefore(on); });
    actions.onToggled("register.freedom", [&shown](bool on) { shown.setFreeDirections(on); });
    connect(&shown, &Presentation::changed, this, [this] { follow(); });
    follow();
}

void ViewReactions::follow() {
    const auto& shown = bench_.presentation;
    const auto check = [this](const std::string& id, bool on) {
        QAction& action = bench_.actions[id];
        const QSignalBlocker quiet(action);
        action.setChecked(on);
    };
    for (const ColorMode mode : kColorModes) check(colorAction(mode), shown.colorMode() == mode);
    check("view.light", shown.theme() == Theme::light);
    check("view.edl", shown.eyeDomeLighting());
    check("view.grid", shown.grid());
    check("view.north", shown.northArrow());
    check("view.near-size", shown.sizeByDistance());
    check("register.tint", shown.overlay() == Overlay::registration);
    check("register.residual", shown.overlay() == Overlay::residual);
    check("register.before", shown.before());
    check("register.freedom", shown.freeDirections());
}

}  // namespace vestige
