#include <QApplication>
#include <QCommandLineParser>
#include <QIcon>
#include <QStandardPaths>
#include <algorithm>
#include <clocale>
#include <exception>
#include <iostream>
#include <optional>
#include <string_view>

#include "core/base/Numbers.h"
#include "core/base/Version.h"
#include "ui/document/Document.h"
#include "ui/document/LanguageSetting.h"
#include "ui/print/PdfPrinter.h"
#include "ui/shell/MainWindow.h"
#include "ui/shell/UseLanguage.h"
#include "ui/shell/WindowPlace.h"
#include "ui/view/NativeSurface.h"
#include "ui/view/PictureRenderer.h"
#include "ui/watch/AnswerWatch.h"
#include "ui/watch/EventWatch.h"
#include "ui/watch/StartTime.h"
#include "ui/watch/WatchedApplication.h"

namespace {

using namespace vestige;

constexpr double kLongBlock_s = 0.5;

void describe(QCommandLineParser& parser) {
    parser.setApplicationDescription("Rebuilds road-accident scenes from laser scans and measures them.");
    parser.addPositionalArgument(
        "case", "A case (case.json, NAME.vestige) or clouds and meshes to begin with.", "[CASE|FILE...]");
    parser.addOption(
        {"language", "en or zh_CN. Default: as chosen under View, at first the system's.", "LANGUAGE"});
    parser.addOption(
        {"watch", "Says on stderr when the window does not answer, and at the end what held it longest."});
    parser.addOption({"start-time", "Says how long the window took to stand, and ends."});
    parser.addHelpOption();
    parser.addVersionOption();
}

/// Help and version need no display.
bool asksOnlyForWords(int argc, char** argv) {
    return std::any_of(argv + 1, argv + argc, [](const std::string_view argument) {
        return argument == "-h" || argument == "--help" || argument == "--help-all" || argument == "-v" ||
               argument == "--version";
    });
}

/// A sentence of ours where Qt would end the program.
bool hasDisplay(int argc, char** argv) {
    const auto set = [](const char* name) { return !qEnvironmentVariableIsEmpty(name); };
    const bool chosen = std::any_of(argv + 1, argv + argc, [](const std::string_view argument) {
        return argument == "-platform" || argument == "--platform";
    });
    return chosen || set("DISPLAY") || set("WAYLAND_DISPLAY") || set("QT_QPA_PLATFORM");
}

/// Until it is closed, or stands where only the time of its start is asked. What is open then stands in
/// `paths` when it is to open again in another language.
int showWindow(Language language, QStringList& paths, bool tellStart) {
    useLanguage(language);
    QApplication::setQuitOnLastWindowClosed(true);
    MainWindow window(nativeSurface(), nativeRenderer(), std::make_unique<PdfPrinter>());
    QApplication::setWindowIcon(QIcon(":/icons/vestige.svg"));
    const QString data = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
    window.keepEdits(std::filesystem::path(data.toStdString()) / "autosave");
    placeWindow(window);
    window.show();
    if (!paths.isEmpty()) window.open(paths);
    if (tellStart)
        whenUsable(window, [] {
            std::cout << "usable after " << fixedText(processAge_s(), 2) << " s" << std::endl;
            QCoreApplication::quit();
        });
    const int code = QApplication::exec();
    keepPlace(window);
    const auto& file = window.document().state().file;
    paths = file.empty() ? QStringList() : QStringList(QString::fromStdString(file.string()));
    return code;
}

int run(int argc, char** argv) {
    QCoreApplication::setOrganizationName("Vestige");
    QCoreApplication::setApplicationName("vestige");
    QCoreApplication::setApplicationVersion(kVersion);
    QCommandLineParser parser;
    describe(parser);
    if (asksOnlyForWords(argc, argv)) {
        const QCoreApplication words(argc, argv);
        parser.process(words);
    }
    if (!hasDisplay(argc, argv)) {
        std::cerr << "vestige: there is no display to open a window on; vestige-cli does the same work "
                     "without one\n";
        return 3;
    }
    // Screens of any density: everything is drawn at its own resolution, in steps as fine as the desktop's.
    QApplication::setAttribute(Qt::AA_EnableHighDpiScaling);
    QApplication::setAttribute(Qt::AA_UseHighDpiPixmaps);
    QApplication::setHighDpiScaleFactorRoundingPolicy(Qt::HighDpiScaleFactorRoundingPolicy::PassThrough);
    setNativeSurfaceFormat();
    WatchedApplication application(argc, argv);
    // Numbers are written with a point everywhere; Qt has set the locale of the environment.
    std::setlocale(LC_NUMERIC, "C");
    parser.process(application);

    std::optional<Language> language;
    if (parser.isSet("language")) {
        language = languageFromName(parser.value("language").toStdString());
        if (!language) {
            std::cerr << "vestige: --language: expected en or zh_CN\n";
            return 2;
        }
    }
    std::optional<EventWatch> watch;
    std::optional<AnswerWatch> answers;
    if (parser.isSet("watch")) {
        watch.emplace();
        answers.emplace(*watch, kLongBlock_s, [](double held_s) {
            std::cerr << "vestige: the window has not answered for " << fixedText(held_s, 1) << " s\n";
        });
    }
    QStringList paths = parser.positionalArguments();
    int code = showWindow(language.value_or(storedLanguage()), paths, parser.isSet("start-time"));
    while (code == kOpenAgain) code = showWindow(storedLanguage(), paths, false);
    if (watch)
        for (const QString& line : watch->report()) std::cerr << "vestige: " << line.toStdString() << '\n';
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& error) {
        std::cerr << "vestige: " << error.what() << '\n';
    }
    return 3;
}
