#include "ui/panels/FitPanel.h"
#include "ui/panels/FitWords.h"

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QTest>
#include <QTreeWidget>
#include <set>

#include "core/scene/Edits.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/Attempts.h"
#include "ui/document/Document.h"
#include "ui/document/FitTrace.h"
#include "ui/document/Preview.h"
#include "ui/document/Selection.h"
#include "ui/panels/VerdictBadge.h"

namespace vestige {
namespace {

Similarity at(double x) {
    Similarity pose;
    pose.pose.translation().x() = x;
    return pose;
}

RegistrationResult resultOf(Verdict verdict, std::vector<std::string> reasons) {
    RegistrationResult result;
    result.verdict = verdict;
    result.reasons = std::move(reasons);
    result.targetFromSource = at(3);
    result.converged = true;
    return result;
}

/// 2 mm and 0.1 degrees of standard deviation; free along x.
RegistrationQuality sampleQuality() {
    RegistrationQuality quality;
    quality.uncertainty.covariance.diagonal().head<3>().setConstant(4e-6);
    quality.uncertainty.covariance.diagonal().tail<3>().setConstant(std::pow(0.1 * 3.14159265 / 180, 2));
    quality.residuals = {0.001, {5, 20, 90, 20, 5}, 3};
    quality.restarts = {8, 7, 0.0004, 0.0001};
    ObservedDirection slide;
    slide.direction[0] = 1;
    slide.sigma_m = 0.5;
    slide.free = true;
    slide.words = "slides along the road (east-west)";
    quality.directions = {slide};
    return quality;
}

struct Panel {
    QWidget window;
    Document document;
    Selection selection;
    Preview preview;
    Attempts attempts{document, preview};
    FitTrace trace{document, preview};
    ActionCatalog actions{&window};
    FitPanel panel{{document, selection, attempts, trace, preview}, actions};

    Panel() {
        for (const char* id : {"road", "scan"}) {
            Layer layer;
            layer.id = layer.name = id;
            document.perform(addLayer(std::move(layer)));
        }
        panel.resize(400, 900);
        panel.show();
        QApplication::processEvents();
    }
    QString said(const char* name) {
        const auto* label = panel.findChild<QLabel*>(name);
        return label->isVisible() ? label->text() : QString();
    }
};

TEST(FitPanel, SaysVerdictReasonsAndQualityInWords) {
    Panel p;
    EXPECT_EQ(p.said("verdict-word"), "");
    RegistrationResult doubtful = resultOf(Verdict::doubtful, {"the scan can slide", "few points overlap"});
    doubtful.quality = sampleQuality();
    p.document.perform(setRegistration("scan", doubtful));
    EXPECT_EQ(p.said("verdict-word"), "Doubtful");
    EXPECT_TRUE(p.said("reasons").contains("The scan can slide"));
    EXPECT_TRUE(p.said("reasons").contains("Few points overlap"));
    EXPECT_EQ(p.said("uncertainty").count(QString::fromUtf8("± 3.9 mm")), 3) << "1.96 times 2 mm";
    EXPECT_EQ(p.said("uncertainty").count(QString::fromUtf8("± 0.20°")), 3);
    EXPECT_TRUE(p.said("freedom").contains("Slides along the road (east-west)"));
    EXPECT_TRUE(p.said("freedom").contains("980 mm"));
    EXPECT_TRUE(p.said("restarts").startsWith("7 of 8 restarts"));
    EXPECT_TRUE(p.panel.findChild<QWidget*>("residuals")->accessibleDescription().startsWith("140 points"));
    EXPECT_FALSE(p.panel.findChild<QWidget*>("candidates")->isVisible());
}

TEST(FitWords, SaySoWhereNothingIsHeldInsteadOfAbsurdFigures) {
    RegistrationQuality quality;
    quality.directions.resize(1);
    quality.directions[0].words = "slides level";
    quality.directions[0].free = true;
    quality.directions[0].sigma_m = 4e5;
    EXPECT_TRUE(freedomText(quality).contains("not held at all")) << freedomText(quality).toStdString();
    PoseUncertainty uncertainty;
    uncertainty.covariance.setIdentity();
    uncertainty.covariance *= 1e8;
    EXPECT_EQ(uncertaintyText(uncertainty).count("not held"), 6);
    EXPECT_EQ(restartsText({4, 0, 0, 0}), "None of 4 restarts from perturbed poses came back to this place.");
    EXPECT_TRUE(restartsText({4, 4, 0, 0}).contains("less than 0.1 mm"));
}

TEST(FitPanel, VerdictsDifferInWordAndShapeNotInColourAlone) {
    std::set<QString> words;
    std::vector<QImage> shapes;
    const QWidget on;
    for (const Verdict verdict :
         {Verdict::accepted, Verdict::doubtful, Verdict::failed, Verdict::ambiguous}) {
        words.insert(verdictWord(verdict));
        shapes.push_back(verdictPicture(verdict, 24, on).toImage().convertToFormat(QImage::Format_Alpha8));
    }
    EXPECT_EQ(words.size(), 4u);
    for (std::size_t i = 0; i < shapes.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) EXPECT_NE(shapes[i], shapes[j]) << "the outline tells them apart";
}

TEST(FitPanel, ACandidateIsPreviewedByAClickAndTheLayerStays) {
    Panel p;
    RegistrationResult several = resultOf(Verdict::ambiguous, {"two places fit alike"});
    several.candidates = {{at(1), 0.9}, {at(4), 0.88}};
    p.attempts.set("scan", several);
    p.selection.setLayer("scan");
    QApplication::processEvents();
    EXPECT_EQ(p.said("verdict-word"), "Ambiguous");
    auto* list = p.panel.findChild<QTreeWidget*>("candidates");
    ASSERT_EQ(list->topLevelItemCount(), 2);
    EXPECT_TRUE(list->topLevelItem(1)->text(0).contains("3.000 m"));
    QTest::mouseClick(list->viewport(), Qt::LeftButton, Qt::NoModifier,
                      list->visualItemRect(list->topLevelItem(1)).center());
    EXPECT_EQ(p.preview.layer(), "scan");
    EXPECT_EQ(p.preview.sceneFromLayer().pose.translation().x(), 4);
    EXPECT_EQ(p.attempts.pose("scan").pose.translation().x(), 4);
    EXPECT_FALSE(p.document.state().layer("scan")->registration);
    p.document.perform(removeLayer("scan"));
    EXPECT_EQ(p.attempts.of("scan"), nullptr);
    EXPECT_FALSE(p.preview.active()) << "nothing is shown of a layer that is gone";
}

TEST(FitPanel, ARefusedResultIsForgottenWithAnotherTarget) {
    Panel p;
    p.attempts.set("scan", resultOf(Verdict::failed, {"nothing overlaps"}));
    p.attempts.showPreview("scan", true);
    EXPECT_EQ(p.said("verdict-word"), "Failed");
    EXPECT_EQ(p.preview.sceneFromLayer().pose.translation().x(), 3);
    p.document.perform(setTarget("scan"));
    EXPECT_EQ(p.attempts.of("scan"), nullptr);
    EXPECT_FALSE(p.preview.active());
}

}  // namespace
}  // namespace vestige
