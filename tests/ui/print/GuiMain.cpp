#include <QGuiApplication>

#include <gtest/gtest.h>

/// Printing asks for fonts, and fonts ask for an application; it needs no display.
int main(int argc, char** argv) {
    qputenv("QT_QPA_PLATFORM", "offscreen");
    testing::InitGoogleTest(&argc, argv);
    const QGuiApplication application(argc, argv);
    return RUN_ALL_TESTS();
}
