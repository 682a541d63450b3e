#include "ui/panels/MeasurementsModel.h"

#include <QApplication>
#include <QColor>
#include <QFont>
#include <QPalette>

#include "core/base/Numbers.h"
#include "core/measurement/MeasuredText.h"
#include "core/measurement/kinds/KindSpec.h"
#include "core/report/QuantityText.h"
#include "core/scene/Edits.h"
#include "core/scene/KindEdits.h"
#include "ui/actions/Icons.h"
#include "ui/actions/KindTools.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/PanelColors.h"

namespace vestige {
MeasurementsModel::MeasurementsModel(Document& document, Selection& selection, QObject* parent)
    : QAbstractTableModel(parent), document_(document), selection_(selection) {
    connect(&document_, &Document::changed, this, [this] { follow(); });
    connect(&selection_, &Selection::changed, this, [this] { follow(); });
    connect(qApp, &QGuiApplication::paletteChanged, this, [this] {
        icons_.clear();
        follow();
    });
    follow();
}

void MeasurementsModel::follow() {
    const int now = static_cast<int>(document_.state().measurements.size());
    if (now == rows_) {
        // A reset would take away the editor that is just handing over its text.
        if (now > 0) emit dataChanged(index(0, 0), index(now - 1, columns - 1));
        return;
    }
    beginResetModel();
    rows_ = now;
    endResetModel();
}

int MeasurementsModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : rows_;
}

int MeasurementsModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : columns;
}

std::string MeasurementsModel::objectAt(int row) const {
    const auto& all = document_.state().measurements;
    return row >= 0 && row < static_cast<int>(all.size()) ? all[static_cast<std::size_t>(row)].object
                                                          : std::string();
}

int MeasurementsModel::rowOf(const std::string& object) const {
    for (int row = 0; row < rowCount(); ++row)
        if (objectAt(row) == object) return row;
    return -1;
}

const MeasuredLength* MeasurementsModel::measuredAt(int row) const {
    const std::string object = objectAt(row);
    for (const MeasuredLength& length : document_.measured().lengths)
        if (length.object == object && length.method == selection_.method()) return &length;
    return nullptr;
}

const QuantityStatistic* MeasurementsModel::mainFigureAt(int row) const {
    const std::string object = objectAt(row);
    for (const MeasuredKind& kind : document_.measured().kinds)
        if (kind.object == object && kind.method == selection_.method() && !kind.quantities.empty())
            return &kind.quantities.front();
    return nullptr;
}

/// The main figure where it is no length: with its unit.
QString MeasurementsModel::figureAt(int row) const {
    const QuantityStatistic* main = mainFigureAt(row);
    if (!main) return lengthText(std::nullopt);
    const QString unit = toQt(readableSymbol(main->unit));
    return toQt(quantityValueText(*main)) + (main->unit == QuantityUnit::degree ? "" : " ") + unit;
}

/// What is typed into the tape's column: metres, or the kind's own reference in its unit.
QString MeasurementsModel::referenceAt(int row, bool toEdit) const {
    const Measurement& measurement = document_.state().measurements[static_cast<std::size_t>(row)];
    std::optional<double> value = measurement.tape_m;
    if (!kindSpec(measurement.kind).isLength) {
        value.reset();
        for (const auto& [key, number] : measurement.settings)
            if (key.starts_with("reference") && number > 0) value = number;
    }
    if (toEdit) return value ? toQt(exactText(*value)) : QString();
    if (!value) return kindSpec(measurement.kind).isLength ? tr("no tape") : tr("none");
    return lengthText(value);
}

QIcon MeasurementsModel::iconAt(int row) const {
    const MeasurementKind kind = document_.state().measurements[static_cast<std::size_t>(row)].kind;
    QIcon& icon = icons_[kind];
    if (icon.isNull()) icon = iconOn(QApplication::palette(), toQt(kindIcon(kind)));
    return icon;
}

QVariant MeasurementsModel::textAt(int row, Column column) const {
    const Measurement& measurement = document_.state().measurements[static_cast<std::size_t>(row)];
    const MeasuredLength* found = measuredAt(row);
    const LengthStatistic* length = found && found->length ? &*found->length : nullptr;
    switch (column) {
        case object:
            return QString::fromStdString(measurement.object);
        case tape:
            return referenceAt(row, false);
        case measured:
            if (!kindSpec(measurement.kind).isLength) return figureAt(row);
            return length ? toQt(measuredText(length->mean_m, length->expandedUncertainty_m).value)
                          : lengthText(std::nullopt);
        case uncertainty:
            if (const auto* main = mainFigureAt(row); main && !kindSpec(measurement.kind).isLength)
                return toQt(quantityUncertaintyText(*main));
            return uncertaintyText(length ? length->expandedUncertainty_m : std::nullopt);
        case relativeError:
            if (const auto* main = mainFigureAt(row); main && !kindSpec(measurement.kind).isLength)
                return percentText(main->relativeError);
            return percentText(found ? found->re : std::nullopt);
        case columns:
            break;
    }
    return {};
}

