#include "core/report/CaseReport.h"

namespace vestige {
namespace {

Table parameterTable(const std::string& caption, const ParameterSet& parameters) {
    Table table;
    table.caption = caption;
    table.columns = {"Parameter", "Value", "", "Meaning"};
    table.numeric = {false, false, false, false};
    table.widths = {30, 22, 12, 70};
    for (const auto& spec : parameters.table())
        table.rows.push_back({spec.label, parameters.display(spec.key),
                              parameters.isDefault(spec.key) ? "default" : "set", spec.help});
    return table;
}

}  // namespace

Section methodSection(const ReportInput& input) {
    return {
        "Method and parameters",
        {Paragraph{
             "The scene is reconstructed in these steps. The global cloud is cleaned and thinned to evenly "
             "spread "
             "points, which are used for fitting only. Each handheld scan is brought to a first position by "
             "picked "
             "pairs of points or by a given pose, and then fitted to the global cloud by the normal "
             "distributions "
             "transform (NDT): the space of the global cloud is divided into cells, the points of each cell "
             "are "
             "described by their mean and spread, and the scan is moved, without bending or scaling, to "
             "where its "
             "points are most probable; the cells become smaller step by step. Lengths are then measured "
             "between "
             "points picked in the original clouds. After Zhang, Guan, Liu and Zhang, World Electric Vehicle "
             "Journal 2025, 16(3), 171."},
         parameterTable("Cleaning and thinning", input.scene.preprocess),
         parameterTable("Registration", input.scene.registration)}};
}

}  // namespace vestige
