#pragma once

#include <QObject>
#include <QString>

#include "core/scene/Measurement.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// Picked points and tape values in and out as tables.
class ExchangeReactions : public QObject {
    Q_OBJECT

  public:
    explicit ExchangeReactions(const Workbench& bench, QObject* parent = nullptr);

    void importPickList(const QString& file);
    void importTapeList(const QString& file);
    void exportPickList(const QString& file);

  private:
    /// In one step of the history.
    void enter(std::vector<Measurement> changed, const QString& description);
    /// True where the file is corresponding points, which become the selected layer's first pose.
    bool takeCorrespondences(const QString& file);

    Workbench bench_;
};

}  // namespace vestige
