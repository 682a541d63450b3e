#pragma once

#include <QObject>
#include <filesystem>

#include "core/base/Result.h"
#include "ui/actions/Workbench.h"

namespace vestige {

/// New, open, add, save, reopen, verify.
class FileReactions : public QObject {
    Q_OBJECT

  public:
    explicit FileReactions(const Workbench& bench, QObject* parent = nullptr);

    /// Cases are opened (the first of them), other files added.
    void open(const QStringList& paths);
    /// False when it was not saved: refused by the user or failed.
    bool save();
    bool saveAs();
    /// Asks about unsaved changes; false when the user wants to stay.
    bool mayLeave();

  private:
    bool saveTo(const std::filesystem::path& file);
    void told(const Status& status);

    Workbench bench_;
};

}  // namespace vestige
