#include "ui/actions/Shortcuts.h"

#include <QAction>
#include <QSettings>

#include "ui/actions/ActionCatalog.h"

namespace vestige {
namespace {

QString keyOf(const std::string& id) {
    return "shortcuts/" + QString::fromStdString(id);
}

}  // namespace

Shortcuts::Shortcuts(ActionCatalog& actions, QObject* parent) : QObject(parent), actions_(actions) {
    const QSettings settings;
    for (const ActionSpec& spec : actionTable()) {
        const QVariant stored = settings.value(keyOf(spec.id));
        if (stored.isValid())
            actions_.setShortcut(spec.id,
                                 QKeySequence::fromString(stored.toString(), QKeySequence::PortableText));
    }
}

QKeySequence Shortcuts::of(const std::string& id) const {
    return actions_[id].shortcut();
}

QKeySequence Shortcuts::defaultOf(const std::string& id) {
    for (const ActionSpec& spec : actionTable())
        if (id == spec.id) return QKeySequence::fromString(spec.shortcut, QKeySequence::PortableText);
    return {};
}

std::optional<std::string> Shortcuts::holder(const QKeySequence& keys, const std::string& except) const {
    if (keys.isEmpty()) return std::nullopt;
    for (const ActionSpec& spec : actionTable())
        if (spec.id != except && of(spec.id) == keys) return spec.id;
    return std::nullopt;
}

bool Shortcuts::set(const std::string& id, const QKeySequence& keys) {
    if (holder(keys, id)) return false;
    actions_.setShortcut(id, keys);
    store(id);
    emit changed();
    return true;
}

bool Shortcuts::reset(const std::string& id) {
    return set(id, defaultOf(id));
}

void Shortcuts::resetAll() {
    for (const ActionSpec& spec : actionTable()) {
        actions_.setShortcut(spec.id, defaultOf(spec.id));
        store(spec.id);
    }
    emit changed();
}

void Shortcuts::store(const std::string& id) {
    QSettings settings;
    if (of(id) == defaultOf(id))
        settings.remove(keyOf(id));
    else
        settings.setValue(keyOf(id), of(id).toString(QKeySequence::PortableText));
}

}  // namespace vestige
