#include <gtest/gtest.h>

#include <QAction>
#include <QFile>
#include <QMenu>
#include <QMenuBar>
#include <QWidget>
#include <map>
#include <set>

#include "ui/actions/ActionCatalog.h"

namespace vestige {
namespace {

TEST(ActionTable, EveryActionHasItsOwnIdAndAHelpSentence) {
    std::set<std::string> ids;
    for (const ActionSpec& spec : actionTable()) {
        EXPECT_TRUE(ids.insert(spec.id).second) << spec.id << " stands twice";
        const QString help = QString::fromUtf8(spec.help);
        EXPECT_TRUE(help.endsWith('.') && help.size() > 10) << spec.id;
        EXPECT_NE(spec.enabled, nullptr) << spec.id;
    }
}

TEST(ActionTable, NoTwoActionsShareAShortcut) {
    std::map<QString, std::string> taken;
    for (const ActionSpec& spec : actionTable()) {
        if (!*spec.shortcut) continue;
        const QKeySequence keys = QKeySequence::fromString(spec.shortcut, QKeySequence::PortableText);
        ASSERT_FALSE(keys.isEmpty()) << spec.id;
        const auto [place, isNew] = taken.emplace(keys.toString(QKeySequence::PortableText), spec.id);
        EXPECT_TRUE(isNew) << spec.id << " and " << place->second << " share " << spec.shortcut;
    }
}

TEST(ActionTable, NoTwoActionsOfAMenuShareAMnemonic) {
    std::map<std::string, std::string> taken;
    for (const ActionSpec& spec : actionTable()) {
        const QString text = QString::fromUtf8(spec.text).toLower();
        const int mark = text.indexOf('&');
        if (mark < 0) continue;
        const std::string key = spec.menu + text.mid(mark + 1, 1).toStdString();
        const auto [place, isNew] = taken.emplace(key, spec.id);
        EXPECT_TRUE(isNew) << spec.id << " and " << place->second << " share a letter in " << spec.menu;
    }
}

TEST(ActionTable, IconsExist) {
    for (const ActionSpec& spec : actionTable()) {
        if (!*spec.icon) continue;
        EXPECT_TRUE(QFile::exists(QString(":/icons/") + spec.icon + ".svg")) << spec.icon;
    }
}

TEST(ActionCatalog, FollowsTheSituation) {
    QWidget window;
    ActionCatalog actions(&window);
    actions.update({});
    EXPECT_FALSE(actions["edit.undo"].isEnabled());
    EXPECT_FALSE(actions["register.run"].isEnabled());
    EXPECT_TRUE(actions["file.add-files"].isEnabled());
    Situation now;
    now.canUndo = true;
    now.loadedLayers = now.layers = 2;
    now.registrable = 1;
    actions.update(now);
    EXPECT_TRUE(actions["edit.undo"].isEnabled());
    EXPECT_TRUE(actions["register.run"].isEnabled());
    now.hasMeasured = true;
    actions.update(now);
    EXPECT_TRUE(actions["export.csv"].isEnabled());
    now.busy = true;
    actions.update(now);
    EXPECT_FALSE(actions["export.csv"].isEnabled()) << "some of the points may be a first look only";
    EXPECT_FALSE(actions["register.run"].isEnabled());
    EXPECT_FALSE(actions["file.add-files"].isEnabled());
}

TEST(ActionCatalog, FillsEveryActionIntoAMenu) {
    QWidget window;
    ActionCatalog actions(&window);
    QMenuBar bar;
    actions.fill(bar);
    std::size_t found = 0;
    for (const QAction* menu : bar.actions())
        for (const QAction* action : menu->menu()->actions()) found += !action->isSeparator();
    EXPECT_EQ(found, actionTable().size());
}

}  // namespace
}  // namespace vestige
