#pragma once

#include <QWidget>

class QLabel;
class QTreeWidget;

namespace vestige {

class ActionCatalog;
class RecentFiles;

/// The start page, while no case is open: begin one, open one, or look at the sample; what was open last; and
/// the way from files to a report.
class WelcomePage : public QWidget {
    Q_OBJECT

  public:
    WelcomePage(const ActionCatalog& actions, RecentFiles& recent, QWidget* parent = nullptr);

  signals:
    void chosen(const QString& path);

  private:
    QWidget* makeWay() const;
    void fillRecent();
    void choose(const QString& path, bool exists);

    RecentFiles& recent_;
    QTreeWidget* list_;
    QLabel* none_;
};

}  // namespace vestige
