#pragma once

#include <QAbstractTableModel>
#include <QIcon>
#include <map>

#include "core/scene/MeasuredScene.h"

namespace vestige {

class Document;
class Selection;

/// The measured objects as a table, for the method that is selected: each with the icon of its kind and its
/// main figure. Object and tape (for other units than metres the reference) are edited here.
class MeasurementsModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { object, tape, measured, uncertainty, relativeError, columns };

    MeasurementsModel(Document& document, Selection& selection, QObject* parent = nullptr);
    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;
    Qt::ItemFlags flags(const QModelIndex& index) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;

    /// Row of an object; -1 when it has none.
    int rowOf(const std::string& object) const;
    std::string objectAt(int row) const;

  signals:
    /// What was entered cannot be taken.
    void refused(const QString& sentence);

  private:
    void follow();
    const MeasuredLength* measuredAt(int row) const;
    const QuantityStatistic* mainFigureAt(int row) const;
    QString figureAt(int row) const;
    QString referenceAt(int row, bool toEdit) const;
    bool setReference(const Measurement& measurement, const QString& text);
    QIcon iconAt(int row) const;
    QVariant textAt(int row, Column column) const;
    QString tipAt(int row) const;

    Document& document_;
    Selection& selection_;
    mutable std::map<MeasurementKind, QIcon> icons_;  ///< by palette; made when asked for
    int rows_ = 0;                                    ///< as last told to the views
};

}  // namespace vestige
