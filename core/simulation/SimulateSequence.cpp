#include "core/simulation/SimulateSequence.h"

#include <algorithm>

#include "core/base/OutputFolder.h"
#include "core/simulation/PavilionScene.h"

namespace vestige {
namespace {

/// Clouds that an earlier, longer walk or one in the other frame may have left: they would be taken for this
/// one's.
std::vector<std::string> earlierClouds(const std::vector<std::string>& made) {
    constexpr std::size_t kLongestWalk = 200;
    std::vector<std::string> names;
    for (const AslFrame frame : {AslFrame::scanner, AslFrame::world})
        for (std::size_t i = 0; i < kLongestWalk; ++i)
            if (std::string name = aslCloudName(frame, i);
                std::find(made.begin(), made.end(), name) == made.end())
                names.push_back(std::move(name));
    return names;
}

}  // namespace

Result<SimulatedSequence> simulatePavilion(const SequenceOptions& options,
                                           const std::filesystem::path& folder, const JobControl& control) {
    return guarded(folder.string(), [&]() -> Result<SimulatedSequence> {
        constexpr double kBetweenScans_s = 60;  // carrying the scanner on, and the scan
        const SurfaceModel surfaces = pavilionScene(options.seed);
        const RayTracer tracer(surfaces);
        const std::vector<Pose> walk = pavilionWalk(options.scans, options.seed);
        SimulatedSequence made;
        OutputFolder output(folder);
        if (const Status opened = output.open(); !opened) return fail(opened.error());
        std::vector<StampedPose> poses;
        for (std::size_t i = 0; i < walk.size(); ++i) {
            TiltingOptions scan;
            scan.worldFromScanner = walk[i];
            scan.beams = options.beams;
            scan.seed = options.seed;
            scan.number = i;
            const auto points = scanTilting(tracer, surfaces, hokuyoUtm30Lx(), scan, control);
            if (!points) return fail(points.error());
            poses.push_back({kBetweenScans_s * static_cast<double>(i), walk[i]});
            const std::string name = aslCloudName(options.frame, i);
            const Pose frameFromScanner = options.frame == AslFrame::world ? walk[i] : Pose::Identity();
            if (const Status written =
                    writeAslCloud(output.path(name), *points, poses.back().time_s, frameFromScanner);
                !written)
                return fail(written.error());
            made.files.push_back(name);
            made.points.push_back(points->size());
            control.progress(static_cast<double>(i + 1) / static_cast<double>(walk.size()), "scans");
        }
        constexpr const char* kPoses = "pose_scanner_leica.csv";
        if (const Status written = writeAslPoses(output.path(kPoses), poses); !written)
            return fail(written.error());
        made.files.emplace_back(kPoses);
        if (const Status placed = output.commit(earlierClouds(made.files)); !placed)
            return fail(placed.error());
        return made;
    });
}

}  // namespace vestige
