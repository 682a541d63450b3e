#include "tests/ui/print/PdfFile.h"

#include <QFile>
#include <QRegularExpression>

namespace vestige::test {
namespace {

QByteArray inflated(const QByteArray& stream) {
    // qUncompress wants the expected size in front and grows the buffer when it is too small.
    const QByteArray size("\0\1\0\0", 4);
    return qUncompress(size + stream);
}

}  // namespace

std::vector<PdfObject> readPdf(const std::filesystem::path& path) {
    QFile file(QString::fromStdString(path.string()));
    std::vector<PdfObject> objects;
    if (!file.open(QIODevice::ReadOnly)) return objects;
    const QByteArray bytes = file.readAll();
    int at = 0;
    while ((at = bytes.indexOf(" 0 obj\n", at)) >= 0) {
        const int begin = at + 7;
        const int end = bytes.indexOf("endobj", begin);
        const int stream = bytes.indexOf("stream\n", begin);
        PdfObject object;
        if (stream >= 0 && stream < end) {
            const int streamEnd = bytes.indexOf("\nendstream", stream);
            object.dictionary = bytes.mid(begin, stream - begin);
            object.stream = bytes.mid(stream + 7, streamEnd - stream - 7);
            if (object.dictionary.contains("/FlateDecode")) object.stream = inflated(object.stream);
            at = streamEnd;
        } else {
            object.dictionary = bytes.mid(begin, end - begin);
            at = end;
        }
        if (at < 0) break;
        objects.push_back(std::move(object));
    }
    return objects;
}

}  // namespace vestige::test
