#include "ui/view/Marks.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <cmath>

#include "tests/ui/view/Samples.h"
#include "ui/view/ScaleBar.h"
#include "ui/view/ViewTheme.h"

using namespace vestige;

namespace {

struct Canvas {
    QImage picture{800, 600, QImage::Format_RGB32};
    ViewCamera camera = fitCamera({{-5, -5, 0}, {5, 5, 0}}, NamedView::top, 800, 600);

    Canvas() { picture.fill(Qt::black); }
    std::vector<QRectF> paint(const std::vector<PaintedMark>& marks, std::vector<QRectF> taken = {}) {
        QPainter painter(&picture);
        return paintMarks(painter, ViewTheme(), picture.rect(), camera, marks, std::move(taken));
    }
};

PaintedMark mark(const Eigen::Vector3d& a, const Eigen::Vector3d& b, bool highlighted = false) {
    return {{a, b, "4.786 m \u00b1 0.014", highlighted}, false};
}

}  // namespace

TEST(Marks, LineRunsFromEndToEnd) {
    Canvas canvas;
    canvas.paint({mark({-3, -1, 0}, {3, 1, 0})});
    for (const double share : {0.2, 0.5, 0.8}) {
        const auto at = canvas.camera.project(Eigen::Vector3d(-3 + 6 * share, -1 + 2 * share, 0))->pixel;
        EXPECT_GT(qGray(canvas.picture.pixel(static_cast<int>(at.x()), static_cast<int>(at.y()))), 150);
    }
}

TEST(Marks, LabelsKeepClearOfEachOtherAndOfTheLegend) {
    Canvas canvas;
    std::vector<PaintedMark> marks;
    for (int i = 0; i < 14; ++i)
        marks.push_back(mark({-4 + 0.5 * i, -1, 0}, {-3.8 + 0.5 * i, 1.5 * std::sin(i), 0}, i == 3));
    const QRectF legend(560, 14, 226, 120);
    const std::vector<QRectF> labels = canvas.paint(marks, {legend});
    EXPECT_GE(labels.size(), 6U);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_TRUE(QRectF(canvas.picture.rect()).contains(labels[i]));
        EXPECT_FALSE(labels[i].intersects(legend));
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(labels[i].intersects(labels[j]));
    }
}

TEST(Marks, LabelsOfShortLinesStayNearThem) {
    Canvas canvas;
    std::vector<PaintedMark> marks;
    for (int i = 0; i < 12; ++i)
        marks.push_back(mark({0.05 * i, 0.03 * (i % 4), 0}, {0.05 * i + 0.1, 0.03 * (i % 4), 0}));
    const auto centre = canvas.camera.project(Eigen::Vector3d(0.3, 0.05, 0))->pixel;
    const std::vector<QRectF> labels = canvas.paint(marks);
    EXPECT_GE(labels.size(), 1U);
    EXPECT_LT(labels.size(), 12U) << "all of them would pile up round a few pixels";
    for (const QRectF& label : labels)
        EXPECT_LT(std::abs(label.center().y() - centre.y()), 90) << "it points at nothing that can be seen";
}

TEST(Marks, HighlightedIsToldHoweverFullThePictureIs) {
    Canvas canvas;
    const std::vector<QRectF> full{QRectF(0, 0, 800, 600)};
    EXPECT_TRUE(canvas.paint({mark({-1, 0, 0}, {1, 0, 0})}, full).empty());
    EXPECT_EQ(canvas.paint({mark({-1, 0, 0}, {1, 0, 0}, true)}, full).size(), 1U);
}

TEST(Marks, EndsBehindTheCameraAreCutOff) {
    Canvas canvas;
    canvas.camera = ViewCamera{{0, -10, 1}, {0, 0, 1}, {0, 0, 1}, false, 0.6, 1, 800, 600};
    EXPECT_TRUE(canvas.paint({mark({0, -20, 1}, {1, -30, 1})}).empty());
    EXPECT_EQ(canvas.paint({mark({0.5, -20, 1.5}, {0.5, 5, 1.5})}).size(), 1U);
}

TEST(ScaleBar, IsARoundLengthThatFits) {
    EXPECT_DOUBLE_EQ(scaleBarLength(7.3), 5);
    EXPECT_DOUBLE_EQ(scaleBarLength(2.0), 2);
    EXPECT_NEAR(scaleBarLength(0.0199), 0.01, 1e-12);
    EXPECT_DOUBLE_EQ(scaleBarLength(499), 200);
}
