#include "core/base/Numbers.h"
#include "core/base/Units.h"
#include "core/report/AdjustmentBlocks.h"
#include "core/report/CaseReport.h"
#include "core/report/QualityBlocks.h"
#include "core/report/Wording.h"

namespace vestige {
namespace {

std::string poseRow(const Pose& pose, int row) {
    std::string text;
    for (int column = 0; column < 4; ++column)
        text += (column ? "   " : "") + fixedText(pose.matrix()(row, column), column < 3 ? 7 : 4);
    return text;
}

/// How far the fit moved the scan from its first position, seen at the scan's own middle.
std::string correction(const Layer& layer) {
    const RegistrationResult& result = *layer.registration;
    const Eigen::Vector3d middle =
        layer.data ? layer.data->points->bounds().centre() : Eigen::Vector3d::Zero();
    const double shift = (result.targetFromSource * middle - result.initial * middle).norm();
    const Pose turn = result.targetFromSource.pose * result.initial.pose.inverse();
    return fixedText(1000 * shift, 1) + " mm and " + fixedText(degrees(rotationAngle(turn.linear())), 3) +
           "\u00b0";
}

Facts facts(const Layer& layer) {
    const RegistrationResult& result = *layer.registration;
    return {{{"Scan", layer.name},
             {"Algorithm", result.method},
             {"Settled", result.converged
                             ? "yes, after " + howMany(static_cast<std::size_t>(result.iterations), "step")
                             : "no: the limit of steps was reached"},
             {"Distance to the global cloud",
              fixedText(1000 * result.rmse_m, 1) +
                  " mm (root mean square of the points that found a counterpart)"},
             {"Points with a counterpart", percent(result.overlap)},
             {"Moved by the fit", correction(layer)},
             {"Metres per unit of the file", exactText(result.targetFromSource.scale)},
             {"Pose (rotation | translation in m)", poseRow(result.targetFromSource.pose, 0) + "\n" +
                                                        poseRow(result.targetFromSource.pose, 1) + "\n" +
                                                        poseRow(result.targetFromSource.pose, 2)}}};
}

Table levelTable(const RegistrationResult& result) {
    Table table;
    table.caption = "Steps of the fit, from coarse to fine cells";
    table.columns = {"Cell (m)", "Steps", "Score", "Ended because"};
    table.numeric = {true, true, true, false};
    table.widths = {1, 1, 1.4, 4};
    for (const auto& level : result.levels)
        table.rows.push_back({fixedText(level.voxel_m, 3), std::to_string(level.iterations),
                              fixedText(level.score, 5), std::string(describe(level.stop))});
    return table;
}

}  // namespace

Section registrationSection(const ReportInput& input) {
    Section section{"Registration", {}};
    for (const auto& layer : input.scene.layers) {
        if (!layer.registration) continue;
        section.blocks.push_back(facts(layer));
        for (Block& block : qualityBlocks(*layer.registration)) section.blocks.push_back(std::move(block));
        for (const auto& note : layer.registration->notes)
            section.blocks.push_back(Paragraph{"Note: " + note + "."});
        if (!layer.registration->levels.empty()) section.blocks.push_back(levelTable(*layer.registration));
        for (const auto& picture : input.pictures)
            if (picture.subject == layer.id &&
                (picture.kind == ReportPicture::Kind::before || picture.kind == ReportPicture::Kind::after))
                section.blocks.push_back(Picture{picture.png, picture.caption, 0.5});
    }
    if (input.adjustment)
        for (Block& block : adjustmentBlocks(*input.adjustment, input.scene))
            section.blocks.push_back(std::move(block));
    if (!section.blocks.empty())
        section.blocks.insert(
            section.blocks.begin(),
            Paragraph{
                "Registration is the fitting of a scan into the frame of the global cloud. A pose maps a "
                "point x of the file to R (s x) + t, with the rotation R, the metres per unit s and the "
                "translation t; R and t are rigid and change no length. Exact values are in "
                "registration.json."});
    return section;
}

}  // namespace vestige
