// Single-point and fitted lengths of simulated cases against their tape.
//
//   fitted_table CASE/case.json...|SCENE:SEED... [--each] [--poses] [--cache DIR]
//
// SCENE:SEED is simulated (two-cars:3, yard.json:1; without photographs) into DIR unless it is there.
// A line per object and method with --each; RMSE of all RE, and how often U covers the tape, over all cases
// by method. With --poses handheld layers take the true pose of truth.json instead of being registered.
#include <cmath>
#include <cstdio>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/pipeline/LoadLayers.h"
#include "core/pipeline/RegisterLayers.h"
#include "core/pipeline/ResolveAims.h"
#include "core/scene/CaseFile.h"
#include "core/scene/MeasuredScene.h"
#include "core/simulation/SimulateScene.h"

namespace {

using namespace vestige;

struct Tally {
    double squares = 0, squaresLarge = 0, metres = 0;
    std::size_t n = 0, large = 0, covered = 0, withU = 0;
    void add(const MeasuredLength& length) {
        const double re = *length.re;
        squares += re * re;
        ++n;
        if (!length.small) {
            squaresLarge += re * re;
            ++large;
        }
        const double error = length.length->mean_m - *length.tape_m;
        metres += error * error;
        if (!length.length->expandedUncertainty_m) return;
        ++withU;
        if (std::abs(error) <= *length.length->expandedUncertainty_m) ++covered;
    }
    void print(const std::string& name) const {
        const auto rms = [](double sum, std::size_t count) {
            return std::sqrt(sum / std::max<double>(1, static_cast<double>(count)));
        };
        std::printf("%-52s n %4zu  RMSE of RE %.4f  large %.4f (%zu)  %.1f mm  U covers %zu of %zu\n",
                    name.c_str(), n, rms(squares, n), rms(squaresLarge, large), large, 1000 * rms(metres, n),
                    covered, withU);
    }
};

bool measureCase(const std::string& file, bool each, bool poses, std::map<std::string, Tally>& byMethod,
                 std::map<std::string, Tally>& byObject) {
    auto scene = readCase(file);
    if (!scene) {
        std::fprintf(stderr, "%s\n", scene.error().sentence().c_str());
        return false;
    }
    for (Layer& layer : scene->layers) {
        auto data = loadLayer(layer, layer.path, {});
        if (!data) {
            std::fprintf(stderr, "%s\n", data.error().sentence().c_str());
            return false;
        }
        layer.data = *data;
    }
    nlohmann::json truth;
    std::ifstream(std::filesystem::path(file).parent_path() / "truth.json") >> truth;
    for (Layer& layer : scene->layers) {
        if (!needsRegistration(*scene, layer)) continue;
        if (poses) {
            const auto& json = truth["layers"][layer.id];
            RegistrationResult result;
            result.targetFromSource.pose = *poseFromRowMajor(json["pose"].get<std::array<double, 16>>());
            result.targetFromSource.scale = json["scale"].get<double>();
            layer.registration = result;
            continue;
        }
        auto result = registerLayer(*scene, layer.id, {});
        if (!result) {
            std::fprintf(stderr, "%s\n", result.error().sentence().c_str());
            return false;
        }
        layer.registration = *result;
    }
    scene->measurements = resolveAims(*scene, {});
    const MeasuredScene measured = measureScene(*scene);
    for (const MeasuredLength& length : measured.lengths) {
        if (each && length.length) {
            std::printf("  %-46s %-24s tape %.3f mean %.4f  %+6.1f mm  RE %+.4f  sd %.4f  U %.4f %s %s\n",
                        length.object.c_str(), length.method.c_str(), *length.tape_m, length.length->mean_m,
                        1000 * (length.length->mean_m - *length.tape_m), *length.re,
                        length.length->repeatSd_m.value_or(0),
                        length.length->expandedUncertainty_m.value_or(0), length.small ? "small" : "",
                        length.note.c_str());
        } else if (each && length.fitted) {
            std::printf("  %-46s %-24s none: %s\n", length.object.c_str(), length.method.c_str(),
                        length.note.c_str());
        }
        if (!length.length || !length.re) continue;
        byMethod[length.method].add(length);
        byObject[length.object + ", " + length.method].add(length);
    }
    return true;
}

/// The case of "SCENE:SEED", simulated if it is not in the cache yet; other arguments are files.
std::string caseOf(const std::string& argument, const std::filesystem::path& cache) {
    const auto colon = argument.rfind(':');
    if (colon == std::string::npos) return argument;
    const std::string scene = argument.substr(0, colon);
    const std::filesystem::path folder =
        cache / (std::filesystem::path(scene).stem().string() + "-" + argument.substr(colon + 1));
    if (std::filesystem::exists(folder / "case.json")) return (folder / "case.json").string();
    auto spec = sceneSpec(scene);
    if (!spec || !spec->photogrammetry.set("enabled", false)) return argument;
    SimulationOptions options;
    options.seed = std::stoull(argument.substr(colon + 1));
    std::filesystem::create_directories(cache);
    const auto made = simulateScene(*spec, options, folder, {});
    if (!made) std::fprintf(stderr, "%s\n", made.error().sentence().c_str());
    return (folder / "case.json").string();
}

}  // namespace

int main(int argc, char** argv) {
    std::vector<std::string> files;
    bool each = false;
    bool poses = false;
    std::filesystem::path cache = "fitted-cases";
    for (int i = 1; i < argc; ++i) {
        const std::string argument = argv[i];
        if (argument == "--each")
            each = true;
        else if (argument == "--poses")
            poses = true;
        else if (argument == "--cache" && i + 1 < argc)
            cache = argv[++i];
        else
            files.push_back(argument);
    }
    std::map<std::string, Tally> byMethod, byObject;
    for (const std::string& file : files) {
        if (each) std::printf("%s\n", file.c_str());
        if (!measureCase(caseOf(file, cache), each, poses, byMethod, byObject)) return 1;
    }
    for (const auto& [name, tally] : byObject) tally.print(name);
    for (const auto& [name, tally] : byMethod) tally.print(name);
    return 0;
}
