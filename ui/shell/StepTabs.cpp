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
    int wanted = last_[static_cast<std::size_t>(step)];
    for (int tab = 0; tab < count() && wanted < 0; ++tab)
        if (stepOf(tab) == step) wanted = tab;
    if (wanted >= 0) setCurrentIndex(wanted);
}

void StepTabs::follow() {
    const int current = currentIndex();
    // A tab bar chooses another tab by itself while tabs of it are hidden and shown.
    if (current < 0 || following_) return;
    following_ = true;
    const WayStep step = stepOf(current);
    last_[static_cast<std::size_t>(step)] = current;
    int shown = 0;
    for (int tab = 0; tab < count(); ++tab) {
        const bool ofStep = stepOf(tab) == step;
        shown += ofStep;
        if (isTabVisible(tab) != ofStep) setTabVisible(tab, ofStep);
    }
    tabBar()->setVisible(shown > 1);
    if (currentIndex() != current) setCurrentIndex(current);
    following_ = false;
    emit stepShown(step);
}

}  // namespace vestige
