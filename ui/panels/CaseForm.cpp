#include "ui/panels/CaseForm.h"

#include <QFormLayout>
#include <QLineEdit>
#include <cmath>

#include "core/base/Numbers.h"
#include "core/scene/Edits.h"
#include "ui/document/Document.h"
#include "ui/document/Notices.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

QLineEdit* field(const char* objectName, const QString& tip, const QString& example) {
    auto* line = new QLineEdit;
    line->setObjectName(objectName);
    line->setToolTip(tip);
    line->setPlaceholderText(example);
    return line;
}

/// Nothing for text that is no number from `low` to `high`.
std::optional<double> numberIn(const QLineEdit& line, double low, double high) {
    QString text = line.text().trimmed();
    text.replace(QChar(0x2212), '-');
    const auto value = parseReal(text.toStdString());
    if (!value || !(*value >= low && *value <= high)) return std::nullopt;
    return value;
}

}  // namespace

CaseForm::CaseForm(Document& document, Notices& notices, QWidget* parent)
    : QWidget(parent),
      document_(document),
      notices_(notices),
      name_(field("case-name", tr("How the case is called in the report"), tr("Case 2025-0317, open road"))),
      operator_(field("case-operator", tr("Who answers for the report"), tr("Name of the analyst"))),
      latitude_(field("case-latitude", tr("WGS 84, -90 to 90; only with the longitude"), "30.6012")),
      longitude_(field("case-longitude", tr("WGS 84, -180 to 180; only with the latitude"), "114.3055")),
      height_(field("case-height", tr("Above the sea, -500 to 9000; 0 where nothing is given"), "0")) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(0, 0, 0, 0);
    form->setHorizontalSpacing(12);
    form->setVerticalSpacing(6);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    form->setLabelAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    form->addRow(tr("Name"), name_);
    form->addRow(tr("Operator"), operator_);
    form->addRow(tr("Latitude, °"), latitude_);
    form->addRow(tr("Longitude, °"), longitude_);
    form->addRow(tr("Height, m"), height_);
    for (QLineEdit* line : {name_, operator_, latitude_, longitude_, height_})
        connect(line, &QLineEdit::editingFinished, this, [this] { enter(); });
    connect(&document_, &Document::changed, this, [this] { fill(); });
    fill();
}

void CaseForm::enter() {
    const SceneState& scene = document_.state();
    std::optional<Site> site = scene.site;
    const bool given = !latitude_->text().trimmed().isEmpty() || !longitude_->text().trimmed().isEmpty();
    if (latitude_->isModified() || longitude_->isModified() || height_->isModified()) {
        const auto latitude = numberIn(*latitude_, -90, 90);
        const auto longitude = numberIn(*longitude_, -180, 180);
        const bool flat = height_->text().trimmed().isEmpty();
        const auto height = flat ? std::optional(0.0) : numberIn(*height_, -500, 9000);
        if (!given)
            site.reset();
        else if (latitude && longitude && height)
            site = Site{*latitude, *longitude, *height};
        else if (!latitude_->text().trimmed().isEmpty() && !longitude_->text().trimmed().isEmpty())
            notices_.warn(
                tr("The place is not taken: the latitude is -90 to 90 degrees, the longitude -180 to "
                   "180, the height -500 to 9000 metres, each with '.'."));
    }
    document_.perform(setCaseDetails(name_->text().trimmed().toStdString(),
                                     operator_->text().trimmed().toStdString(), site));
}

void CaseForm::fill() {
    const SceneState& scene = document_.state();
    const auto show = [](QLineEdit* line, const QString& text) {
        if ((line->isModified() && line->hasFocus()) || line->text() == text) return;
        line->setText(text);
    };
    show(name_, toQt(scene.name));
    show(operator_, toQt(scene.operatorName));
    // Half a place is being typed.
    const bool half = !scene.site && (latitude_->isModified() || longitude_->isModified()) &&
                      (latitude_->text().isEmpty() != longitude_->text().isEmpty());
    if (half) return;
    show(latitude_, scene.site ? toQt(exactText(scene.site->latitude_deg)) : QString());
    show(longitude_, scene.site ? toQt(exactText(scene.site->longitude_deg)) : QString());
    show(height_, scene.site ? toQt(exactText(scene.site->height_m)) : QString());
}

}  // namespace vestige
