#include "ui/actions/FilePeekPanel.h"

#include <QFileDialog>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/base/Translation.h"
#include "core/base/Units.h"
#include "core/report/Wording.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

constexpr int kWidth = 300;
constexpr std::size_t kMostSensors = 4;
constexpr std::size_t kMostWarnings = 5;

QString sizeText(qint64 bytes) {
    const double kilobytes = static_cast<double>(bytes) / 1000;
    if (kilobytes < 1) return QObject::tr("%1 bytes").arg(bytes);
    if (kilobytes < 1000) return toQt(fixedText(kilobytes, 1)) + " kB";
    if (kilobytes < 1e6) return toQt(fixedText(kilobytes / 1e3, 1)) + " MB";
    return toQt(fixedText(kilobytes / 1e6, 2)) + " GB";
}

QString unitText(const FileInfo& info) {
    if (!info.metresPerUnit) return {};
    const auto unit = lengthUnitOf(*info.metresPerUnit);
    return unit ? said(nameOf(*unit)) : toQt(exactText(*info.metresPerUnit)) + " m";
}

QString extentText(const FileInfo& info) {
    if (info.bounds.empty()) return {};
    const Eigen::Vector3d extent = info.bounds.extent();
    const auto unit = info.metresPerUnit ? lengthUnitOf(*info.metresPerUnit) : std::nullopt;
    QString text =
        toQt(fixedText(extent.x(), 2) + " × " + fixedText(extent.y(), 2) + " × " + fixedText(extent.z(), 2));
    return unit ? text + " " + toQt(symbol(*unit)) : text;
}

/// Of a WKT its name, which is the first text in quotes.
QString referenceText(const std::string& crs) {
    const std::size_t open = crs.find("[\"");
    if (open == std::string::npos) return toQt(crs);
    const std::size_t close = crs.find('"', open + 2);
    return toQt(
        std::string_view(crs).substr(open + 2, close == std::string::npos ? close : close - open - 2));
}

QString sensorText(const FileInfo& info) {
    QStringList sensors;
    for (const ScanInfo& scan : info.scans) {
        QStringList parts;
        for (const std::string* part : {&scan.sensorVendor, &scan.sensorModel, &scan.sensorSerial})
            if (!part->empty()) parts << toQt(*part);
        const QString sensor = parts.join(' ');
        if (!sensor.isEmpty() && !sensors.contains(sensor)) sensors << sensor;
    }
    if (sensors.size() > static_cast<int>(kMostSensors)) {
        sensors.erase(sensors.begin() + kMostSensors, sensors.end());
        sensors << QString::fromUtf8("…");
    }
    return sensors.join(", ");
}

QString memoryText(const LoadEstimate& estimate) {
    if (estimate.points == 0) return {};
    QString text = said(estimate.sentence());
    if (!estimate.fits() && !estimate.partsHelp)
        text = QObject::tr("%1. %2").arg(
            text,
            QObject::tr("It does not fit, and this format is read whole; save it as LAS or LAZ elsewhere."));
    else if (!estimate.fits())
        text = QObject::tr("%1. %2").arg(
            text, QObject::tr("It does not fit; one point in %1 would.").arg(estimate.keepEveryToFit));
    return text;
}

QString attributesText(const std::vector<std::string>& attributes) {
    QStringList names;
    for (const std::string& attribute : attributes) names << said(attribute);
    return names.join(QObject::tr(", ", "between the items of a list"));
}

QString asTable(const std::vector<std::pair<QString, QString>>& rows) {
    QString html = "<table cellspacing='0' cellpadding='2'>";
    for (const auto& [label, value] : rows)
        html += "<tr><td valign='top'>" + label.toHtmlEscaped() + "&nbsp;</td><td>" + value.toHtmlEscaped() +
                "</td></tr>";
    return html + "</table>";
}

}  // namespace

std::vector<std::pair<QString, QString>> peekRows(const FileInfo& info, const LoadEstimate& estimate,
                                                  qint64 fileBytes) {
    std::vector<std::pair<QString, QString>> rows;
    const auto row = [&](const QString& label, const QString& value) {
        if (!value.isEmpty()) rows.emplace_back(label, value);
    };
    row(QObject::tr("Format"), toQt(info.format + (info.version.empty() ? "" : " " + say(info.version))));
    row(QObject::tr("Size"), sizeText(fileBytes));
    row(QObject::tr("Points"),
        info.points > 0 ? toQt(grouped(info.points)) : QObject::tr("told once it is loaded"));
    row(QObject::tr("Triangles"), info.triangles > 0 ? toQt(grouped(info.triangles)) : QString());
    row(QObject::tr("Extent"), extentText(info));
    if (!info.bounds.empty())
        row(QObject::tr("Least corner"),
            coordinateText(info.bounds.min.x(), info.bounds.min.y(), info.bounds.min.z()));
    row(QObject::tr("Reference"), referenceText(info.crs));
    row(QObject::tr("Unit"), unitText(info));
    row(QObject::tr("Sensor"), sensorText(info));
    row(QObject::tr("Written by"), toQt(info.generatingSoftware));
    row(QObject::tr("Scans"), info.scans.empty() ? QString() : QString::number(info.scans.size()));
    row(QObject::tr("Images"), info.images.empty() ? QString() : QString::number(info.images.size()));
    row(QObject::tr("Attributes"), attributesText(info.attributes));
    row(QObject::tr("Memory"), memoryText(estimate));
    row(QObject::tr("Damage"), said(info.damage));
    for (std::size_t i = 0; i < std::min(info.warnings.size(), kMostWarnings); ++i)
        row(QObject::tr("Warning"), said(info.warnings[i]));
    return rows;
}

FilePeekPanel::FilePeekPanel(QWidget* parent)
    : QWidget(parent), peek_(new FilePeek(this)), title_(new QLabel), text_(new QLabel) {
    setFixedWidth(kWidth);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(8, 0, 0, 0);
    for (QLabel* label : {title_, text_}) {
        label->setWordWrap(true);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
        column->addWidget(label);
    }
    title_->setTextFormat(Qt::PlainText);
    title_->setObjectName("peekTitle");
    text_->setObjectName("peekText");
    column->addStretch();
    connect(peek_, &FilePeek::told, this, &FilePeekPanel::tell);
    showFile({});
}

void FilePeekPanel::showFile(const QString& path) {
    text_->clear();
    title_->setText(path.isEmpty() ? QObject::tr("Select a file to see what is in it.")
                                   : QObject::tr("Looking into it..."));
    peek_->look(path);
}

void FilePeekPanel::tell(const QString& path, const Result<FileInfo>& info) {
    title_->setText(QFileInfo(path).fileName());
    text_->setTextFormat(info ? Qt::RichText : Qt::PlainText);
    if (info)
        text_->setText(asTable(peekRows(*info, estimateLoad(*info, {}), QFileInfo(path).size())));
    else
        text_->setText(QString::fromStdString(say(info.error())));
}

FilePeekPanel* addPeekPanel(QFileDialog& dialog) {
    dialog.setOption(QFileDialog::DontUseNativeDialog);
    auto* panel = new FilePeekPanel(&dialog);
    if (auto* grid = qobject_cast<QGridLayout*>(dialog.layout()))
        grid->addWidget(panel, 0, grid->columnCount(), grid->rowCount(), 1);
    QObject::connect(&dialog, &QFileDialog::currentChanged, panel, [panel](const QString& path) {
        panel->showFile(QFileInfo(path).isDir() ? QString() : path);
    });
    return panel;
}

}  // namespace vestige
