#include "ui/shell/CompareBar.h"

#include <QAction>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>
#include <QToolButton>
#include <algorithm>
#include <iterator>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Comparison.h"
#include "ui/document/Preview.h"

namespace vestige {
namespace {

template <std::size_t N>
int placeOf(const int (&choices)[N], int value) {
    const auto at = std::lower_bound(std::begin(choices), std::end(choices), value);
    return static_cast<int>(std::min<std::ptrdiff_t>(at - std::begin(choices), N - 1));
}

}  // namespace

CompareBar::CompareBar(const ActionCatalog& actions, Comparison& comparison, const Preview& preview,
                       QWidget* parent)
    : QFrame(parent),
      comparison_(comparison),
      preview_(preview),
      what_(new QWidget),
      words_(new QLabel),
      amount_(new QLabel),
      slider_(new QSlider(Qt::Horizontal)) {
    setObjectName("compare-bar");
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(3, 3, 3, 3);
    row->setSpacing(6);
    auto* pictures = new QHBoxLayout(what_);
    pictures->setContentsMargins(0, 0, 0, 0);
    pictures->setSpacing(2);
    for (const char* id : {"compare.poses", "compare.layers"}) {
        auto* button = new QToolButton;
        button->setDefaultAction(&actions[id]);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        pictures->addWidget(button);
    }
    row->addWidget(what_);
    words_->setObjectName("preview-words");
    words_->setContentsMargins(8, 4, 8, 4);
    row->addWidget(words_);
    amount_->setObjectName("compare-amount");
    row->addWidget(amount_);
    slider_->setObjectName("compare-slider");
    slider_->setFixedWidth(110);
    slider_->setFocusPolicy(Qt::NoFocus);
    slider_->setAccessibleName(tr("Amount"));
    row->addWidget(slider_);
    auto* close = new QToolButton;
    QAction& end = actions["compare.end"];
    close->setText(QString::fromUtf8("×"));
    close->setToolTip(end.toolTip());
    close->setAccessibleName(tr("Back to the plain view"));
    connect(close, &QToolButton::clicked, &end, &QAction::trigger);
    row->addWidget(close);
    connect(slider_, &QSlider::valueChanged, this, [this](int place) {
        if (comparison_.mode() == CompareMode::checkerboard)
            comparison_.setTile(Comparison::kTiles[place]);
        else
            comparison_.setBlink(Comparison::kBlinks_ms[place]);
    });
    connect(&comparison_, &Comparison::switched, this, [this] { follow(); });
    connect(&comparison_, &Comparison::adjusted, this, [this] { follow(); });
    connect(&preview_, &Preview::changed, this, [this] { follow(); });
    follow();
}

void CompareBar::follow() {
    const auto mode = comparison_.mode();
    const bool tiles = mode == CompareMode::checkerboard;
    const bool blinks = mode == CompareMode::blink;
    what_->setVisible(mode.has_value());
    words_->setVisible(preview_.active());
    words_->setText(preview_.words());
    amount_->setVisible(tiles || blinks);
    slider_->setVisible(tiles || blinks);
    const QSignalBlocker quiet(slider_);
    if (tiles) {
        const int size = comparison_.shown().tile_px;
        slider_->setRange(0, static_cast<int>(std::size(Comparison::kTiles)) - 1);
        slider_->setValue(placeOf(Comparison::kTiles, size));
        slider_->setToolTip(tr("Size of the tiles (Left, Right)"));
        amount_->setText(tr("%1 pixels").arg(size));
    } else if (blinks) {
        slider_->setRange(0, static_cast<int>(std::size(Comparison::kBlinks_ms)) - 1);
        slider_->setValue(placeOf(Comparison::kBlinks_ms, comparison_.blink_ms()));
        slider_->setToolTip(tr("Time of each picture (Left, Right); Space holds one"));
        amount_->setText(comparison_.held() ? tr("held")
                                            : tr("%1 s").arg(0.001 * comparison_.blink_ms(), 0, 'f', 1));
    }
    setVisible(mode || preview_.active());
    adjustSize();
}

}  // namespace vestige
