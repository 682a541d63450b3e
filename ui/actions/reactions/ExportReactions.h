#pragma once

#include <QObject>
#include <filesystem>

#include "ui/actions/Workbench.h"

namespace vestige {

/// Report (the pipeline's reconstruct into a folder) and measurements as CSV.
class ExportReactions : public QObject {
    Q_OBJECT

  public:
    explicit ExportReactions(const Workbench& bench, QObject* parent = nullptr);
    void exportReport(const std::filesystem::path& folder);
    void exportCsv(const std::filesystem::path& file);

  private:
    Workbench bench_;
};

}  // namespace vestige
