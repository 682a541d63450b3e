#pragma once

#include <nlohmann/json.hpp>

#include "core/base/ParameterSet.h"

namespace vestige::cli {

/// Every parameter by its key; null for one that is automatic.
inline nlohmann::json parametersJson(const ParameterSet& parameters) {
    struct Visitor {
        nlohmann::json operator()(std::monostate) const { return nullptr; }
        nlohmann::json operator()(bool on) const { return on; }
        nlohmann::json operator()(std::int64_t number) const { return number; }
        nlohmann::json operator()(double number) const { return number; }
        nlohmann::json operator()(const std::string& text) const { return text; }
    };
    nlohmann::json object = nlohmann::json::object();
    for (const ParameterSpec& spec : parameters.table())
        object[spec.key] = std::visit(Visitor{}, parameters.value(spec.key));
    return object;
}

}  // namespace vestige::cli
