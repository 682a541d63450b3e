#pragma once

#include <QTimer>
#include <QWidget>
#include <functional>

class QLabel;
class QToolButton;

namespace vestige {

class Notices;

/// One sentence above the view, perhaps with a button; warnings stay until closed, others go by themselves.
class NoticeBar : public QWidget {
    Q_OBJECT

  public:
    explicit NoticeBar(Notices& notices, QWidget* parent = nullptr);
    QString text() const;

  private:
    using Action = std::function<void()>;
    void show(const QString& sentence, bool warning, const QString& label = {}, const Action& action = {});

    QLabel* text_;
    QToolButton* button_;
    Action action_;
    QTimer hide_;
};

}  // namespace vestige
