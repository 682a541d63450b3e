#include "ui/actions/ActionText.h"

#include <QRegularExpression>

namespace vestige {

QString withoutMnemonic(const QString& text) {
    // Where a script has no letters to underline, the mnemonic stands in brackets behind the text.
    static const QRegularExpression bracketed(QStringLiteral("\\(&.\\)"));
    return QString(text).remove(bracketed).remove('&').remove(QChar(0x2026));
}

}  // namespace vestige
