#include <QAction>
#include <QLabel>
#include <QToolButton>

#include "tests/ui/shell/ShellFixture.h"
#include "ui/view/SceneView.h"

namespace vestige {
namespace {

class SmallWindow : public test::ShellWindow {
  public:
    void resize(int width, int height) {
        driver->window().resize(width, height);
        for (int round = 0; round < 4; ++round) QApplication::processEvents();
    }
    /// That it can be seen and reached in whole: no parent cuts any of it off.
    void expectWhole(const QWidget& widget) {
        const QRect place(widget.mapToGlobal(QPoint()), widget.size());
        for (const QWidget* around = widget.parentWidget(); around; around = around->parentWidget()) {
            const QRect room(around->mapToGlobal(QPoint()), around->size());
            EXPECT_TRUE(room.contains(place))
                << widget.objectName().toStdString() << ' ' << widget.accessibleName().toStdString() << " in "
                << around->objectName().toStdString() << " at " << driver->window().width();
            if (around->isWindow()) break;
        }
    }
    void expectPalette() {
        auto& palette = widget<QWidget>("tool-palette");
        const auto buttons = palette.findChildren<QToolButton*>();
        EXPECT_GE(buttons.size(), 15);
        for (const QToolButton* button : buttons) {
            expectWhole(*button);
            for (const QToolButton* other : buttons)
                EXPECT_TRUE(other == button || !button->geometry().intersects(other->geometry()));
        }
        EXPECT_GE(driver->window().view().widget()->width(), 250);
    }
};

TEST_F(SmallWindow, ToolsAndPanelsAreWholeInEverySize) {
    startLoaded();
    for (const auto& [width, height] : {std::pair(960, 600), std::pair(1024, 700), std::pair(1280, 800),
                                        std::pair(1400, 875), std::pair(1920, 1080)}) {
        resize(width, height);
        ASSERT_EQ(driver->window().width(), width);
        ASSERT_EQ(driver->window().height(), height);
        expectPalette();
        for (const char* name : {"header", "step-bar", "right", "layers"}) expectWhole(widget<QWidget>(name));
    }
    EXPECT_EQ(widget<QWidget>("tool-palette").height(), widget<QToolButton>("kinds").height() + 8)
        << "one row where there is room";
}

TEST_F(SmallWindow, BesideTheHelpTheLayersGiveWay) {
    startLoaded();
    resize(1024, 700);
    ASSERT_TRUE(widget<QWidget>("layers").isVisible());
    driver->trigger("help.guide");
    resize(1024, 700);
    EXPECT_FALSE(widget<QWidget>("layers").isVisible());
    expectPalette();
    for (const char* name : {"header", "step-bar", "right", "side-dock"}) expectWhole(widget<QWidget>(name));
    widget<QWidget>("side-dock").hide();
    resize(1024, 700);
    EXPECT_TRUE(widget<QWidget>("layers").isVisible());
    driver->trigger("help.guide");
    resize(1400, 875);
    EXPECT_TRUE(widget<QWidget>("layers").isVisible()) << "room for all";
}

TEST_F(SmallWindow, BarsAndHintsStayWithinTheView) {
    startLoaded();
    resize(1024, 700);
    for (const char* id : {"view.section", "view.color-range", "compare.swipe", "tool.distance"}) {
        driver->trigger(id);
        resize(1024, 700);
        for (const char* name : {"section-bar", "color-bar", "hint"})
            if (widget<QWidget>(name).isVisible()) expectWhole(widget<QWidget>(name));
    }
}

}  // namespace
}  // namespace vestige
