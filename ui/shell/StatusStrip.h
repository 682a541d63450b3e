#pragma once

#include <QElapsedTimer>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/jobs/TimeLeft.h"

class QLabel;
class QProgressBar;
class QPushButton;

namespace vestige {

class Document;
class JobRunner;

/// At the foot of the window: the running job with progress, time left and Cancel; the coordinates under the
/// cursor.
class StatusStrip : public QWidget {
    Q_OBJECT

  public:
    StatusStrip(Document& document, JobRunner& jobs, QWidget* parent = nullptr);
    /// Whether edits are kept; a trouble stands out.
    void showAutosave(const QString& text, bool trouble);
    void showCoordinates(const QString& coordinates, const QString& layer);

  private:
    void begin(const QString& title);
    void showTimeLeft();
    void showIdle();
    QString previewText() const;

    Document& document_;
    JobRunner& jobs_;
    QLabel* job_;
    QProgressBar* bar_;
    QLabel* percent_;
    QLabel* left_;
    QPushButton* cancel_;
    QLabel* message_;  ///< what the running job has to say: a neighbourhood's radius, a file that is skipped
    QLabel* autosave_;
    QLabel* coordinates_;
    QLabel* layer_;
    QString title_;
    double share_ = 0;
    std::optional<TimeLeft> estimate_;  ///< of the running job
    QElapsedTimer clock_;
    QTimer tick_;
};

}  // namespace vestige
