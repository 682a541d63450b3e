#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/document/Notices.h"

class QLabel;
class QToolButton;

namespace vestige {

/// One sentence above the view; warnings stay until closed, others go by themselves.
class NoticeBar : public QWidget {
    Q_OBJECT

  public:
    explicit NoticeBar(Notices& notices, QWidget* parent = nullptr);
    QString text() const;

  private:
    void show(const QString& sentence, bool warning, const QString& path);
    void offer(const QString& sentence, const std::vector<Notices::Offer>& offers);

    QLabel* text_;
    QToolButton* open_;
    QWidget* offers_;  ///< a button for each
    QString path_;
    QTimer hide_;
};

}  // namespace vestige
