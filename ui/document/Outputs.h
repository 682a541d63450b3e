#pragma once

#include <QDateTime>
#include <QObject>
#include <QString>
#include <vector>

namespace vestige {

class Document;

/// What was written out of the open case since it was opened, newest first.
class Outputs : public QObject {
    Q_OBJECT

  public:
    enum class Kind { report, table, picture };
    struct Output {
        Kind kind = Kind::report;
        QString path;
        QDateTime written;
        std::uint64_t step = 0;  ///< of the history, that it shows
    };

    explicit Outputs(Document& document, QObject* parent = nullptr);

    const std::vector<Output>& all() const { return all_; }
    void add(Kind kind, const QString& path);
    /// Whether a report was written of the case as it is now.
    bool reported() const;

  signals:
    void changed();

  private:
    Document& document_;
    std::vector<Output> all_;
};

}  // namespace vestige
