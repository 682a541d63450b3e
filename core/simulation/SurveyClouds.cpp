#include <array>

#include "core/base/AtomicFile.h"
#include "core/base/Csv.h"
#include "core/base/Numbers.h"
#include "core/io/FormatRegistry.h"
#include "core/io/LasWriter.h"
#include "core/simulation/SurveyFiles.h"

namespace vestige {
namespace {

/// The coordinate system as LAS 1.4 wants it (OGC WKT 1).
CrsRecord utmRecord(const SiteSpec& site) {
    const std::string zone = std::to_string(site.utmZone) + (site.north ? "N" : "S");
    const std::string code = std::to_string((site.north ? 32600 : 32700) + site.utmZone);
    const std::string wkt =
        "PROJCS[\"WGS 84 / UTM zone " + zone +
        "\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563,"
        "AUTHORITY[\"EPSG\",\"7030\"]],AUTHORITY[\"EPSG\",\"6326\"]],PRIMEM[\"Greenwich\",0],"
        "UNIT[\"degree\",0.0174532925199433],AUTHORITY[\"EPSG\",\"4326\"]],"
        "PROJECTION[\"Transverse_Mercator\"],PARAMETER[\"latitude_of_origin\",0],"
        "PARAMETER[\"central_meridian\"," +
        std::to_string(6 * site.utmZone - 183) +
        "],PARAMETER[\"scale_factor\",0.9996],PARAMETER[\"false_easting\",500000],"
        "PARAMETER[\"false_northing\"," +
        (site.north ? "0" : "10000000") + "],UNIT[\"metre\",1],AUTHORITY[\"EPSG\",\"" + code + "\"]]";
    CrsRecord record;
    record.userId = "LASF_Projection";
    record.recordId = 2112;
    record.description = "OGC WKT";
    record.bytes.assign(wkt.begin(), wkt.end());
    record.bytes.push_back(0);
    return record;
}

Status writePairs(const std::vector<RoughPair>& pairs, const std::filesystem::path& file) {
    std::string text = csvLine({"tx", "ty", "tz", "sx", "sy", "sz"});
    for (const RoughPair& pair : pairs) {
        // As a person would write them down: millimetres on the ground, a tenth of one on the scan.
        std::vector<std::string> cells;
        for (int axis = 0; axis < 3; ++axis) cells.push_back(fixedText(pair.target[axis], 3));
        for (int axis = 0; axis < 3; ++axis) cells.push_back(fixedText(pair.source[axis], 1));
        text += csvLine(cells);
    }
    return writeTextFile(file, text);
}

}  // namespace

Status writeSurveyClouds(const Survey& survey, const SceneSpec& spec, const std::filesystem::path& folder,
                         const JobControl& control, SimulatedScene& written) {
    const auto note = [&](const std::string& name, const std::string& layer, std::size_t points) {
        written.files.push_back(name);
        written.points[layer] = points;
    };
    LasWriteOptions options;
    options.scale = Eigen::Vector3d::Constant(0.001);
    options.offset = survey.worldFromSite.array().round().matrix();
    options.crsRecords = {utmRecord(spec.site)};
    options.gpsTimeIsAdjustedStandard = true;
    options.creationDay = spec.site.day;
    options.creationYear = spec.site.year;
    const LasPart part{&survey.aerial.cloud, {}, 1};
    control.progress(0, "writing aerial.laz");
    if (const Status done = writeLas(folder / "aerial.laz", {part}, options, control.sub(0, 0.8)); !done)
        return done;
    note("aerial.laz", "aerial", survey.aerial.cloud.size());
    for (const HandheldLayer& layer : survey.handheld) {
        const std::string name = layer.id + ".ply";
        control.progress(0.8, "writing " + name);
        if (const Status done = writeGeometry(folder / name, {layer.scan.cloud, {}}); !done) return done;
        note(name, layer.id, layer.scan.cloud.size());
        if (const Status done = writePairs(layer.pairs, folder / (layer.id + "_picks.csv")); !done)
            return done;
        written.files.push_back(layer.id + "_picks.csv");
    }
    if (survey.photo) {
        control.progress(0.9, "writing photo.ply");
        if (const Status done = writeGeometry(folder / "photo.ply", {survey.photo->cloud, {}}); !done)
            return done;
        note("photo.ply", "photo", survey.photo->cloud.size());
    }
    return {};
}

}  // namespace vestige
