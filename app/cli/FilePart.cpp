#include "app/cli/FilePart.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/cli/Outputs.h"
#include "app/cli/Session.h"
#include "core/base/Numbers.h"
#include "core/io/FormatRegistry.h"
#include "core/pipeline/LoadLayers.h"

namespace vestige::cli {
namespace {

/// "xmin,ymin,zmin,xmax,ymax,zmax"; nothing when the text is something else.
std::optional<BoundingBox> boxFromText(const std::string& text) {
    std::vector<double> sides;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        const auto side = parseReal(text.substr(begin, end - begin));
        if (!side || !std::isfinite(*side)) return std::nullopt;
        sides.push_back(*side);
        begin = end + 1;
    }
    if (sides.size() != 6) return std::nullopt;
    BoundingBox box;
    box.min = {sides[0], sides[1], sides[2]};
    box.max = {sides[3], sides[4], sides[5]};
    if (box.empty()) return std::nullopt;
    return box;
}

}  // namespace

ReadOptions FilePart::options(ReadOptions::Attributes attributes) const {
    ReadOptions options;
    options.attributes = attributes;
    options.keepEvery = every;
    options.box = box;
    options.salvage = salvage;
    return options;
}

void addPartOptions(CLI::App& command, FilePart& part, const std::string& boxed) {
    addSalvageOption(command, part.salvage);
    command.add_option("--every", part.every, "Only every K-th point of the input. Default: 1.")
        ->type_name("K")
        ->check(CLI::Range(1U, 2000000000U));
    command
        .add_option_function<std::string>(
            "--box", [&part](const std::string& text) { part.box = boxFromText(text); },
            "Only the points of " + boxed + " in this box, in its own unit and frame.")
        ->type_name("xmin,ymin,zmin,xmax,ymax,zmax")
        ->check(CLI::Validator(
            [](const std::string& text) {
                return boxFromText(text)
                           ? std::string()
                           : std::string(
                                 "six numbers are expected, the least coordinates before the greatest: "
                                 "xmin,ymin,zmin,xmax,ymax,zmax");
            },
            "", "box"));
}

Result<LoadedGeometry> readPart(const std::filesystem::path& file, const FilePart& part,
                                ReadOptions::Attributes attributes, LoadedFor use,
                                const JobControl& control) {
    const ReadOptions options = part.options(attributes);
    const auto check = checkLoad(file, options, use);
    if (!check) return fail(check.error());
    if (!check->estimate.fits())
        return fail(tooLarge(file, check->estimate, commandLineOffer(check->estimate)));
    Result<LoadedGeometry> loaded = readGeometry(file, options, control);
    if (loaded && part.box && loaded->geometry.vertices.empty())
        loaded->info.warnings.push_back("the box holds no point of it" +
                                        (check->peeked.bounds.empty()
                                             ? std::string()
                                             : "; it reaches from " + coordinates(check->peeked.bounds.min) +
                                                   " to " + coordinates(check->peeked.bounds.max) +
                                                   ", in its own unit"));
    return loaded;
}

}  // namespace vestige::cli
