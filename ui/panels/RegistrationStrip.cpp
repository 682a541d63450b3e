#include "ui/panels/RegistrationStrip.h"

#include <QHBoxLayout>
#include <QLabel>

#include "core/base/Numbers.h"
#include "ui/document/Attempts.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/FiguresRow.h"
#include "ui/panels/PanelColors.h"
#include "ui/panels/VerdictBadge.h"

namespace vestige {
namespace {

QString voxelText(const RegistrationResult& result) {
    if (result.voxelSchedule_m.empty()) return QString::fromUtf8("–");
    const QString first = QString::fromStdString(fixedText(result.voxelSchedule_m.front(), 2));
    const QString last = QString::fromStdString(fixedText(result.voxelSchedule_m.back(), 2));
    return first == last ? last + " m" : first + QString::fromUtf8(" → ") + last + " m";
}

QString secondsText(double seconds) {
    return seconds < 1 ? toQt(fixedText(1000 * seconds, 0)) + " ms" : toQt(fixedText(seconds, 1)) + " s";
}

/// As people call it; the names of the options are for command lines.
QString methodText(const std::string& method) {
    if (method == "improved-ndt") return QObject::tr("improved NDT");
    if (method == "ndt") return QObject::tr("classic NDT");
    if (method == "icp") return QObject::tr("ICP");
    return toQt(method);
}

QString motionText(const RegistrationResult& result) {
    const Similarity moved = result.targetFromSource * result.initial.inverse();
    const double angle = degrees(rotationAngle(moved.pose.rotation()));
    const double shift =
        (result.targetFromSource.pose.translation() - result.initial.pose.translation()).norm();
    return distanceText(shift) + ", " + QString::fromStdString(fixedText(angle, 2)) + QString::fromUtf8("°");
}

QString whyEmpty(const SceneState& scene) {
    if (scene.layers.size() < 2)
        return QObject::tr("Registration: add a second scan to align it with the first.");
    return QObject::tr("Not registered yet. Register (Ctrl+G) aligns the other layers with the target.");
}

}  // namespace

RegistrationStrip::RegistrationStrip(Document& document, Selection& selection, Attempts& attempts,
                                     QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      attempts_(attempts),
      picture_(new QLabel),
      figures_(new FiguresRow),
      empty_(new QLabel) {
    setObjectName("registration-strip");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 2, 2, 4);
    empty_->setProperty("role", "muted");
    empty_->setContentsMargins(12, 6, 12, 6);
    empty_->setWordWrap(true);
    // In a narrow window the last figures give way, not the panels beside the view.
    figures_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    picture_->setContentsMargins(12, 0, 0, 0);
    row->setSpacing(0);
    row->addWidget(picture_);
    row->addWidget(figures_, 1);
    row->addWidget(empty_, 1);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    connect(&attempts_, &Attempts::changed, this, [this] { fill(); });
    onPaletteChange(*this, [this] { fill(); });
    fill();
}

void RegistrationStrip::fill() {
    const SceneState& scene = document_.state();
    const ShownFit fit = shownFit(document_, selection_, attempts_);
    figures_->setVisible(fit.layer != nullptr);
    picture_->setVisible(fit.layer != nullptr);
    empty_->setVisible(fit.layer == nullptr);
    if (!fit.layer) return empty_->setText(whyEmpty(scene));
    const RegistrationResult& result = *fit.result;
    const Layer* target = scene.layer(scene.target);
    const QString onto = target ? QString::fromStdString(target->name) : QString();
    picture_->setPixmap(verdictPicture(result.verdict, 20, *this));
    figures_->setFigures(
        {{verdictWord(result.verdict), QString::fromStdString(fit.layer->name),
          verdictColor(result.verdict, palette())},
         {QString::fromStdString(fixedText(100 * result.overlap, 0)) + " %", tr("overlap"), {}},
         {distanceText(result.rmse_m), tr("RMS distance"), {}},
         {motionText(result), tr("moved"), {}},
         {QString::number(result.iterations), tr("iterations"), {}},
         {voxelText(result), tr("voxels, %1 sizes").arg(result.voxelSchedule_m.size()), {}},
         {secondsText(result.seconds), methodText(result.method), {}}},
        "figure-small");
    QStringList notes{tr("%1 on %2").arg(QString::fromStdString(fit.layer->name), onto),
                      verdictSentence(result.verdict)};
    for (const auto& reason : result.reasons) notes << said(reason);
    for (const auto& note : result.notes) notes << said(note);
    setToolTip(notes.join("\n"));
}

}  // namespace vestige
