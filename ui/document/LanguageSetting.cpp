#include "ui/document/LanguageSetting.h"

#include <QLocale>
#include <QSettings>
#include <string>

namespace vestige {
namespace {

const char* const kKey = "window/language";

}  // namespace

Language storedLanguage() {
    const std::string stored = QSettings().value(kKey).toString().toStdString();
    if (const auto language = languageFromName(stored)) return *language;
    return languageOfLocale(QLocale::system().name().toStdString());
}

void storeLanguage(Language language) {
    QSettings().setValue(kKey, QString::fromStdString(std::string(name(language))));
}

const char* nativeName(Language language) {
    return language == Language::simplifiedChinese ? "简体中文" : "English";
}

}  // namespace vestige
