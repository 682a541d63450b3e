#pragma once

#include <QObject>
#include <filesystem>
#include <functional>

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
    void save();
    void saveAs();
    /// Asks about unsaved changes; false when the user wants to stay, or they could not be saved.
    bool mayLeave();
    /// Before the window closes: the user's changes are saved or not wanted.
    void leave();

  private:
    /// Where the case is to be saved; asks for it. Empty: nowhere.
    std::filesystem::path place(bool another);
    bool saveTo(const std::filesystem::path& file, bool wait);
    bool saved(const std::filesystem::path& file, const Status& status);
    std::function<void()> pump();

    Workbench bench_;
};

}  // namespace vestige
