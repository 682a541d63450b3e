#include "ui/shell/StepBar.h"

#include <QHBoxLayout>
#include <QLabel>

#include "ui/document/Document.h"
#include "ui/document/Outputs.h"
#include "ui/shell/StepButton.h"

namespace vestige {

StepBar::StepBar(Document& document, Outputs& outputs, QWidget* parent)
    : QWidget(parent), document_(document), outputs_(outputs) {
    setObjectName("step-bar");
    setAttribute(Qt::WA_StyledBackground);
    setAccessibleName(tr("Steps"));
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(8, 4, 8, 4);
    row->setSpacing(2);
    for (int i = 0; i < kWaySteps; ++i) {
        const auto step = static_cast<WayStep>(i);
        auto* button = new StepButton(step);
        connect(button, &QAbstractButton::clicked, this, [this, step] { emit chosen(step); });
        buttons_[static_cast<std::size_t>(i)] = button;
        if (i > 0) {
            auto* arrow = new QLabel(QString::fromUtf8("›"));
            arrow->setProperty("role", "muted");
            row->addWidget(arrow);
        }
        row->addWidget(button);
    }
    row->addStretch(1);
    connect(&document_, &Document::changed, this, [this] { follow(); });
    connect(&outputs_, &Outputs::changed, this, [this] { follow(); });
    follow();
}

void StepBar::setShown(WayStep step) {
    for (int i = 0; i < kWaySteps; ++i)
        buttons_[static_cast<std::size_t>(i)]->setShown(i == static_cast<int>(step));
}

WayStep StepBar::next() const {
    auto steps = stepsOf(document_.state(), document_.measured(), outputs_.reported());
    steps[static_cast<std::size_t>(WayStep::import)].state = StepState::done;
    return nextStep(steps);
}

void StepBar::follow() {
    const auto steps = stepsOf(document_.state(), document_.measured(), outputs_.reported());
    for (std::size_t i = 0; i < steps.size(); ++i) buttons_[i]->setFacts(steps[i]);
}

}  // namespace vestige
