#pragma once

#include <QMenu>

namespace vestige {

class RecentFiles;

/// "Open recent", in the File menu.
class RecentMenu : public QMenu {
    Q_OBJECT

  public:
    explicit RecentMenu(RecentFiles& recent, QWidget* parent = nullptr);

  signals:
    void chosen(const QString& path);

  private:
    void fill();
    RecentFiles& recent_;
};

}  // namespace vestige
