#pragma once

#include <QObject>

#include "ui/actions/Workbench.h"

namespace vestige {

/// Opens the sample case; where there is none yet it is simulated first, as a job.
class SampleReactions : public QObject {
    Q_OBJECT

  public:
    explicit SampleReactions(const Workbench& bench, QObject* parent = nullptr);

  signals:
    /// There is a sample case, and it is asked for.
    void ready(const QString& caseFile);

  private:
    void simulate();

    Workbench bench_;
};

}  // namespace vestige
