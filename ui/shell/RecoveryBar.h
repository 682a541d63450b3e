#pragma once

#include <QWidget>
#include <functional>
#include <vector>

#include "core/scene/store/Autosaves.h"

class QLabel;
class QPushButton;

namespace vestige {

class Autosave;
class Loader;

/// Above the view: what was done and not saved before a program ended. At the start it offers cases that were
/// left behind; for the case that was opened it says what came back and offers to go back. Nothing modal, and
/// nothing is lost by leaving it alone.
class RecoveryBar : public QWidget {
    Q_OBJECT

  public:
    /// `mayLeave` asks about unsaved changes of the present case.
    RecoveryBar(Autosave& autosave, Loader& loader, std::function<bool()> mayLeave,
                QWidget* parent = nullptr);
    /// Looks for what was left behind.
    void offerAbandoned();

  private:
    void offerNext();
    void tellRecovered(const QString& sentence);
    void accept();
    void discard();

    Autosave& autosave_;
    Loader& loader_;
    std::function<bool()> mayLeave_;
    std::vector<Abandoned> offers_;
    bool ofOpenCase_ = false;
    QLabel* text_;
    QPushButton* accept_;
    QPushButton* discard_;
};

}  // namespace vestige
