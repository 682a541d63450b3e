#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QTextBrowser;

namespace vestige {

/// The user guide: the file beside the program, with its pictures, else its text alone, which the program
/// carries. Contents, search, links within.
class GuidePage : public QWidget {
    Q_OBJECT

  public:
    explicit GuidePage(QWidget* parent = nullptr);
    /// The headings, in their order.
    QStringList contents() const;

  private:
    void load();
    /// Room between lines and paragraphs, which Markdown does not tell.
    void layOut();
    void fillContents();
    void goTo(int block);
    void follow(const QUrl& link);
    void search(bool backwards);

    QTextBrowser* text_;
    QComboBox* contents_;
    QLineEdit* search_;
};

}  // namespace vestige
