#pragma once

#include <QWidget>

class QComboBox;
class QLineEdit;
class QTextBrowser;

namespace vestige {

/// A page of the documentation ("guide", "tutorial") in the window's language where there is one: the file
/// beside the program, with its pictures, else its text alone, which the program carries. Contents, search,
/// links within.
class GuidePage : public QWidget {
    Q_OBJECT

  public:
    explicit GuidePage(const QString& page, QWidget* parent = nullptr);
    /// The headings, in their order.
    QStringList contents() const;
    /// To the heading with that anchor, else the page's beginning.
    void goToAnchor(const QString& anchor);

  signals:
    /// A link leads to a page like this one.
    void pageWanted(const QString& page, const QString& anchor);

  private:
    void load();
    /// Room between lines and paragraphs, which Markdown does not tell.
    void layOut();
    void fillContents();
    void goTo(int block);
    void follow(const QUrl& link);
    void search(bool backwards);

    QString page_;
    QTextBrowser* text_;
    QComboBox* contents_;
    QLineEdit* search_;
};

}  // namespace vestige
