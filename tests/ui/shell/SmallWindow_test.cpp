#include <QAction>
#include <QLabel>
#include <QToolButton>
#include <fstream>

#include "tests/ui/shell/ShellFixture.h"
#include "ui/document/Document.h"
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

TEST_F(SmallWindow, NamedViewsAreNotUnderTheTools) {
    startLoaded();
    resize(1280, 800);
    for (const char* id : {"view.top", "view.perspective", "view.front", "view.bottom", "view.fit"}) {
        driver->trigger(id);
        const ViewCamera camera = driver->window().view().camera();
        const int tools = widget<QWidget>("tool-palette").geometry().bottom();
        double highest = 1e9;
        for (const Layer& layer : driver->scene().layers)
            for (std::uint32_t i = 0; i < layer.data->points->size(); ++i)
                if (const auto seen = camera.project(layer.data->points->point(i)))
                    highest = std::min(highest, seen->pixel.y());
        EXPECT_GT(highest, tools - 12) << id << ": but for strays";
        EXPECT_LT(highest, tools + 260) << id;
    }
}

TEST_F(SmallWindow, ASingleScanIsShownInItsColoursUntilAnotherStandsBesideIt) {
    std::ofstream out(folder / "colours.ply");
    out << "ply\nformat ascii 1.0\nelement vertex 400\nproperty double x\nproperty double y\nproperty double "
           "z\nproperty uchar red\nproperty uchar green\nproperty uchar blue\nend_header\n";
    for (int i = 0; i < 400; ++i) out << 0.1 * (i % 20) << ' ' << 0.1 * (i / 20) << " 0 220 40 30\n";
    out.close();
    start();
    ASSERT_TRUE(driver->window().openFiles({folder / "colours.ply"}));
    const auto mode = [&] { return driver->window().view().description().colorMode; };
    EXPECT_EQ(mode(), ColorMode::rgb);
    ASSERT_TRUE(driver->window().openFiles({scans.target}));
    EXPECT_EQ(mode(), ColorMode::source) << "two scans are told apart";
    driver->trigger("view.color-rgb");
    ASSERT_TRUE(driver->window().openFiles({scans.source}));
    EXPECT_EQ(mode(), ColorMode::rgb) << "what was chosen stays";
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
