#pragma once

#include <QObject>
#include <QString>
#include <functional>
#include <memory>
#include <optional>

#include "core/base/JobControl.h"
#include "core/base/Result.h"
#include "core/io/FormatRegistry.h"

namespace vestige {

/// Looks into the head of a file on a thread of its own. One file at a time; of those that are asked for
/// meanwhile only the last is looked at, and only what is told of the last one arrives. Neither look() nor
/// the destructor ever waits, however slow the disk.
class FilePeek : public QObject {
    Q_OBJECT

  public:
    using Peek = std::function<Result<FileInfo>(const std::filesystem::path&, const JobControl&)>;
    explicit FilePeek(
        QObject* parent = nullptr,
        Peek peek = [](const auto& file, const JobControl& control) { return peekFile(file, control); });
    ~FilePeek() override;

    /// Forgets the file before; an empty path asks for nothing.
    void look(const QString& path);

  signals:
    /// On the thread that owns this object.
    void told(const QString& path, const vestige::Result<vestige::FileInfo>& info);

  private:
    struct Mailbox;
    void start();
    void arrived(const QString& path, const Result<FileInfo>& info);

    Peek peek_;
    std::shared_ptr<Mailbox> mailbox_;
    QString wanted_;
    bool running_ = false;
    JobControl control_;
};

}  // namespace vestige
