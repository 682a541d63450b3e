#include "ui/forms/ParameterForm.h"

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QTest>
#include <QToolButton>

namespace vestige {
namespace {

const ParameterTable& sample() {
    static const ParameterTable table{{.key = "voxel_m",
                                       .flag = "voxel",
                                       .label = "Smallest voxel",
                                       .unit = "m",
                                       .type = ParameterType::real,
                                       .defaultValue = std::monostate(),
                                       .minimum = 0.01,
                                       .maximum = 10,
                                       .choices = {},
                                       .help = "Cell size."},
                                      {.key = "method",
                                       .flag = "method",
                                       .label = "Method",
                                       .unit = "",
                                       .type = ParameterType::choice,
                                       .defaultValue = std::string("ndt"),
                                       .minimum = {},
                                       .maximum = {},
                                       .choices = {"ndt", "icp"},
                                       .help = "How."},
                                      {.key = "thin",
                                       .flag = "thin",
                                       .label = "Thin first",
                                       .unit = "",
                                       .type = ParameterType::boolean,
                                       .defaultValue = false,
                                       .minimum = {},
                                       .maximum = {},
                                       .choices = {},
                                       .help = "Whether."}};
    return table;
}

void type(QLineEdit& field, const QString& text) {
    field.selectAll();
    QTest::keyClicks(&field, text);
    QTest::keyClick(&field, Qt::Key_Return);
}

TEST(ParameterForm, EveryParameterGetsAField) {
    ParameterForm form(sample());
    EXPECT_NE(form.findChild<QLineEdit*>("voxel_m"), nullptr);
    EXPECT_EQ(form.findChild<QComboBox*>("method")->count(), 2);
    EXPECT_NE(form.findChild<QCheckBox*>("thin"), nullptr);
    EXPECT_EQ(form.findChild<QLineEdit*>("voxel_m")->placeholderText(), "automatic");
}

TEST(ParameterForm, TypedValuesAreTold) {
    ParameterForm form(sample());
    std::vector<std::pair<std::string, ParameterValue>> told;
    QObject::connect(&form, &ParameterForm::edited, [&](const std::string& key, const ParameterValue& value) {
        told.emplace_back(key, value);
    });
    auto& voxel = *form.findChild<QLineEdit*>("voxel_m");
    type(voxel, "0.25");
    form.findChild<QCheckBox*>("thin")->click();
    voxel.selectAll();
    QTest::keyClick(&voxel, Qt::Key_Delete);
    QTest::keyClick(&voxel, Qt::Key_Return);
    ASSERT_EQ(told.size(), 3u);
    EXPECT_EQ(told[0], std::make_pair(std::string("voxel_m"), ParameterValue(0.25)));
    EXPECT_EQ(told[1], std::make_pair(std::string("thin"), ParameterValue(true)));
    EXPECT_TRUE(std::holds_alternative<std::monostate>(told[2].second));
}

TEST(ParameterForm, WhatIsNotAllowedIsRefusedWithItsRange) {
    ParameterForm form(sample());
    QString refused;
    bool edited = false;
    QObject::connect(&form, &ParameterForm::refused, [&](const QString& sentence) { refused = sentence; });
    QObject::connect(&form, &ParameterForm::edited, [&] { edited = true; });
    auto& voxel = *form.findChild<QLineEdit*>("voxel_m");
    type(voxel, "99");
    EXPECT_FALSE(edited);
    EXPECT_TRUE(refused.contains("10")) << refused.toStdString();
    EXPECT_TRUE(voxel.property("problem").toBool());
    type(voxel, "1");
    EXPECT_TRUE(edited);
    EXPECT_FALSE(voxel.property("problem").toBool());
}

TEST(ParameterForm, WhatIsNotFirstIsFoldedAwayAndSaysWhetherItWasChanged) {
    ParameterForm form(sample(), std::vector<std::string>{"method"});
    form.show();
    auto& more = *form.findChild<QToolButton*>("more-parameters");
    auto& voxel = *form.findChild<QLineEdit*>("voxel_m");
    EXPECT_TRUE(form.findChild<QComboBox*>("method")->isVisible());
    EXPECT_FALSE(voxel.isVisible());
    EXPECT_EQ(more.text(), "2 more, all at their defaults");
    QTest::mouseClick(&more, Qt::LeftButton);
    EXPECT_TRUE(voxel.isVisible());
    type(voxel, "0.25");
    EXPECT_EQ(more.text(), "2 more, 1 changed");
    QTest::mouseClick(&more, Qt::LeftButton);
    EXPECT_FALSE(voxel.isVisible());
}

TEST(ParameterForm, TheFieldThatHasTheKeysIsExplained) {
    ParameterForm form(sample());
    form.show();
    QApplication::setActiveWindow(&form);
    const auto explained = [&] {
        QString text;
        for (const QLabel* label : form.findChildren<QLabel*>())
            if (label->isVisible() && label->wordWrap()) text += label->text();
        return text;
    };
    form.findChild<QLineEdit*>("voxel_m")->setFocus();
    EXPECT_EQ(explained(), "Cell size. Range: 0.01 to 10 m; default: automatic.");
    form.findChild<QCheckBox*>("thin")->setFocus();
    EXPECT_EQ(explained(), "Whether. Default: off.");
}

}  // namespace
}  // namespace vestige
