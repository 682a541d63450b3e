#include "core/base/ParameterSet.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "core/base/Numbers.h"

namespace vestige {
namespace {

std::string allowed(const ParameterSpec& spec) {
    if (spec.type == ParameterType::choice) {
        std::string text = "one of";
        for (const auto& choice : spec.choices) text += " " + choice;
        return "expected " + text;
    }
    if (spec.type == ParameterType::boolean) return "expected true or false";
    if (spec.type == ParameterType::text) return "expected text";
    std::string text = spec.type == ParameterType::integer ? "expected a whole number" : "expected a number";
    if (spec.minimum) text += " from " + exactText(*spec.minimum);
    if (spec.maximum) text += " up to " + exactText(*spec.maximum);
    if (!spec.unit.empty()) text += " (" + spec.unit + ")";
    if (spec.mayBeAutomatic()) text += ", or auto";
    return text;
}

bool isAllowed(const ParameterSpec& spec, const ParameterValue& value) {
    if (std::holds_alternative<std::monostate>(value)) return spec.mayBeAutomatic();
    const auto inRange = [&](double number) {
        return std::isfinite(number) && (!spec.minimum || number >= *spec.minimum) &&
               (!spec.maximum || number <= *spec.maximum);
    };
    switch (spec.type) {
        case ParameterType::boolean:
            return std::holds_alternative<bool>(value);
        case ParameterType::integer:
            return std::holds_alternative<std::int64_t>(value) &&
                   inRange(static_cast<double>(std::get<std::int64_t>(value)));
        case ParameterType::real:
            return std::holds_alternative<double>(value) && inRange(std::get<double>(value));
        case ParameterType::choice:
            return std::holds_alternative<std::string>(value) &&
                   std::find(spec.choices.begin(), spec.choices.end(), std::get<std::string>(value)) !=
                       spec.choices.end();
        case ParameterType::text:
            return std::holds_alternative<std::string>(value);
    }
    return false;
}

std::string plain(const ParameterValue& value) {
    struct Visitor {
        std::string operator()(std::monostate) const { return "automatic"; }
        std::string operator()(bool on) const { return on ? "true" : "false"; }
        std::string operator()(std::int64_t number) const { return std::to_string(number); }
        std::string operator()(double number) const { return exactText(number); }
        std::string operator()(const std::string& text) const { return text; }
    };
    return std::visit(Visitor{}, value);
}

}  // namespace

ParameterSet::ParameterSet(const ParameterTable& table) : table_(&table) {
    for (const auto& spec : table) values_.emplace(spec.key, spec.defaultValue);
}

const ParameterSpec* ParameterSet::find(std::string_view key) const {
    const auto found =
        std::find_if(table_->begin(), table_->end(), [&](const auto& spec) { return spec.key == key; });
    return found == table_->end() ? nullptr : &*found;
}

Status ParameterSet::set(std::string_view key, ParameterValue value) {
    const ParameterSpec* spec = find(key);
    if (!spec) return fail(ErrorCode::usage, "there is no parameter '" + std::string(key) + "'");
    if (spec->type == ParameterType::real && std::holds_alternative<std::int64_t>(value))
        value = static_cast<double>(std::get<std::int64_t>(value));
    if (!isAllowed(*spec, value))
        return fail(ErrorCode::usage, "the value '" + plain(value) + "' is not allowed for " + spec->key, {},
                    allowed(*spec));
    values_.find(key)->second = std::move(value);
    return {};
}

void ParameterSet::setNearest(std::string_view key, double value) {
    const ParameterSpec* spec = find(key);
    if (!spec || spec->type != ParameterType::real)
        throw std::logic_error("no real parameter " + std::string(key));
    if (spec->minimum) value = std::max(value, *spec->minimum);
    if (spec->maximum) value = std::min(value, *spec->maximum);
    values_.find(key)->second = value;
}

Status ParameterSet::setFromText(std::string_view key, std::string_view text) {
    const ParameterSpec* spec = find(key);
    if (!spec) return fail(ErrorCode::usage, "there is no parameter '" + std::string(key) + "'");
    if (spec->mayBeAutomatic() && (text == "auto" || text == "automatic")) return set(key, std::monostate{});
    const auto reject = [&] {
        return fail(ErrorCode::usage, "the value '" + std::string(text) + "' is not allowed for " + spec->key,
                    {}, allowed(*spec));
    };
    switch (spec->type) {
        case ParameterType::boolean:
            if (text != "true" && text != "false") return reject();
            return set(key, text == "true");
        case ParameterType::integer:
            if (const auto number = parseInteger(text)) return set(key, *number);
            return reject();
        case ParameterType::real:
            if (const auto number = parseReal(text)) return set(key, *number);
            return reject();
        case ParameterType::choice:
        case ParameterType::text:
            return set(key, std::string(text));
    }
    return reject();
}

bool ParameterSet::isDefault(std::string_view key) const {
    const ParameterSpec* spec = find(key);
    return spec && value(key) == spec->defaultValue;
}

const ParameterValue& ParameterSet::value(std::string_view key) const {
    const auto found = values_.find(key);
    if (found == values_.end()) throw std::logic_error("unknown parameter " + std::string(key));
    return found->second;
}

bool ParameterSet::boolean(std::string_view key) const {
    return std::get<bool>(value(key));
}
std::int64_t ParameterSet::integer(std::string_view key) const {
    return std::get<std::int64_t>(value(key));
}
double ParameterSet::real(std::string_view key) const {
    return std::get<double>(value(key));
}

std::optional<double> ParameterSet::optionalReal(std::string_view key) const {
    const ParameterValue& held = value(key);
    if (std::holds_alternative<std::monostate>(held)) return std::nullopt;
    return std::get<double>(held);
}

const std::string& ParameterSet::text(std::string_view key) const {
    return std::get<std::string>(value(key));
}

std::string ParameterSet::display(std::string_view key) const {
    const ParameterValue& held = value(key);
    const ParameterSpec* spec = find(key);
    std::string text = plain(held);
    if (spec && !spec->unit.empty() && !std::holds_alternative<std::monostate>(held))
        text += " " + spec->unit;
    return text;
}

}  // namespace vestige
