#pragma once

#include <QObject>
#include <QString>
#include <cstdint>
#include <vector>

namespace vestige {

class Document;

/// The steps of the open case since it was opened, in words, the undone ones behind the done ones. It reads
/// them off the document as they are made.
class History : public QObject {
    Q_OBJECT

  public:
    struct Step {
        std::uint64_t number = 0;  ///< of Scene::step
        QString text;
    };

    explicit History(Document& document, QObject* parent = nullptr);

    const std::vector<Step>& steps() const { return steps_; }
    /// How many of them are done; the last of these is the present one. 0: as the case was opened.
    std::size_t done() const { return done_; }
    /// Undoes or redoes until `done` steps are done; more than there are: all.
    void goTo(std::size_t done);

  signals:
    void changed();

  private:
    void follow();
    void clear();

    Document& document_;
    std::vector<Step> steps_;
    std::size_t done_ = 0;
};

}  // namespace vestige
