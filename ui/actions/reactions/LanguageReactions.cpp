#include "ui/actions/reactions/LanguageReactions.h"

#include <QApplication>
#include <QSignalBlocker>
#include <QWidget>
#include <string>
#include <utility>

#include "core/base/Translation.h"
#include "ui/actions/ActionCatalog.h"
#include "ui/document/LanguageSetting.h"
#include "ui/document/Notices.h"

namespace vestige {
namespace {

constexpr std::pair<const char*, Language> kActions[] = {{"view.language-en", Language::english},
                                                         {"view.language-zh", Language::simplifiedChinese}};

}  // namespace

LanguageReactions::LanguageReactions(const Workbench& bench, QObject* parent)
    : QObject(parent), bench_(bench) {
    for (const auto& [id, language] : kActions) {
        QAction& action = bench_.actions[id];
        action.setText(nativeName(language));  // whoever looks for it may not read the language of the window
        {
            const QSignalBlocker quiet(action);
            action.setChecked(language == vestige::language());
        }
        bench_.actions.onTriggered(id, [this, language = language] { choose(language); });
    }
}

void LanguageReactions::choose(Language language) {
    storeLanguage(language);
    if (language == vestige::language()) return bench_.notices.withdrawOffers();
    const Translator said(language);
    const auto inIt = [&](const char* english) { return QString::fromStdString(said(english)); };
    bench_.notices.offer(inIt("Vestige speaks English from its next start on."),
                         {{inIt("Open the window again in English"), [this] { openAgain(); }}});
}

/// Asks about what is not saved, as closing does.
void LanguageReactions::openAgain() {
    QApplication::setQuitOnLastWindowClosed(false);
    if (bench_.window.close())
        QApplication::exit(kOpenAgain);
    else
        QApplication::setQuitOnLastWindowClosed(true);
}

}  // namespace vestige
