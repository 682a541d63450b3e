#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QToolButton;

namespace vestige {

class Notices;

/// One sentence above the view; warnings stay until closed, others go by themselves.
class NoticeBar : public QWidget {
    Q_OBJECT

  public:
    explicit NoticeBar(Notices& notices, QWidget* parent = nullptr);
    QString text() const;

  private:
    void show(const QString& sentence, bool warning, const QString& path);

    QLabel* text_;
    QToolButton* open_;
    QString path_;
    QTimer hide_;
};

}  // namespace vestige
