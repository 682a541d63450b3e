#include "ui/shell/UseLanguage.h"

#include <QApplication>
#include <QLibraryInfo>
#include <QTranslator>
#include <memory>
#include <string>
#include <vector>

#include "core/base/Translation.h"

static void loadTranslations() {
    // Resources of a static library are linked only when asked for, outside of any namespace.
    Q_INIT_RESOURCE(translations);
}

namespace vestige {
namespace {

std::vector<std::unique_ptr<QTranslator>>& installed() {
    static std::vector<std::unique_ptr<QTranslator>> translators;
    return translators;
}

void install(const QString& file, const QString& folder) {
    auto translator = std::make_unique<QTranslator>();
    if (!translator->load(file, folder)) return;
    QApplication::installTranslator(translator.get());
    installed().push_back(std::move(translator));
}

}  // namespace

void useLanguage(Language language) {
    setLanguage(language);
    installed().clear();  // a translator takes itself out of the application
    if (language == Language::english) return;
    loadTranslations();
    const QString suffix = "_" + QString::fromStdString(std::string(name(language)));
    // Those that come later are asked first: Qt's own where they are installed, our few words for its buttons
    // else.
    install("qt" + suffix, ":/translations");
    install("qtbase" + suffix, QLibraryInfo::location(QLibraryInfo::TranslationsPath));
    install("vestige" + suffix, ":/translations");
}

}  // namespace vestige
