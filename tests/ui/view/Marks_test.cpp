#include "ui/view/Marks.h"

#include <gtest/gtest.h>

#include <QImage>
#include <QPainter>
#include <algorithm>
#include <cmath>
#include <random>

#include "tests/ui/view/Samples.h"
#include "ui/view/LabelPlaces.h"
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

TEST(Marks, LabelsOfShortLinesStandAsideAndHideNothingThatIsMeasured) {
    Canvas canvas;
    std::vector<PaintedMark> marks;
    QRectF measured;
    for (int i = 0; i < 12; ++i) {
        marks.push_back(mark({0.05 * i, 0.03 * (i % 4), 0}, {0.05 * i + 0.1, 0.03 * (i % 4), 0}));
        marks.back().mark.name = "Object " + std::to_string(i);
        for (const Eigen::Vector3d& end : {marks.back().mark.a, marks.back().mark.b}) {
            const auto at = canvas.camera.project(end)->pixel;
            measured |= QRectF(at.x() - 2, at.y() - 2, 4, 4);
        }
    }
    const std::vector<QRectF> labels = canvas.paint(marks);
    ASSERT_EQ(labels.size(), 12U);
    for (std::size_t i = 0; i < labels.size(); ++i) {
        EXPECT_TRUE(QRectF(canvas.picture.rect()).contains(labels[i]));
        EXPECT_FALSE(labels[i].intersects(measured)) << "it covers what is measured";
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(labels[i].intersects(labels[j]));
    }
    EXPECT_EQ(canvas.paint(marks), labels) << "the same scene, the same picture";
}

TEST(LabelPlaces, LeadersOfAColumnDoNotCrossAndEndAtTheirLines) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 18; ++i) {
        const QPointF at(300 + 13 * ((7 * i) % 18), 220 + 9 * ((5 * i) % 18));
        wishes.push_back({QLineF(at, at + QPointF(4, 3)), {120, 25}, {200, 25}});
    }
    const QRectF legend(560, 14, 226, 120);
    const auto places = placeLabels(wishes, {0, 0, 800, 600}, {legend});
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_TRUE(places[i] && places[i]->leader);
        EXPECT_EQ(places[i]->leader->p2(), wishes[i].line.center());
        EXPECT_FALSE(places[i]->box.intersects(legend));
        for (std::size_t j = 0; j < i; ++j) {
            const bool sameColumn = (places[i]->box.left() < 400) == (places[j]->box.left() < 400);
            if (sameColumn) {
                EXPECT_NE(places[i]->leader->intersects(*places[j]->leader, nullptr),
                          QLineF::BoundedIntersection)
                    << i << " and " << j;
            }
            EXPECT_FALSE(places[i]->box.intersects(places[j]->box));
        }
    }
}

TEST(LabelPlaces, ALabelStandsBesideALineThatIsLongerThanIt) {
    const auto places =
        placeLabels({{QLineF(200, 300, 500, 300), {120, 25}, {200, 25}}}, {0, 0, 800, 600}, {});
    ASSERT_TRUE(places[0]);
    EXPECT_FALSE(places[0]->leader);
    EXPECT_NEAR(places[0]->box.center().x(), 350, 1);
    EXPECT_LT(std::abs(places[0]->box.center().y() - 300), 40);
}

TEST(LabelPlaces, InSmallPicturesTheValueAloneStandsNearItsLine) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> x(20, 320);
    std::uniform_real_distribution<double> y(20, 240);
    std::uniform_real_distribution<double> way(-30, 30);
    const QRectF picture(0, 0, 340, 260);
    int brief = 0;
    for (int trial = 0; trial < 60; ++trial) {
        std::vector<LabelWish> wishes;
        for (int i = 0; i < 12; ++i) {
            const QPointF from(x(random), y(random));
            wishes.push_back({QLineF(from, from + QPointF(way(random), way(random))),
                              {130, 25},
                              {230, 25},
                              {50, 18},
                              i == 0});
        }
        const QRectF legend(200, 10, 130, 40);
        const auto places = placeLabels(wishes, picture, {legend});
        EXPECT_TRUE(places[0]) << "the one that must be told";
        for (std::size_t i = 0; i < places.size(); ++i) {
            if (!places[i]) continue;
            EXPECT_TRUE(picture.contains(places[i]->box));
            brief += places[i]->brief;
            EXPECT_EQ(places[i]->brief, places[i]->box.size() == QSizeF(50, 18));
            if (places[i]->brief) {
                EXPECT_FALSE(places[i]->leader);
                EXPECT_LT(QLineF(places[i]->box.center(), wishes[i].line.center()).length(), 75);
            }
            EXPECT_TRUE(i == 0 || !places[i]->box.intersects(legend));
            for (std::size_t j = 1; j < i; ++j)
                EXPECT_FALSE(places[j] && places[i]->box.intersects(places[j]->box)) << trial;
        }
    }
    EXPECT_GT(brief, 60 * 3);
}

TEST(LabelPlaces, ColumnsOfANarrowPictureDoNotLieOverEachOther) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < 16; ++i) {
        const QPointF from(300 + 2 * i, 100 + 25 * i);
        wishes.push_back({QLineF(from, from + QPointF(4, 3)), {130, 25}, {400, 25}, {50, 18}});
    }
    const auto places = placeLabels(wishes, {0, 0, 660, 600}, {});
    int placed = 0;
    for (std::size_t i = 0; i < places.size(); ++i) {
        placed += places[i].has_value();
        for (std::size_t j = 0; j < i && places[i]; ++j)
            EXPECT_FALSE(places[j] && places[i]->box.intersects(places[j]->box)) << i << ' ' << j;
    }
    EXPECT_GE(placed, 5);
}

TEST(LabelPlaces, WhatFindsNoRoomIsLeftOut) {
    std::vector<LabelWish> wishes(60, {QLineF(400, 300, 404, 303), {120, 25}, {200, 25}});
    const auto places = placeLabels(wishes, {0, 0, 800, 600}, {});
    const auto told =
        std::count_if(places.begin(), places.end(), [](const auto& place) { return place.has_value(); });
    EXPECT_GE(told, 36);
    EXPECT_LE(told, 40) << "two columns of 600 pixels hold no more";
    for (std::size_t i = 0; i < 30; ++i) EXPECT_TRUE(places[i] || i >= 18) << "earlier ones come first";
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
