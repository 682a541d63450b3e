#include "ui/actions/ShortcutSheet.h"

#include <QAction>
#include <QBuffer>
#include <QFileInfo>
#include <QPdfWriter>
#include <QTextDocument>
#include <utility>
#include <vector>

#include "core/base/AtomicFile.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

struct Row {
    QString text;
    QString keys;
};
struct Part {
    QString title;
    std::vector<Row> rows;
};

QString plain(QString text) {
    return text.remove('&').remove(QChar(0x2026));
}

std::vector<Part> partsOf(const ActionCatalog& actions) {
    std::vector<Part> parts;
    for (const ActionSpec& spec : actionTable()) {
        const QAction& action = actions[spec.id];
        if (action.shortcut().isEmpty()) continue;
        const QString menu = plain(actions.menuText(spec));
        if (parts.empty() || parts.back().title != menu) parts.push_back({menu, {}});
        parts.back().rows.push_back(
            {plain(actions.text(spec)), action.shortcut().toString(QKeySequence::NativeText)});
    }
    parts.push_back({QObject::tr("Mouse"),
                     {{QObject::tr("Turn about the point under the cursor"), QObject::tr("left drag")},
                      {QObject::tr("Move"), QObject::tr("right or middle drag")},
                      {QObject::tr("Zoom to the cursor"), QObject::tr("wheel")}}});
    return parts;
}

QString htmlOf(const Part& part) {
    QString html = "<h3>" + part.title.toHtmlEscaped() + "</h3><table width=\"100%\" cellspacing=\"0\">";
    for (const Row& row : part.rows)
        html += "<tr><td>" + row.text.toHtmlEscaped() + "</td><td align=\"right\"><b>" +
                row.keys.toHtmlEscaped() + "</b></td></tr>";
    return html + "</table>";
}

QByteArray pdfOf(const QString& html) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    writer.setPageSize(QPageSize(QPageSize::A4));
    writer.setPageMargins({14, 14, 14, 14}, QPageLayout::Millimeter);
    writer.setTitle(QObject::tr("Vestige shortcuts"));
    QTextDocument document;
    document.setDefaultFont(QFont("Inter", 8));
    document.setHtml(html);
    document.print(&writer);
    return bytes;
}

}  // namespace

QString shortcutSheetHtml(const ActionCatalog& actions) {
    // Two columns of about the same length.
    const std::vector<Part> parts = partsOf(actions);
    std::size_t all = 0;
    for (const Part& part : parts) all += part.rows.size() + 2;
    QString left, right;
    std::size_t placed = 0;
    for (const Part& part : parts) {
        (2 * placed < all ? left : right) += htmlOf(part);
        placed += part.rows.size() + 2;
    }
    const QString title = QObject::tr("Vestige shortcuts");
    return "<html><head><meta charset=\"utf-8\"><title>" + title +
           "</title><style>body { font-family: Inter, sans-serif; } h3 { margin: 14px 0 4px 0; } td { "
           "padding: "
           "1px 0; }</style></head><body><h2>" +
           title + "</h2><table width=\"100%\"><tr><td width=\"47%\" valign=\"top\">" + left +
           "</td><td width=\"6%\"></td><td width=\"47%\" valign=\"top\">" + right +
           "</td></tr></table></body></html>";
}

QString shortcutSheetText(const ActionCatalog& actions) {
    QString text = QObject::tr("Vestige shortcuts") + "\n";
    for (const Part& part : partsOf(actions)) {
        text += "\n" + part.title + "\n";
        for (const Row& row : part.rows) text += "  " + row.keys.leftJustified(22) + row.text + "\n";
    }
    return text;
}

Status writeShortcutSheet(const ActionCatalog& actions, const QString& file) {
    const QString suffix = QFileInfo(file).suffix().toLower();
    QByteArray bytes;
    if (suffix == "pdf")
        bytes = pdfOf(shortcutSheetHtml(actions));
    else if (suffix == "html" || suffix == "htm")
        bytes = shortcutSheetHtml(actions).toUtf8();
    else if (suffix == "txt")
        bytes = shortcutSheetText(actions).toUtf8();
    else
        return fail(ErrorCode::usage, "this is no name of a sheet", file.toStdString(),
                    "expected a name that ends with .pdf, .html or .txt");
    return writeTextFile(toPath(file), {bytes.constData(), static_cast<std::size_t>(bytes.size())});
}

}  // namespace vestige
