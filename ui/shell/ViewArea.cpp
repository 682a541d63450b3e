#include "ui/shell/ViewArea.h"

#include <QEvent>
#include <QLabel>
#include <algorithm>

#include "ui/shell/ToolPalette.h"

namespace vestige {

ViewArea::ViewArea(QWidget* parent) : QWidget(parent), hint_(new QLabel(this)) {
    setMinimumSize(250, 200);
    hint_->setObjectName("hint");
    hint_->setAttribute(Qt::WA_TransparentForMouseEvents);
    hint_->hide();
}

void ViewArea::setView(QWidget* view) {
    view_ = view;
    view->setParent(this);
    view->setFocusPolicy(Qt::StrongFocus);
    arrange();
}

void ViewArea::setTools(ToolPalette* tools) {
    tools_ = tools;
    tools->setParent(this);
    arrange();
}

void ViewArea::addBar(QWidget* bar) {
    bars_.push_back(bar);
    const bool shown = !bar->isHidden();
    bar->setParent(this);
    bar->setVisible(shown);
    bar->installEventFilter(this);
    arrange();
}

bool ViewArea::eventFilter(QObject* watched, QEvent* event) {
    const auto type = event->type();
    const bool isBar = watched == chooser_ || std::find(bars_.begin(), bars_.end(), watched) != bars_.end();
    if (isBar && (type == QEvent::Show || type == QEvent::Hide || type == QEvent::LayoutRequest)) arrange();
    return QWidget::eventFilter(watched, event);
}

void ViewArea::setWelcome(QWidget* welcome) {
    welcome_ = welcome;
    welcome->setParent(this);
    arrange();
}

void ViewArea::showWelcome(bool show) {
    welcome_->setVisible(show);
    tools_->setVisible(!show);
    arrange();
}

void ViewArea::setHint(const QString& hint) {
    hint_->setText(hint);
    hint_->setVisible(!hint.isEmpty());
    arrange();
}

void ViewArea::setChooser(QWidget* chooser) {
    chooser_ = chooser;
    chooser->setParent(this);
    chooser->installEventFilter(this);
    chooser->hide();
}

void ViewArea::showChooser(bool show) {
    chooser_->setVisible(show);
    arrange();
}

std::vector<QRectF> ViewArea::covered() const {
    std::vector<QRectF> places;
    std::vector<const QWidget*> over{tools_, hint_, chooser_};
    over.insert(over.end(), bars_.begin(), bars_.end());
    for (const QWidget* widget : over)
        if (widget && !widget->isHidden()) places.emplace_back(widget->geometry());
    return places;
}

void ViewArea::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrange();
}

void ViewArea::arrange() {
    if (view_) {
        view_->setGeometry(rect());
        view_->lower();
    }
    if (tools_) {
        tools_->setGeometry(QRect(QPoint(10, 10), tools_->sizeWithin(std::max(60, width() - 20))));
        tools_->raise();
    }
    int below = tools_ ? tools_->geometry().bottom() + 8 : 10;
    for (QWidget* bar : bars_) {
        if (bar->isHidden()) continue;
        bar->adjustSize();
        bar->move(10, below);
        bar->raise();
        below = bar->geometry().bottom() + 8;
    }
    int beside = 10;
    if (chooser_ && !chooser_->isHidden()) {
        chooser_->adjustSize();
        chooser_->move(beside, below);
        chooser_->raise();
        beside = chooser_->geometry().right() + 9;
    }
    // One line each of what to do and of what came of it, broken only where the view is too narrow.
    hint_->setWordWrap(false);
    const int room = std::max(120, width() - beside - 10);
    if (hint_->sizeHint().width() > room) hint_->setWordWrap(true);
    const int wide = std::min(room, hint_->sizeHint().width());
    hint_->resize(hint_->wordWrap() ? QSize(room, hint_->heightForWidth(room))
                                    : QSize(wide, hint_->sizeHint().height()));
    hint_->move(beside, below);
    hint_->raise();
    if (welcome_) {
        welcome_->setGeometry(rect());
        welcome_->raise();
    }
    emit arranged();
}

}  // namespace vestige
