#include "core/simulation/SimulateSequence.h"

#include "core/simulation/PavilionScene.h"

namespace vestige {

Result<SimulatedSequence> simulatePavilion(const SequenceOptions& options,
                                           const std::filesystem::path& folder, const JobControl& control) {
    return guarded(folder.string(), [&]() -> Result<SimulatedSequence> {
        constexpr double kBetweenScans_s = 60;  // carrying the scanner on, and the scan
        const SurfaceModel surfaces = pavilionScene(options.seed);
        const RayTracer tracer(surfaces);
        const std::vector<Pose> walk = pavilionWalk(options.scans, options.seed);
        SimulatedSequence made;
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
                    writeAslCloud(folder / name, *points, poses.back().time_s, frameFromScanner);
                !written)
                return fail(written.error());
            made.files.push_back(name);
            made.points.push_back(points->size());
            control.progress(static_cast<double>(i + 1) / static_cast<double>(walk.size()), "scans");
        }
        constexpr const char* kPoses = "pose_scanner_leica.csv";
        if (const Status written = writeAslPoses(folder / kPoses, poses); !written)
            return fail(written.error());
        made.files.emplace_back(kPoses);
        return made;
    });
}

}  // namespace vestige
