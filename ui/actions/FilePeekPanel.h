#pragma once

#include <QWidget>
#include <utility>
#include <vector>

#include "core/io/FileInfo.h"
#include "core/io/LoadEstimate.h"
#include "ui/actions/FilePeek.h"

class QFileDialog;
class QLabel;

namespace vestige {

/// What can be told of a file before it is loaded, as rows "label, value": format, size, points, extent,
/// reference system, unit, sensor, what is in it, and the memory that loading will take.
std::vector<std::pair<QString, QString>> peekRows(const FileInfo& info, const LoadEstimate& estimate,
                                                  qint64 fileBytes);

/// Shows it beside the list of an open dialog.
class FilePeekPanel : public QWidget {
    Q_OBJECT

  public:
    explicit FilePeekPanel(QWidget* parent = nullptr);

    /// A file that was selected; a folder or nothing empties the panel.
    void showFile(const QString& path);

  private:
    void tell(const QString& path, const Result<FileInfo>& info);

    FilePeek* peek_;
    QLabel* title_;
    QLabel* text_;
};

/// Puts the panel at the right of a dialog of Qt's own kind and lets it follow the selection.
FilePeekPanel* addPeekPanel(QFileDialog& dialog);

}  // namespace vestige
