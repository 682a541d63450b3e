#include "ui/print/PdfIdentity.h"

#include <QCryptographicHash>

namespace vestige {

QByteArray withContentIdentity(QByteArray pdf) {
    const int trailer = pdf.lastIndexOf("trailer");
    const int id = trailer < 0 ? -1 : pdf.indexOf("/ID", trailer);
    const int end = id < 0 ? -1 : pdf.indexOf(']', id);
    if (end < 0) return pdf;
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(pdf.constData(), id);
    const QByteArray digits = hash.result().toHex();
    // Both identifiers are strings of hexadecimal digits in angle brackets; they keep their length.
    bool inside = false;
    int digit = 0;
    for (int i = id; i < end; ++i) {
        if (pdf[i] == '<') {
            inside = true;
            digit = 0;
        } else if (pdf[i] == '>') {
            inside = false;
        } else if (inside) {
            pdf[i] = digits[digit++ % digits.size()];
        }
    }
    return pdf;
}

}  // namespace vestige
