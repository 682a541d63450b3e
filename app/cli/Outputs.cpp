#include "app/cli/Outputs.h"

#include "core/base/AtomicFile.h"
#include "core/base/Numbers.h"
#include "core/io/FormatRegistry.h"
#include "core/io/ReadJob.h"

namespace vestige::cli {

std::string coordinates(const Eigen::Vector3d& values) {
    return exactText(values.x()) + " " + exactText(values.y()) + " " + exactText(values.z());
}

Status noInputIsWritten(std::initializer_list<std::string> outputs,
                        std::initializer_list<std::string> inputs) {
    for (const std::string& output : outputs)
        for (const std::string& input : inputs)
            if (samePlace(output, input))
                return fail(ErrorCode::usage, "the output would replace an input", output,
                            "inputs are only ever read; expected: another name");
    return {};
}

void tellWhatIsLost(const std::string& out, const FileInfo& wanted, const Wanted& asked,
                    const Session& session) {
    const Result<FileInfo> written = peekFile(out);
    if (!written) return;
    const auto warn = [&](const std::string& text) { session.log("warning: " + out + " " + text); };
    const double unit = wanted.metresPerUnit.value_or(1);
    if (unit != 1 && !written->metresPerUnit)
        warn("does not say its unit: " + exactText(unit) + " m, as that of the input");
    if (asked.triangles > 0 && written->triangles == 0)
        warn("holds points alone: " + counted(asked.triangles, "triangle") +
             (asked.triangles == 1 ? " is" : " are") + " left out");
    if (asked.scale && wanted.scale && (!written->scale || *written->scale != *wanted.scale))
        warn(written->scale ? "has steps of " + coordinates(*written->scale) + ": those of --scale do not fit"
                            : "has no steps: --scale means nothing in its format");
    if (asked.offset && wanted.offset && (!written->offset || *written->offset != *wanted.offset))
        warn(written->offset ? "counts from " + coordinates(*written->offset) + ": --offset does not fit"
                             : "has no offset: --offset means nothing in its format");
}

}  // namespace vestige::cli