QString MeasurementsModel::tipAt(int row) const {
    const MeasuredLength* found = measuredAt(row);
    const Measurement& measurement = document_.state().measurements[static_cast<std::size_t>(row)];
    QStringList lines{QString::fromStdString(objectAt(row)), said(kindSpec(measurement.kind).label)};
    if (measurement.checkTolerance_m)
        lines << tr("A known distance: it may be off by %1 m").arg(lengthText(measurement.checkTolerance_m));
    if (!found) return lines.join("\n");
    if (found->length) {
        QStringList repeats;
        for (const double repeat : found->length->repeats_m)
            repeats << toQt(measuredText(repeat, found->length->expandedUncertainty_m).value);
        lines << tr("Repeats %1 m").arg(repeats.join(", "));
        lines << tr("Repeat SD %1 m").arg(uncertaintyText(found->length->repeatSd_m));
    }
    if (found->tape_m)
        lines << tr("The tape itself is good to %1 m (1 SD)").arg(uncertaintyText(found->tapeUncertainty_m));
    if (found->excluded) lines << tr("Excluded from RMSE: |RE| is beyond 2 SD");
    if (!found->note.empty()) lines << said(found->note);
    return lines.join("\n");
}

QVariant MeasurementsModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid() || objectAt(index.row()).empty()) return {};
    const auto column = static_cast<Column>(index.column());
    const Measurement& measurement = document_.state().measurements[static_cast<std::size_t>(index.row())];
    const MeasuredLength* found = measuredAt(index.row());
    const bool excluded = found && found->excluded;
    if (role == Qt::DisplayRole) return textAt(index.row(), column);
    if (role == Qt::EditRole) {
        if (column == tape) return referenceAt(index.row(), true);
        return textAt(index.row(), column);
    }
    if (role == Qt::ToolTipRole) return tipAt(index.row());
    if (role == Qt::DecorationRole && column == object) return iconAt(index.row());
    if (role == Qt::AccessibleDescriptionRole && column == object)
        return said(kindSpec(measurement.kind).label);
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((column == object ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role == Qt::FontRole && excluded) {
        QFont font;
        font.setStrikeOut(column == relativeError);
        font.setItalic(true);
        return font;
    }
    if (role == Qt::ForegroundRole) {
        const QPalette palette = QApplication::palette();
        if (excluded || (column == tape && !measurement.tape_m)) return quietColor(palette);
        if (column == relativeError && found && found->re)
            return *found->re > 0 ? aboveColor(palette) : belowColor(palette);
        const bool measuredAtAll = (found && found->length) || mainFigureAt(index.row());
        if (column != object && column != tape && !measuredAtAll) return quietColor(palette);
    }
    return {};
}

QVariant MeasurementsModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation != Qt::Horizontal) return {};
    if (role == Qt::TextAlignmentRole)
        return static_cast<int>((section == object ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
    if (role != Qt::DisplayRole) return {};
    const QString titles[] = {tr("Object"), tr("Tape m"), tr("Measured"), tr("U 95 %"), tr("RE %")};
    return titles[section];
}

Qt::ItemFlags MeasurementsModel::flags(const QModelIndex& index) const {
    const auto usual = QAbstractTableModel::flags(index);
    return index.column() == object || index.column() == tape ? usual | Qt::ItemIsEditable : usual;
}

bool MeasurementsModel::setReference(const Measurement& measurement, const QString& text) {
    const std::string object = measurement.object;
    for (const ParameterSpec& spec : *kindSpec(measurement.kind).parameters) {
        if (!spec.key.starts_with("reference")) continue;
        if (text.isEmpty()) return document_.perform(setKindSetting(object, spec.key, std::nullopt));
        const auto value = parseReal(QString(text).replace(',', '.').toStdString());
        if (value && *value > 0 && *value <= *spec.maximum)
            return document_.perform(setKindSetting(object, spec.key, value));
        emit refused(
            tr("\"%1\" is no reference: expected a number above 0, in %2.").arg(text, toQt(spec.unit)));
    }
    return false;
}

bool MeasurementsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole) return false;
    const std::string named = objectAt(index.row());
    const QString text = value.toString().trimmed();
    if (index.column() == object) {
        if (text.isEmpty() || text.toStdString() == named) return false;
        if (document_.state().measurement(text.toStdString())) {
            emit refused(tr("There is already an object called \"%1\".").arg(text));
            return false;
        }
        const bool selected = selection_.object() == named;
        if (!document_.perform(renameMeasurement(named, text.toStdString()))) return false;
        if (selected) selection_.setObject(text.toStdString());
        return true;
    }
    const Measurement& measurement = document_.state().measurements[static_cast<std::size_t>(index.row())];
    if (!kindSpec(measurement.kind).isLength) return setReference(measurement, text);
    if (text.isEmpty()) return document_.perform(setTape(named, std::nullopt));
    const auto metres = parseReal(QString(text).replace(',', '.').toStdString());
    if (!metres || !(*metres > 0) || *metres > 1e6) {
        emit refused(tr("\"%1\" is no tape length: expected metres above 0, such as 4.78.").arg(text));
        return false;
    }
    return document_.perform(setTape(named, metres));
}

}  // namespace vestige
