#include "ui/forms/ParameterHelp.h"

#include <QCoreApplication>

#include "core/base/Numbers.h"
#include "ui/document/Wording.h"

namespace vestige {
namespace {

struct Texts {
    Q_DECLARE_TR_FUNCTIONS(ParameterHelp)
};

QString numberText(double value, const ParameterSpec& spec) {
    const QString text = QString::fromStdString(exactText(value));
    return spec.unit.empty() ? text : text + " " + QString::fromStdString(spec.unit);
}

QString rangeText(const ParameterSpec& spec) {
    if (spec.minimum && spec.maximum)
        return Texts::tr("%1 to %2")
            .arg(QString::fromStdString(exactText(*spec.minimum)), numberText(*spec.maximum, spec));
    if (spec.minimum) return Texts::tr("at least %1").arg(numberText(*spec.minimum, spec));
    if (spec.maximum) return Texts::tr("at most %1").arg(numberText(*spec.maximum, spec));
    return {};
}

QString defaultText(const ParameterSpec& spec) {
    const ParameterValue& value = spec.defaultValue;
    if (spec.mayBeAutomatic()) return Texts::tr("automatic");
    if (const auto* real = std::get_if<double>(&value)) return numberText(*real, spec);
    if (const auto* integer = std::get_if<std::int64_t>(&value))
        return numberText(static_cast<double>(*integer), spec);
    if (const auto* on = std::get_if<bool>(&value)) return *on ? Texts::tr("on") : Texts::tr("off");
    const auto* text = std::get_if<std::string>(&value);
    return text ? said(*text) : QString();
}

}  // namespace

QString parameterHelp(const ParameterSpec& spec) {
    QString text = said(spec.help);
    const QString range = rangeText(spec);
    const QString usual = defaultText(spec);
    if (!range.isEmpty() && !usual.isEmpty())
        text += " " + Texts::tr("Range: %1; default: %2.").arg(range, usual);
    else if (!usual.isEmpty())
        text += " " + Texts::tr("Default: %1.").arg(usual);
    return text;
}

}  // namespace vestige
