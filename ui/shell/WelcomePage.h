#pragma once

#include <QWidget>

class QVBoxLayout;

namespace vestige {

class ActionCatalog;
class RecentFiles;

/// What the view's place shows while the case is empty: what to do first, and what was open last.
class WelcomePage : public QWidget {
    Q_OBJECT

  public:
    WelcomePage(const ActionCatalog& actions, const RecentFiles& recent, QWidget* parent = nullptr);

  signals:
    void chosen(const QString& path);

  private:
    void fillRecent();

    const RecentFiles& recent_;
    QVBoxLayout* list_;
};

}  // namespace vestige
