#include "ui/actions/reactions/CompareReactions.h"

#include <QSignalBlocker>
#include <array>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Comparison.h"
#include "ui/document/Presentation.h"
#include "ui/document/Preview.h"

namespace vestige {
namespace {

constexpr std::array<std::pair<const char*, CompareMode>, 3> kModes{
    {{"compare.swipe", CompareMode::swipe},
     {"compare.blink", CompareMode::blink},
     {"compare.checkerboard", CompareMode::checkerboard}}};

}  // namespace

CompareReactions::CompareReactions(const Workbench& bench, QObject* parent) : QObject(parent), bench_(bench) {
    auto& actions = bench_.actions;
    for (const auto& [id, mode] : kModes)
        actions.onToggled(id, [this, mode = mode](bool on) { compare(mode, on); });
    actions.onTriggered("compare.poses",
                        [this] { bench_.comparison.setWhat(Comparison::What::beforeAfter); });
    actions.onTriggered("compare.layers",
                        [this] { bench_.comparison.setWhat(Comparison::What::sourceTarget); });
    actions.onTriggered("compare.end", [this] {
        bench_.comparison.setMode(std::nullopt);
        bench_.preview.end();
    });
    connect(&bench_.comparison, &Comparison::switched, this, [this] { follow(); });
    connect(&bench_.comparison, &Comparison::adjusted, this, [this] { follow(); });
    follow();
}

void CompareReactions::compare(CompareMode mode, bool on) {
    if (on && !bench_.comparison.active()) {
        bench_.presentation.setBefore(false);
        bench_.presentation.setOverlay(Overlay::registration);
    }
    bench_.comparison.setMode(on ? std::optional(mode) : std::nullopt);
}

void CompareReactions::follow() {
    const auto check = [this](const char* id, bool on) {
        QAction& action = bench_.actions[id];
        const QSignalBlocker quiet(action);
        action.setChecked(on);
    };
    for (const auto& [id, mode] : kModes) check(id, bench_.comparison.mode() == mode);
    const bool poses = bench_.comparison.what() == Comparison::What::beforeAfter;
    check("compare.poses", poses);
    check("compare.layers", !poses);
}

}  // namespace vestige
