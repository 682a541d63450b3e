#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"
#include "core/scene/Cleaning.h"
#include "core/scene/FileEvidence.h"

namespace vestige {
namespace {

std::string extentText(const Layer& layer) {
    const Eigen::Vector3d extent = layer.metresPerUnit() * layer.data->points->bounds().extent();
    return fixedText(extent.x(), 2) + " \u00d7 " + fixedText(extent.y(), 2) + " \u00d7 " +
           fixedText(extent.z(), 2);
}

/// "front: every 4th point" of each layer of which not all is loaded.
std::string loadedParts(const SceneState& scene) {
    std::string parts;
    for (const Layer& layer : scene.layers) {
        if (!layer.isThinned()) continue;
        parts += (parts.empty() ? "" : "; ") + layer.name + ": ";
        if (layer.keepEvery > 1) parts += "one of every " + std::to_string(layer.keepEvery) + " points";
        if (layer.keepEvery > 1 && layer.box) parts += " of ";
        if (!layer.box) continue;
        const auto corner = [](const Eigen::Vector3d& place) {
            return "(" + fixedText(place.x(), 2) + ", " + fixedText(place.y(), 2) + ", " +
                   fixedText(place.z(), 2) + ")";
        };
        parts += "the points from " + corner(layer.box->min) + " to " + corner(layer.box->max) +
                 " in the file's own frame and unit";
    }
    return parts;
}

}  // namespace

Section inputSection(const ReportInput& input) {
    Section section{"Evidence used", {}};
    Table table;
    table.caption = "Files";
    table.columns = {"No.", "Layer", "Role", "File", "Format", "Unit", "Points", "Extent (m)"};
    table.numeric = {true, false, false, false, false, false, true, false};
    Facts hashes;
    for (std::size_t i = 0; i < input.scene.layers.size(); ++i) {
        const Layer& layer = input.scene.layers[i];
        if (!loadedData(layer)) continue;
        const FileInfo& info = layer.data->info;
        table.rows.push_back({std::to_string(i + 1), layer.name, say(name(layer.role)),
                              layer.path.filename().string(),
                              info.format + (info.version.empty() ? "" : " " + say(info.version)),
                              std::string(symbol(layer.lengthUnit())),
                              grouped(loadedData(layer)->points->size()), extentText(layer)});
        hashes.rows.emplace_back(layer.path.filename().string(), layer.data->sha256);
    }
    if (table.rows.empty()) return section;
    section.blocks.push_back(Paragraph{
        "The number of a file is the number that its points carry in the fused cloud (\u201cpoint source "
        "ID\u201d). The files "
        "were only read; measuring is done on their original points, never on thinned or smoothed ones."});
    section.blocks.push_back(std::move(table));
    for (const Layer& layer : input.scene.layers)
        if (layer.data && !layer.data->info.damage.empty())
            section.blocks.push_back(Paragraph{"Only part of " + layer.path.filename().string() +
                                               " could be read: " + layer.data->info.damage +
                                               ". What is missing is not known."});
    for (const Layer& layer : input.scene.layers)
        if (const auto difference = evidenceDifference(layer))
            section.blocks.push_back(Paragraph{"A file changed: " + *difference + "."});
    if (const std::string parts = loadedParts(input.scene); !parts.empty())
        section.blocks.push_back(Paragraph{"Of some files only a part was loaded: " + parts + "."});
    section.blocks.push_back(
        Paragraph{"The SHA-256 value of a file is a fingerprint of its content: a file with the same value "
                  "is the same file, byte by "
                  "byte. Whoever holds the files can recompute it with any tool."});
    section.blocks.push_back(std::move(hashes));
    return section;
}

}  // namespace vestige
