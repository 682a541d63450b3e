#include "ui/panels/RegistrationStrip.h"

#include <QHBoxLayout>
#include <QLabel>

#include "core/base/Numbers.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/FiguresRow.h"

namespace vestige {
namespace {

const Layer* shownLayer(const SceneState& scene, const std::string& selected) {
    const Layer* layer = scene.layer(selected);
    if (layer && layer->registration) return layer;
    for (auto it = scene.layers.rbegin(); it != scene.layers.rend(); ++it)
        if (it->registration) return &*it;
    return nullptr;
}

QString voxelText(const RegistrationResult& result) {
    if (result.voxelSchedule_m.empty()) return QString::fromUtf8("–");
    const QString first = QString::fromStdString(fixedText(result.voxelSchedule_m.front(), 2));
    const QString last = QString::fromStdString(fixedText(result.voxelSchedule_m.back(), 2));
    return first == last ? last + " m" : first + QString::fromUtf8(" → ") + last + " m";
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

RegistrationStrip::RegistrationStrip(Document& document, Selection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      figures_(new FiguresRow),
      empty_(new QLabel) {
    setObjectName("registration-strip");
    setAttribute(Qt::WA_StyledBackground);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(2, 2, 2, 4);
    empty_->setProperty("role", "muted");
    empty_->setContentsMargins(12, 6, 12, 6);
    row->addWidget(figures_);
    row->addWidget(empty_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    fill();
}

void RegistrationStrip::fill() {
    const SceneState& scene = document_.state();
    const Layer* layer = shownLayer(scene, selection_.layer());
    figures_->setVisible(layer != nullptr);
    empty_->setVisible(layer == nullptr);
    if (!layer) return empty_->setText(whyEmpty(scene));
    const RegistrationResult& result = *layer->registration;
    const Layer* target = scene.layer(scene.target);
    const QString onto = target ? QString::fromStdString(target->name) : QString();
    figures_->setFigures(
        {{result.converged ? tr("Converged") : tr("Not converged"),
          tr("%1 on %2").arg(QString::fromStdString(layer->name), onto),
          result.converged ? QColor(0x8f, 0xd9, 0xae) : QColor(0xf2, 0xab, 0x5c)},
         {QString::fromStdString(fixedText(100 * result.overlap, 0)) + " %", tr("overlap"), {}},
         {distanceText(result.rmse_m), tr("RMS distance"), {}},
         {motionText(result), tr("moved"), {}},
         {QString::number(result.iterations), tr("iterations"), {}},
         {voxelText(result), tr("voxels, %1 sizes").arg(result.voxelSchedule_m.size()), {}},
         {QString::fromStdString(fixedText(result.seconds, 1)) + " s",
          QString::fromStdString(result.method),
          {}}},
        "figure-small");
    QStringList notes;
    for (const auto& note : result.notes) notes << QString::fromStdString(note);
    setToolTip(notes.join("\n"));
}

}  // namespace vestige
