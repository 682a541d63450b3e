#pragma once

#include <QKeySequence>
#include <QObject>
#include <optional>
#include <string>

namespace vestige {

class ActionCatalog;

/// The shortcuts of the actions as the user has them: those of the action table but for what was changed,
/// which is kept in the user's settings.
class Shortcuts : public QObject {
    Q_OBJECT

  public:
    /// Takes what is stored. `actions` outlives it.
    explicit Shortcuts(ActionCatalog& actions, QObject* parent = nullptr);

    QKeySequence of(const std::string& id) const;
    /// The action table's.
    static QKeySequence defaultOf(const std::string& id);
    /// Which other action has these keys; nothing for free or empty ones.
    std::optional<std::string> holder(const QKeySequence& keys, const std::string& except) const;

    /// False, and nothing is changed, where another action has the keys. Empty: no shortcut.
    bool set(const std::string& id, const QKeySequence& keys);
    /// To the action table's; false where another action has those keys now.
    bool reset(const std::string& id);
    void resetAll();

  signals:
    void changed();

  private:
    void store(const std::string& id);

    ActionCatalog& actions_;
};

}  // namespace vestige
