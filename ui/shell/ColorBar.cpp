#include "ui/shell/ColorBar.h"

#include <QAction>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QTimer>

#include "ui/actions/ActionCatalog.h"
#include "ui/document/Presentation.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

constexpr ColorMap kMaps[] = {ColorMap::even, ColorMap::viridis, ColorMap::cividis, ColorMap::plasma,
                              ColorMap::grey};

enum class Quantity { none, height, intensity, distance };

Quantity shownBy(const Presentation& shown) {
    if (shown.overlay() == Overlay::residual) return Quantity::distance;
    if (shown.overlay() != Overlay::none) return Quantity::none;
    return shown.colorMode() == ColorMode::height      ? Quantity::height
           : shown.colorMode() == ColorMode::intensity ? Quantity::intensity
                                                       : Quantity::none;
}

ColorRange& rangeOf(Coloring& coloring, Quantity quantity) {
    return quantity == Quantity::intensity ? coloring.intensity : coloring.height_m;
}

}  // namespace

ColorBar::ColorBar(ActionCatalog& actions, Presentation& presentation, const SceneView& view, QWidget* parent)
    : ViewBar(actions, "view.color-range", tr("Colours"), "color-bar", parent),
      presentation_(presentation),
      view_(view),
      map_(new QComboBox),
      what_(barLabel({})),
      none_(barLabel(tr("These colours have no range: choose height, intensity or distance."))) {
    const QString names[] = {tr("Even"), tr("Viridis"), tr("Cividis"), tr("Plasma"), tr("Grey")};
    for (const QString& name : names) map_->addItem(name);
    map_->setObjectName("color-map");
    map_->setAccessibleName(tr("Colours of heights"));
    map_->setToolTip(
        tr("Colours of heights; equal steps of them look equal. Cividis looks alike to nearly every eye"));
    low_ = numberField(tr("Lowest"), {}, tr("Where the colours begin"), -1e9, 1e9, 3, 0.1);
    high_ = numberField(tr("Highest"), {}, tr("Where the colours end"), -1e9, 1e9, 3, 0.1);
    cut_ =
        numberField(tr("Left out"), "%",
                    tr("Share of the values left out at either end: 0 to 40 %. Goes back to a range from the "
                       "values"),
                    0, 40, 1, 0.5);
    low_->setObjectName("color-low");
    high_->setObjectName("color-high");
    cut_->setObjectName("color-cut");
    none_->setWordWrap(true);
    grid().addWidget(what_, 0, 0);
    grid().addWidget(low_, 0, 1);
    grid().addWidget(barLabel(tr("to")), 0, 2);
    grid().addWidget(high_, 0, 3);
    grid().addWidget(barLabel(tr("Left out")), 1, 0);
    grid().addWidget(cut_, 1, 1);
    grid().addWidget(map_, 1, 3);
    grid().addWidget(none_, 2, 0, 1, 4);
    connect(map_, qOverload<int>(&QComboBox::activated), this, [this](int place) {
        Coloring coloring = presentation_.coloring();
        coloring.map = kMaps[place];
        presentation_.setColoring(coloring);
    });
    connect(low_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { takeEnds(); });
    connect(high_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { takeEnds(); });
    connect(cut_, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { takeCut(); });
    connect(&presentation_, &Presentation::changed, this, [this] { follow(); });
    connect(&view_, &SceneView::colorsChanged, this, [this] { follow(); });
    connect(&actions["view.color-range"], &QAction::toggled, this, [this] { follow(); });
    follow();
}

void ColorBar::follow() {
    const Quantity quantity = shownBy(presentation_);
    const bool has = quantity != Quantity::none;
    for (QWidget* widget : {static_cast<QWidget*>(low_), static_cast<QWidget*>(high_)})
        widget->setEnabled(has);
    low_->setEnabled(has && quantity != Quantity::distance);
    cut_->setEnabled(has);
    map_->setEnabled(quantity == Quantity::height);
    none_->setVisible(!has);
    what_->setText(quantity == Quantity::intensity  ? tr("Intensity")
                   : quantity == Quantity::distance ? tr("Distance, m")
                                                    : tr("Height, m"));
    Coloring coloring = presentation_.coloring();
    const auto show = [](QDoubleSpinBox* field, double value) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
    };
    map_->setCurrentIndex(static_cast<int>(coloring.map));
    show(cut_, 100 * rangeOf(coloring, quantity).cut);
    const auto ends = view_.colorEnds();
    if (!ends) return;
    show(low_, ends->first);
    show(high_, ends->second);
}

void ColorBar::takeEnds() {
    const Quantity quantity = shownBy(presentation_);
    if (quantity == Quantity::none) return;
    Coloring coloring = presentation_.coloring();
    if (quantity == Quantity::distance) {
        coloring.reach_m = std::max(1e-4, std::abs(high_->value()));
    } else {
        if (high_->value() <= low_->value()) return follow();
        rangeOf(coloring, quantity).low = low_->value();
        rangeOf(coloring, quantity).high = high_->value();
    }
    presentation_.setColoring(coloring);
}

void ColorBar::takeCut() {
    const Quantity quantity = shownBy(presentation_);
    Coloring coloring = presentation_.coloring();
    if (quantity == Quantity::distance)
        coloring.reach_m.reset();
    else if (quantity != Quantity::none)
        rangeOf(coloring, quantity) = {0.01 * cut_->value(), {}, {}};
    presentation_.setColoring(coloring);
}

}  // namespace vestige
