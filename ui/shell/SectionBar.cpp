#include "ui/shell/SectionBar.h"

#include <QAction>
#include <QCheckBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QSignalBlocker>
#include <QToolButton>
#include <numbers>

#include "ui/actions/ActionCatalog.h"
#include "ui/actions/ActionText.h"
#include "ui/document/Presentation.h"

namespace vestige {
namespace {
constexpr double kFarthest_m = 1e8;
constexpr double kDegrees = 180 / std::numbers::pi;
}  // namespace

SectionBar::SectionBar(ActionCatalog& actions, Presentation& presentation, QWidget* parent)
    : ViewBar(actions, "view.section", tr("Section"), "section-bar", parent), presentation_(presentation) {
    const char* axes[] = {"x", "y", "z"};
    grid().addWidget(barLabel(tr("Middle")), 0, 0);
    grid().addWidget(barLabel(tr("Size")), 1, 0);
    for (int axis = 0; axis < 3; ++axis) {
        const QString letter = axes[axis];
        middle_[axis] =
            numberField(tr("Middle of the section, %1").arg(letter), "m",
                        tr("%1 of the box's middle, metres").arg(letter), -kFarthest_m, kFarthest_m, 3, 0.1);
        size_[axis] =
            numberField(tr("Size of the section, %1").arg(letter), "m",
                        tr("Length of the box along its own %1 axis, metres: 0.001 or more; a slab is "
                           "thin along one of them")
                            .arg(letter),
                        0.001, kFarthest_m, 3, 0.1);
        middle_[axis]->setObjectName("section-middle-" + letter);
        size_[axis]->setObjectName("section-size-" + letter);
        grid().addWidget(middle_[axis], 0, axis + 1);
        grid().addWidget(size_[axis], 1, axis + 1);
    }
    turn_ =
        numberField(tr("Turn of the section"), QString::fromUtf8("°"),
                    tr("How the box is turned about its upright axis, from x towards y: -180 to 180 degrees"),
                    -180, 180, 2, 1);
    turn_->setObjectName("section-turn");
    grid().addWidget(barLabel(tr("Turned")), 2, 0);
    grid().addWidget(turn_, 2, 1);
    auto* slabs = new QHBoxLayout;
    slabs->setSpacing(2);
    for (const char* id : {"view.slab-x", "view.slab-y", "view.slab-z", "view.slab-view", "view.slab-back",
                           "view.slab-on", "view.section-reset"})
        slabs->addWidget(barButton(actions[id]));
    slabs->addStretch(1);
    grid().addLayout(slabs, 3, 1, 1, 3);
    QAction& inverts = actions["view.section-invert"];
    auto* invert = new QCheckBox(withoutMnemonic(inverts.text()));
    invert->setObjectName("section-inverted");
    invert->setToolTip(inverts.statusTip());
    connect(invert, &QCheckBox::clicked, &inverts, &QAction::trigger);
    connect(&presentation_, &Presentation::sectionChanged, invert, [this, invert] {
        invert->setChecked(presentation_.section() && presentation_.section()->inverted);
    });
    grid().addWidget(invert, 2, 2, 1, 2);
    for (QDoubleSpinBox* field : {middle_[0], middle_[1], middle_[2], size_[0], size_[1], size_[2], turn_})
        connect(field, qOverload<double>(&QDoubleSpinBox::valueChanged), this, [this] { take(); });
    connect(&presentation_, &Presentation::sectionChanged, this, [this] { follow(); });
    follow();
}

void SectionBar::follow() {
    if (!presentation_.section()) return;
    const SectionBox& box = *presentation_.section();
    const auto show = [](QDoubleSpinBox* field, double value) {
        const QSignalBlocker quiet(field);
        field->setValue(value);
    };
    for (int axis = 0; axis < 3; ++axis) {
        show(middle_[axis], box.centre[axis]);
        show(size_[axis], 2 * box.halfSize[axis]);
    }
    show(turn_, box.heading_rad * kDegrees);
}

/// What was typed; the others keep the digits that their fields do not show.
void SectionBar::take() {
    if (!presentation_.section()) return;
    SectionBox box = *presentation_.section();
    const auto differs = [](const QDoubleSpinBox* field, double value) {
        return std::abs(field->value() - value) > 0.51 * std::pow(10, -field->decimals());
    };
    for (int axis = 0; axis < 3; ++axis) {
        if (differs(middle_[axis], box.centre[axis])) box.centre[axis] = middle_[axis]->value();
        if (differs(size_[axis], 2 * box.halfSize[axis])) box.halfSize[axis] = 0.5 * size_[axis]->value();
    }
    if (differs(turn_, box.heading_rad * kDegrees)) box.heading_rad = turn_->value() / kDegrees;
    presentation_.setSection(box);
}

}  // namespace vestige
