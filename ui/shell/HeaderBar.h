#pragma once

#include <QDateTime>
#include <QToolBar>

class QLabel;
class QPushButton;

namespace vestige {

class ActionCatalog;
class Document;

/// The bar under the menus: files at the left, the case's name and whether it is saved, undo, redo and the
/// report at the right.
class HeaderBar : public QToolBar {
    Q_OBJECT

  public:
    HeaderBar(const ActionCatalog& actions, Document& document, QWidget* parent = nullptr);

    /// Why the case cannot be saved where it is; empty: it can.
    void showReadOnly(const QString& reason);

    /// Whether the unsaved changes outlast everything, as far as is known now.
    void showStored(bool stored);

  private:
    void follow();

    Document& document_;
    QLabel* title_;
    QLabel* saved_;
    QAction* readOnly_;
    QDateTime savedAt_;   ///< of the case as it is
    QDateTime storedAt_;  ///< of its unsaved changes; invalid: not yet
};

}  // namespace vestige
