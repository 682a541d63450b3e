#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <clocale>
#include <csignal>
#include <iostream>

#include "app/cli/Session.h"
#include "core/base/Parallel.h"
#include "core/base/Translation.h"
#include "core/base/Version.h"

namespace {

using namespace vestige;
using namespace vestige::cli;

const JobControl* runningJob = nullptr;

void onSignal(int) {
    if (runningJob) runningJob->cancel();
}

void addGlobalOptions(CLI::App& app, Session& session) {
    app.add_option("--threads", session.threads,
                   "Threads to use; 0 or nothing means all cores. Results never depend on it.")
        ->check(CLI::Range(0, 1024));
    app.add_flag("--quiet", session.quiet, "No progress and no log on stderr, only errors.");
    app.add_option_function<std::string>(
           "--language", [](const std::string& chosen) { setLanguage(*languageFromName(chosen)); },
           "Of reports, pictures and the window in them: en or zh_CN. Files for machines are English always. "
           "Default: en.")
        ->check(CLI::IsMember({"en", "zh_CN"}))
        ->type_name("LANGUAGE");
    app.add_flag("--json", session.json, "One JSON object on stdout and nothing else there.");
}

int run(int argc, char** argv) {
    Session session;
    CLI::App app("Vestige rebuilds road-accident scenes from laser scans and measures them.", "vestige-cli");
    app.set_version_flag("--version", std::string("vestige ") + kVersion);
    app.require_subcommand(1);
    app.fallthrough();
    addGlobalOptions(app, session);
    Run chosen;
    for (const Verb& verb : verbs()) {
        CLI::App* command = app.add_subcommand(verb.name, verb.summary);
        command->fallthrough();
        Run work = verb.declare(*command);
        command->callback([&chosen, work = std::move(work)] { chosen = work; });
    }
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        const int code = app.exit(error, std::cout, std::cerr);
        return code == 0 ? 0 : static_cast<int>(ErrorCode::usage);
    }
    runningJob = &session.control();
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
    setThreadCount(session.threads);
    const int code = chosen(session);
    std::cout.flush();
    if (code == 0 && !std::cout)
        return session.failed({ErrorCode::output, "the results cannot be written", "standard output",
                               "the files that were asked for are complete"});
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    std::setlocale(LC_ALL, "C");
    try {
        return run(argc, argv);
    } catch (const std::bad_alloc&) {
        std::cerr << "vestige-cli: there is not enough memory for this\n";
    } catch (const std::exception& error) {
        std::cerr << "vestige-cli: " << error.what() << '\n';
    }
    return static_cast<int>(ErrorCode::input);
}
