#include "ui/shell/CleaningTools.h"

#include "core/base/Numbers.h"
#include "core/geometry/PointsInOutline.h"
#include "core/report/Wording.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/CleaningSettings.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Selection.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

/// What a job selects from, kept alive.
struct Asked {
    std::vector<std::string> ids;
    std::vector<std::shared_ptr<const LayerData>> data;
    std::vector<std::shared_ptr<const std::vector<std::uint8_t>>> hidden;
    std::vector<Similarity> places;
    ViewCamera camera;
    std::vector<Eigen::Vector2d> corners;
    OutlineOptions options;
};

struct Found {
    PointSelection::Sets sets;
    std::optional<std::pair<double, double>> reach;
    std::size_t behind = 0;
};

/// So far behind what is seen, points of a surface's noise or of an object's own back are none.
constexpr double kBehind_m = 1;

Result<Found> find(const Asked& asked, const JobControl& control) {
    std::vector<PickLayer> layers;
    for (std::size_t i = 0; i < asked.ids.size(); ++i)
        layers.push_back({static_cast<std::uint32_t>(i), asked.data[i]->octree.get(), asked.places[i],
                          asked.hidden[i].get()});
    auto within = pointsInOutline(layers, asked.camera, asked.corners, asked.options, control);
    if (!within) return fail(within.error());
    Found found;
    found.behind = within->behind;
    for (std::size_t i = 0; i < asked.ids.size(); ++i)
        found.sets[asked.ids[i]] = loadedIndices(*asked.data[i], std::move(within->points[i]));
    if (within->nearest_m) found.reach = {*within->nearest_m, *within->deepest_m};
    return found;
}

std::string wordsOf(const Asked& asked, const Found& found) {
    std::string words = asked.options.outside ? "outside" : "inside";
    if (asked.options.depth_m) words += ", " + exactText(*asked.options.depth_m) + " m deep";
    if (found.reach) words += " (to " + fixedText(found.reach->second, 2) + " m from the eye)";
    return words;
}

}  // namespace

CleaningTools::CleaningTools(const Workbench& bench, SceneView& view, HoverProbe& probe, QObject* parent)
    : QObject(parent),
      bench_(bench),
      view_(view),
      lasso_(OutlineTool::Shape::lasso, probe),
      box_(OutlineTool::Shape::box, probe) {
    for (const auto& [id, tool, how] :
         {std::tuple("tool.lasso", &lasso_, "lasso"), std::tuple("tool.box-select", &box_, "box")}) {
        bench_.actions.onToggled(id, [this, tool = tool](bool on) {
            if (!on) return;
            view_.setTool(tool);
            view_.widget()->setFocus();
        });
        connect(tool, &OutlineTool::hintChanged, this, &CleaningTools::hintChanged);
        connect(tool, &OutlineTool::closed, this,
                [this, how = how](const auto& corners, auto modifiers) { select(corners, modifiers, how); });
        connect(&bench_.document, &Document::replaced, tool, &OutlineTool::abandon);
    }
}

void CleaningTools::select(const std::vector<Eigen::Vector2d>& corners, Qt::KeyboardModifiers modifiers,
                           const char* how) {
    const ViewDescription& shown = view_.description();
    const ParameterSet& settings = bench_.cleaning.outline;
    Asked asked;
    asked.camera = view_.camera();
    asked.corners = corners;
    asked.options.depth_m = settings.optionalReal("depth_m");
    asked.options.outside = settings.text("side") == "outside";
    if (!asked.options.depth_m) asked.options.behind_m = kBehind_m;
    if (shown.section) asked.options.clips = shown.section->region();
    const bool one = settings.text("scope") == "selected";
    bool preview = false;
    for (const ViewLayer& layer : shown.layers) {
        const Layer* held = bench_.document.state().layer(layer.id);
        if (!layer.visible || !held || !held->data || (one && layer.id != bench_.selection.layer())) continue;
        preview = preview || held->data->isPreview();
        if (held->data->isPreview()) continue;
        asked.ids.push_back(layer.id);
        asked.data.push_back(held->data);
        const bool fits = layer.hidden && layer.hidden->size() == held->data->points->size();
        asked.hidden.push_back(fits ? layer.hidden : nullptr);
        asked.places.push_back(layer.worldFromLayer);
    }
    if (asked.ids.empty())
        return bench_.notices.inform(
            preview ? tr("The points are still being read; select when all are there.")
            : one   ? tr("Select a layer first, or let the outline take all that are shown.")
                    : tr("No layer is shown."));
    const auto mode = modifiers & Qt::ShiftModifier     ? PointSelection::Mode::add
                      : modifiers & Qt::ControlModifier ? PointSelection::Mode::subtract
                                                        : PointSelection::Mode::replace;
    bench_.jobs.run<Found>(
        tr("Selecting points"), [asked](const JobControl& control) { return find(asked, control); },
        [this, asked, mode, how](Result<Found> found) {
            if (!found) return bench_.notices.failed(found.error());
            bench_.points.setReach(found->reach);
            // Outlines may overlap: an upper bound, which no later outline hides.
            const bool anew = mode == PointSelection::Mode::replace;
            const bool taken = mode == PointSelection::Mode::subtract;
            bench_.points.setBehind((anew ? 0 : bench_.points.behind()) + (taken ? 0 : found->behind));
            bench_.points.apply(found->sets, mode, {how, wordsOf(asked, *found), 0});
            if (bench_.points.size() == 0) return bench_.notices.inform(tr("No point lies there."));
            if (bench_.points.behind() == 0) return;
            const QString sentence =
                tr("up to %1 of the points selected lie behind what is seen; a Depth leaves them out")
                    .arg(QString::fromStdString(grouped(bench_.points.behind())));
            // After the tool's own hint, which comes when the event that closed the outline ends.
            QMetaObject::invokeMethod(
                this, [this, sentence] { emit hintChanged(sentence); }, Qt::QueuedConnection);
        });
}

}  // namespace vestige
