#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <vector>

#include "core/base/Error.h"
#include "ui/document/Wording.h"

namespace vestige {

/// Sentences for the user, from wherever they arise to the bar that shows them. Nothing modal.
class Notices : public QObject {
    Q_OBJECT

  public:
    /// What can be done about it.
    struct Offer {
        QString text;
        std::function<void()> take;
        QString group = {};  ///< taking one settles those of its group; the others stay
    };

    using QObject::QObject;
    void inform(const QString& sentence) { emit informed(sentence); }
    /// Offers to open `path` beside the sentence.
    void informOf(const QString& sentence, const QString& path) { emit informedOf(sentence, path); }
    /// Stays until it is closed.
    void warn(const QString& sentence) { emit warned(sentence); }
    /// A sentence with buttons; it stays until one of each group was pressed or it is closed.
    void offer(const QString& sentence, const std::vector<Offer>& offers) { emit offered(sentence, offers); }
    /// What they were made of is not open any more.
    void withdrawOffers() { emit withdrawn(); }
    /// A cancelled job is no failure and is not shown as one.
    void failed(const Error& error) {
        if (error.code == ErrorCode::cancelled)
            emit informed(tr("Cancelled; nothing was changed."));
        else
            emit warned(saidSentence(error));
    }

  signals:
    void informed(const QString& sentence);
    void informedOf(const QString& sentence, const QString& path);
    void offered(const QString& sentence, const std::vector<vestige::Notices::Offer>& offers);
    void withdrawn();
    void warned(const QString& sentence);
};

}  // namespace vestige
