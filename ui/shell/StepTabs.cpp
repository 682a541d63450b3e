#include "ui/shell/StepTabs.h"

#include <QTabBar>

namespace vestige {
namespace {
const char* const kStep = "way-step";
}

StepTabs::StepTabs(QWidget* parent) : QTabWidget(parent) {
    last_.fill(-1);
    setDocumentMode(true);
    setAccessibleName(tr("Panels of the step"));
    tabBar()->setAccessibleName(accessibleName());
    connect(this, &QTabWidget::currentChanged, this, [this] { follow(); });
}

void StepTabs::addPanel(WayStep step, QWidget* panel, const QString& title) {
    panel->setProperty(kStep, static_cast<int>(step));
    addTab(panel, title);
    follow();
}

WayStep StepTabs::stepOf(int tab) const {
    const QWidget* page = widget(tab);
    const QVariant step = page ? page->property(kStep) : QVariant();
    return step.isValid() ? static_cast<WayStep>(step.toInt()) : WayStep::measure;
}

void StepTabs::showStep(WayStep step) {
    const int known = last_[static_cast<std::size_t>(step)];
    if (known >= 0) return setCurrentIndex(known);
    for (int tab = 0; tab < count(); ++tab)
        if (stepOf(tab) == step) return setCurrentIndex(tab);
}

void StepTabs::follow() {
    const int current = currentIndex();
    if (current < 0) return;
    const WayStep step = stepOf(current);
    last_[static_cast<std::size_t>(step)] = current;
    int shown = 0;
    for (int tab = 0; tab < count(); ++tab) {
        const bool ofStep = stepOf(tab) == step;
        shown += ofStep;
        if (isTabVisible(tab) != ofStep) setTabVisible(tab, ofStep);
    }
    tabBar()->setVisible(shown > 1);
    emit stepShown(step);
}

}  // namespace vestige
