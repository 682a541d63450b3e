#include <algorithm>

#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/report/BudgetBlocks.h"
#include "core/report/CaseReport.h"
#include "core/report/Wording.h"

namespace vestige {

Section uncertaintySection(const ReportInput& input) {
    Section section{"Uncertainty of the figures", {}};
    if (input.measured.lengths.empty() && input.measured.kinds.empty()) return section;
    section.blocks.push_back(
        Paragraph{"The uncertainty of a length is found after the \u201cGuide to the expression of "
                  "uncertainty in measurement\u201d (GUM). "
                  "Its standard uncertainty u has four parts, added as squares: the scatter of the repeats "
                  "(their standard deviation "
                  "divided by the square root of their number), the standard uncertainty of each of the two "
                  "ends, and, where the ends lie "
                  "on different scans, the registration's share along the length. The uncertainty of an end "
                  "joins the noise of the sensor "
                  "with the spacing d of the points around it, which counts d divided by the square root of "
                  "12. The expanded uncertainty "
                  "is U = k u, where k is taken from Student's t distribution so that the interval holds the "
                  "true value with a "
                  "probability of 95 % although only few repeats were made. With one repeat the scatter is "
                  "unknown and U is not given."});
    if (std::any_of(input.measured.lengths.begin(), input.measured.lengths.end(),
                    [](const MeasuredLength& length) { return length.fitted; }))
        section.blocks.push_back(Paragraph{
            "Of a fitted end the uncertainty is that of the fit, from the scatter of its points about the "
            "feature and their number. Repeats are fitted to the same points, so this part does not shrink "
            "with their number. A surface that faces along the length is seen from its own side of the site "
            "alone, at another time than the one at the other end: 10 mm (one standard deviation) are added "
            "for the drift of the aircraft\u2019s navigation."});
    Table table;
    table.caption = "Sensor noise assumed for each scan";
    table.columns = {"Scan", "Role", "Standard deviation (mm)"};
    table.numeric = {false, false, true};
    for (const auto& layer : input.scene.layers)
        table.rows.push_back(
            {layer.name, say(name(layer.role)), fixedText(1000 * sensorNoise_m(layer.role), 1)});
    section.blocks.push_back(std::move(table));

    double largest = 0;
    std::string where;
    for (const auto& length : input.measured.lengths) {
        if (!length.tape_m || *length.tape_m <= 0) continue;
        const double share = length.tapeUncertainty_m / *length.tape_m;
        if (share <= largest) continue;
        largest = share;
        where = length.object + " (tape " + exactText(*length.tape_m) + " m, standard uncertainty " +
                fixedText(1000 * length.tapeUncertainty_m, 1) + " mm)";
    }
    if (largest > 0)
        section.blocks.push_back(Paragraph{
            "The tape itself is read to its last digit only, which gives it a standard uncertainty of that "
            "digit divided by the "
            "square root of 12. This limits what a relative error can show, most for short objects: here " +
            percent(largest, 2) + " for " + where + "."});
    addBudgets(section, input.measured);
    return section;
}

}  // namespace vestige
