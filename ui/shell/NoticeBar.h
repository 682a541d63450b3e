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
/// What is offered stays under sentences that come later.
class NoticeBar : public QWidget {
    Q_OBJECT

  public:
    explicit NoticeBar(Notices& notices, QWidget* parent = nullptr);
    QString text() const;

  private:
    void tell(const QString& sentence, bool warning, const std::vector<Notices::Offer>& offers = {});
    void offer(const QString& sentence, std::vector<Notices::Offer> offers);
    void taken(const Notices::Offer& offer);
    void show(const QString& sentence, bool warning, const std::vector<Notices::Offer>& offers);

    QLabel* text_;
    QHBoxLayout* offers_;
    std::vector<QToolButton*> buttons_;
    QString offered_;                   ///< what the offers are about
    std::vector<Notices::Offer> open_;  ///< that nobody has taken
    QTimer hide_;
};

}  // namespace vestige
