#pragma once

#include <CLI/App.hpp>
#include <functional>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>
#include "core/base/JobControl.h"
#include "core/base/ParameterSet.h"
#include "core/base/Result.h"

namespace vestige::cli {

/// What all verbs share: the global options, progress and messages on stderr, results on stdout, and the exit
/// code.
class Session {
  public:
    Session();

    int threads = 0;
    bool quiet = false;
    bool json = false;

    /// Cancelled by SIGINT and SIGTERM; draws a progress bar when stderr is a terminal.
    const JobControl& control() const { return control_; }

    /// A line for people on stdout; nothing with --json.
    void print(const std::string& line) const;
    /// The one JSON object of --json.
    void printJson(const nlohmann::json& object) const;
    /// A line on stderr; nothing with --quiet.
    void log(const std::string& line) const;

    /// Ends the command: the sentence goes to stderr, the code becomes the exit code.
    int failed(const Error& error) const;

  private:
    JobControl control_;
};

/// A verb declares its options on a subcommand of `app` and stores what to run; the returned int is the exit
/// code.
using Run = std::function<int(Session&)>;
struct Verb {
    const char* name;
    const char* summary;
    Run (*declare)(CLI::App& command);
};

/// One line per verb; the order of --help.
const std::vector<Verb>& verbs();

/// Declares an option for each parameter that has a flag, with range, default and help from its spec. What
/// the user gives is set on `parameters`, which must live as long as the command; a value that is not allowed
/// is a wrong command line.
void addParameterOptions(CLI::App& command, ParameterSet& parameters);

/// Declares --salvage.
void addSalvageOption(CLI::App& command, bool& salvage);

/// Each verb's declaration, one file per verb.
Run declareInfo(CLI::App& command);
Run declareConvert(CLI::App& command);
Run declarePreprocess(CLI::App& command);
Run declareRegister(CLI::App& command);
Run declareEvaluate(CLI::App& command);
Run declareAccuracy(CLI::App& command);
Run declareReconstruct(CLI::App& command);
Run declareScreenshot(CLI::App& command);
Run declareSimulate(CLI::App& command);

}  // namespace vestige::cli
