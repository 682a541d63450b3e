#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

#include "ui/document/Notices.h"

class QHBoxLayout;
class QLabel;
class QToolButton;

namespace vestige {

/// One sentence above the view, perhaps with buttons; warnings stay until closed, others go by themselves.
class NoticeBar : public QWidget {
    Q_OBJECT

  public:
    explicit NoticeBar(Notices& notices, QWidget* parent = nullptr);
    QString text() const;

  private:
    void show(const QString& sentence, bool warning, const std::vector<Notices::Offer>& offers = {});

    QLabel* text_;
    QHBoxLayout* offers_;
    std::vector<QToolButton*> buttons_;
    bool offering_ = false;  ///< the buttons are of an offer
    QTimer hide_;
};

}  // namespace vestige
