#include "ui/view/PngFile.h"

#include <QBuffer>
#include <QImage>

#include "core/base/AtomicFile.h"

namespace vestige {

Status writePng(const QImage& picture, const std::filesystem::path& png) {
    AtomicFile file(png);
    if (const Status open = file.open(); !open) return open;
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly) || !picture.save(&buffer, "PNG"))
        return fail(ErrorCode::output, "the picture could not be packed as PNG", png.string());
    file.write(std::string_view(bytes.constData(), static_cast<std::size_t>(bytes.size())));
    return file.commit();
}

}  // namespace vestige
