#include "ui/panels/AccuracyPanel.h"

#include <QLabel>

#include "core/report/ReChartData.h"
#include "ui/document/Document.h"
#include "ui/document/Selection.h"
#include "ui/document/Wording.h"
#include "ui/panels/FiguresRow.h"
#include "ui/panels/ReChartView.h"

namespace vestige {
namespace {

const MethodAccuracy* accuracyOf(const MeasuredScene& measured, const std::string& method) {
    for (const MethodAccuracy& accuracy : measured.accuracy)
        if (accuracy.name == method && accuracy.n > 0) return &accuracy;
    return nullptr;
}

QString remarkOn(const MethodAccuracy& accuracy) {
    if (accuracy.systematic)
        return QObject::tr("Nothing is excluded: the errors are systematic, their mean is %1 %.")
            .arg(percentText(accuracy.meanRe));
    if (accuracy.excluded.empty()) return QObject::tr("No object lies beyond 2 SD.");
    QStringList names;
    for (const auto& object : accuracy.excluded) names << QString::fromStdString(object);
    return QObject::tr("Beyond 2 SD and excluded: %1.").arg(names.join(", "));
}

}  // namespace

AccuracyPanel::AccuracyPanel(Document& document, Selection& selection, QWidget* parent)
    : PanelSection(tr("Relative error by object"), parent),
      document_(document),
      selection_(selection),
      chart_(new ReChartView),
      figures_(new FiguresRow),
      remark_(new QLabel),
      empty_(new QLabel(tr("Appears once a measured object has a tape value."))) {
    for (QLabel* label : {remark_, empty_}) {
        label->setProperty("role", "muted");
        label->setWordWrap(true);
        label->setContentsMargins(12, 4, 12, 10);
    }
    figures_->setObjectName("rmse");
    remark_->setObjectName("excluded");
    setContent(chart_);
    setContent(figures_);
    setContent(remark_);
    setContent(empty_);
    connect(&document_, &Document::changed, this, [this] { fill(); });
    connect(&selection_, &Selection::changed, this, [this] { fill(); });
    fill();
}

void AccuracyPanel::setCompact(bool compact) {
    if (compact == compact_) return;
    compact_ = compact;
    fill();
}

void AccuracyPanel::fill() {
    const MeasuredScene& measured = document_.measured();
    const MethodAccuracy* accuracy = accuracyOf(measured, selection_.method());
    for (QWidget* widget :
         {static_cast<QWidget*>(chart_), static_cast<QWidget*>(figures_), static_cast<QWidget*>(remark_)})
        widget->setVisible(accuracy != nullptr);
    if (compact_) chart_->hide();
    empty_->setVisible(accuracy == nullptr);
    if (!accuracy) return;
    chart_->setChart(relativeErrorChart(measured.accuracy));
    const auto counted = accuracy->n - accuracy->excluded.size();
    figures_->setFigures(
        {{fractionText(accuracy->rmse), tr("RMSE of RE, %1 of %2").arg(counted).arg(accuracy->n), {}},
         {fractionText(accuracy->rmseAll), tr("RMSE of all %1").arg(accuracy->n), {}},
         {accuracy->rmseAbsolute_m ? distanceText(*accuracy->rmseAbsolute_m) : QString(),
          tr("RMSE in length"),
          {}}});
    remark_->setText(remarkOn(*accuracy));
}

}  // namespace vestige
