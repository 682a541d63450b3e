#include "app/cli/Session.h"

#include <unistd.h>

#include <CLI/Error.hpp>
#include <cstdio>
#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "core/base/Numbers.h"
#include "core/base/Translation.h"

namespace vestige::cli {
namespace {

std::string defaultText(const ParameterSet& parameters, const ParameterSpec& spec) {
    return spec.mayBeAutomatic() ? "automatic" : parameters.display(spec.key);
}

std::string helpText(const ParameterSet& parameters, const ParameterSpec& spec) {
    std::string text = spec.help;
    if (!spec.choices.empty()) {
        text += " One of";
        for (const auto& choice : spec.choices) text += " " + choice;
        text += ".";
    }
    if (spec.minimum && spec.maximum)
        text += " " + exactText(*spec.minimum) + " to " + exactText(*spec.maximum) +
                (spec.unit.empty() ? "" : " " + spec.unit) + ".";
    return text + " Default: " + defaultText(parameters, spec) + ".";
}

}  // namespace

Session::Session()
    : control_(
          [this, last = std::make_shared<int>(-1)](double fraction, std::string_view step) {
              if (quiet || !::isatty(STDERR_FILENO)) return;
              const int percent = static_cast<int>(100 * fraction);
              if (percent == *last) return;
              *last = percent;
              std::fprintf(stderr, "\r\033[K%3d %% %.*s%s", percent, static_cast<int>(step.size()),
                           step.data(), percent >= 100 ? "\n" : "");
          },
          [this](std::string_view message) { log(std::string(message)); }) {}

void Session::print(const std::string& line) const {
    if (!json) std::cout << line << '\n';
}

void Session::printJson(const nlohmann::json& object) const {
    if (json) std::cout << object.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) << '\n';
}

void Session::log(const std::string& line) const {
    if (!quiet) std::cerr << line << '\n';
}

int Session::failed(const Error& error) const {
    std::cerr << "vestige-cli: " << say(error) << '\n';
    return static_cast<int>(error.code);
}

void addSalvageOption(CLI::App& command, bool& salvage) {
    command.add_flag(
        "--salvage", salvage,
        "Of a file that ends early or is damaged, read what is whole; a warning says what is missing");
}

void addParameterOptions(CLI::App& command, ParameterSet& parameters) {
    for (const ParameterSpec& spec : parameters.table()) {
        if (spec.flag.empty()) continue;
        const std::string key = spec.key;
        command
            .add_option_function<std::string>(
                "--" + spec.flag,
                [&parameters, key, flag = spec.flag](const std::string& text) {
                    if (const Status set = parameters.setFromText(key, text); !set)
                        throw CLI::ValidationError("--" + flag, set.error().sentence());
                },
                helpText(parameters, spec))
            ->type_name(spec.unit.empty() ? std::string("VALUE") : spec.unit);
    }
}

}  // namespace vestige::cli
