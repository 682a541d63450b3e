#include "core/io/WriteJob.h"

namespace vestige {

Status writeAtomically(const std::filesystem::path& file, const std::function<void(AtomicFile&)>& body) {
    Status done = guarded(file.string(), [&]() -> Status {
        AtomicFile target(file);
        if (Status opened = target.open(); !opened) return opened;
        body(target);
        return target.commit();
    });
    if (!done && done.error().code == ErrorCode::input) done.error().code = ErrorCode::output;
    return done;
}

void stepWriting(const JobControl& control, std::size_t done, std::size_t total) {
    if ((done & 0xffff) != 0) return;
    if (control.cancelled()) throw ErrorException{cancelledError()};
    if (total > 0) control.progress(static_cast<double>(done) / static_cast<double>(total), "writing");
}

void writeRecords(AtomicFile& file, std::span<const PointColumn> columns, std::size_t points,
                  const JobControl& control) {
    constexpr std::size_t kBuffered = 4096;
    std::size_t stride = 0;
    for (const PointColumn& column : columns) stride += sizeOf(column.type);
    std::vector<std::byte> buffer;
    for (std::size_t i = 0; i < points; ++i) {
        stepWriting(control, i, points);
        std::size_t at = buffer.size();
        buffer.resize(at + stride);
        for (const PointColumn& column : columns) {
            writeScalar(column.type, column.value(i), buffer.data() + at);
            at += sizeOf(column.type);
        }
        if (buffer.size() >= kBuffered * stride) {
            file.write(buffer);
            buffer.clear();
        }
    }
    file.write(buffer);
}

}  // namespace vestige
