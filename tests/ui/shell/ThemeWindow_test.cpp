#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QLabel>
#include <QRegularExpression>
#include <QSettings>
#include <QTest>
#include <QToolButton>
#include <cmath>

#include "app/offscreen/OffscreenApplication.h"
#include "tests/support/TestPaths.h"
#include "tests/ui/shell/SampleScans.h"
#include "tests/ui/shell/WindowDriver.h"
#include "ui/jobs/InlineJobRunner.h"
#include "ui/panels/PanelColors.h"
#include "ui/panels/VerdictBadge.h"
#include "ui/shell/StyleColors.h"
#include "ui/shell/Theme.h"
#include "ui/view/SceneView.h"
#include "ui/view/ViewTheme.h"

namespace vestige {
namespace {

/// WCAG 2.1.
double luminance(const QColor& color) {
    const auto linear = [](double part) {
        return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(color.redF()) + 0.7152 * linear(color.greenF()) + 0.0722 * linear(color.blueF());
}
double contrast(const QColor& a, const QColor& b) {
    const double one = luminance(a) + 0.05;
    const double other = luminance(b) + 0.05;
    return std::max(one, other) / std::min(one, other);
}

class ThemeWindow : public testing::Test {
  public:
    ThemeWindow() {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope,
                           QString::fromStdString((folder / "settings").string()));
        scans = test::writeSampleScans(folder.path());
    }
    ~ThemeWindow() override {
        driver.reset();
        applyTheme(Theme::dark);
    }

    void start() {
        driver.reset();
        driver = std::make_unique<test::WindowDriver>(std::make_unique<MainWindow>(
            offscreenSurface(), offscreenRenderer(), nullptr, nullptr, std::make_unique<InlineJobRunner>()));
    }
    QImage picture() {
        for (int i = 0; i < 5; ++i) QApplication::processEvents();
        driver->window().view().completePicture();
        return driver->window().grab().toImage().convertToFormat(QImage::Format_RGB32);
    }

    test::TemporaryFolder folder;
    test::SampleScans scans;
    std::unique_ptr<test::WindowDriver> driver;
};

double meanBrightness(const QImage& image) {
    double sum = 0;
    for (int y = 0; y < image.height(); y += 4)
        for (int x = 0; x < image.width(); x += 4) sum += qGray(image.pixel(x, y));
    return sum / ((image.width() + 3) / 4 * ((image.height() + 3) / 4));
}

TEST_F(ThemeWindow, TheKeySwitchesWindowAndViewAndTheNextWindowRemembers) {
    start();
    ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    EXPECT_LT(meanBrightness(picture()), 70);
    QTest::keyClick(driver->window().view().widget(), Qt::Key_L, Qt::AltModifier);
    EXPECT_EQ(driver->window().view().description().theme, Theme::light);
    const QImage light = picture();
    EXPECT_GT(meanBrightness(light), 190);
    start();
    EXPECT_TRUE(driver->window().findChild<QAction*>("view.light")->isChecked());
    EXPECT_GT(meanBrightness(picture()), 190);
    ASSERT_TRUE(driver->trigger("view.light"));
    EXPECT_LT(meanBrightness(picture()), 70);
}

TEST_F(ThemeWindow, AThemeSetByTheProgramIsNotStored) {
    start();
    driver->window().setTheme(Theme::light);
    EXPECT_TRUE(driver->window().findChild<QAction*>("view.light")->isChecked());
    EXPECT_EQ(storedTheme(), Theme::dark);
}

TEST_F(ThemeWindow, IconsAndWordsFollow) {
    start();
    ASSERT_TRUE(driver->window().openFiles({scans.target, scans.source}));
    ASSERT_TRUE(driver->trigger("register.run"));
    ASSERT_TRUE(driver->trigger("view.panel-fit"));
    const auto ink = [&] {
        const QImage icon =
            driver->window().findChild<QAction*>("register.watch")->icon().pixmap(24).toImage();
        QColor strongest(Qt::transparent);
        for (int y = 0; y < icon.height(); ++y)
            for (int x = 0; x < icon.width(); ++x)
                if (icon.pixelColor(x, y).alpha() > strongest.alpha()) strongest = icon.pixelColor(x, y);
        return strongest;
    };
    EXPECT_GT(contrast(ink(), QApplication::palette().color(QPalette::Window)), 4.5);
    const auto* word = driver->window().findChild<QLabel*>("verdict-word");
    const QString before = word->styleSheet();
    ASSERT_TRUE(driver->trigger("view.light"));
    static_cast<void>(picture());
    EXPECT_GT(contrast(ink(), QApplication::palette().color(QPalette::Window)), 4.5);
    EXPECT_NE(word->styleSheet(), before);
}

TEST_F(ThemeWindow, WordsCanBeReadInBothThemes) {
    for (const Theme theme : {Theme::dark, Theme::light}) {
        applyTheme(theme);
        const QPalette palette = QApplication::palette();
        const QColor window = palette.color(QPalette::Window);
        for (const char* words : {"text", "quiet", "heading", "status", "link", "bright", "menu"})
            for (const char* ground : {"window", "well", "bar", "raised"})
                EXPECT_GT(contrast(styleColor(words, theme), styleColor(ground, theme)), 4.5)
                    << name(theme) << ": " << words << " on " << ground;
        EXPECT_GT(contrast(Qt::white, styleColor("accent", theme)), 4.5) << "the main button";
        for (const QColor& color :
             {quietColor(palette), goodColor(palette), aboveColor(palette), belowColor(palette)})
            EXPECT_GT(contrast(color, window), 4.5) << name(theme) << color.name().toStdString();
        for (const Verdict verdict :
             {Verdict::accepted, Verdict::doubtful, Verdict::failed, Verdict::ambiguous})
            EXPECT_GT(contrast(verdictColor(verdict, palette), window), 4.5) << name(theme);
        const ViewTheme view = viewTheme(theme);
        for (const QColor& color : {view.text, view.quietText})
            EXPECT_GT(contrast(color, view.panel), 4.5) << name(theme) << " over the view";
    }
}

TEST(StyleColors, EveryNameOfTheSheetHasAColour) {
    applyTheme(Theme::dark);
    QFile file(":/style/window.qss");
    ASSERT_TRUE(file.open(QIODevice::ReadOnly));
    const QString sheet = QString::fromUtf8(file.readAll()).section("*/", 1);
    for (const Theme theme : {Theme::dark, Theme::light})
        EXPECT_FALSE(withColors(sheet, theme).contains('@'));
    EXPECT_EQ(withColors("a: @window; b: @nothing;", Theme::dark), "a: #151a20; b: @nothing;");
}

}  // namespace
}  // namespace vestige
