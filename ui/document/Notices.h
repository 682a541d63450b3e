#pragma once

#include <QObject>
#include <QString>
#include <functional>

#include "core/base/Error.h"

namespace vestige {

/// Sentences for the user, from wherever they arise to the bar that shows them. Nothing modal.
class Notices : public QObject {
    Q_OBJECT

  public:
    using QObject::QObject;
    void inform(const QString& sentence) { emit informed(sentence); }
    /// Offers to open `path` beside the sentence.
    void informOf(const QString& sentence, const QString& path) { emit informedOf(sentence, path); }
    /// Stays until it is closed.
    void warn(const QString& sentence) { emit warned(sentence); }
    /// A cancelled job is no failure and is not shown as one.
    void failed(const Error& error) {
        if (error.code == ErrorCode::cancelled)
            emit informed(tr("Cancelled; nothing was changed."));
        else
            emit warned(QString::fromStdString(error.sentence()) + ".");
    }
    /// A failure with a way on: a button `label` beside the sentence does `action` on the GUI thread.
    void offer(const Error& error, const QString& label, const std::function<void()>& action) {
        emit offered(QString::fromStdString(error.sentence()) + ".", label, action);
    }

  signals:
    void informed(const QString& sentence);
    void informedOf(const QString& sentence, const QString& path);
    void warned(const QString& sentence);
    void offered(const QString& sentence, const QString& label, const std::function<void()>& action);
};

}  // namespace vestige
