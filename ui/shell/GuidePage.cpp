#include "ui/shell/GuidePage.h"

#include <QComboBox>
#include <QCoreApplication>
#include <QDesktopServices>
#include <QDir>
#include <QFile>
#include <QHBoxLayout>
#include <QImageReader>
#include <QLineEdit>
#include <QScrollBar>
#include <QShortcut>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextDocumentFragment>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "core/base/Translation.h"

namespace vestige {
namespace {

/// Pages in the order in which a reader would want them.
QStringList fileNames(const QString& page) {
    QStringList names{page + ".md"};
    if (language() == Language::simplifiedChinese) names.prepend(page + ".zh_CN.md");
    return names;
}

/// Where a page lies: installed, or in the tree that the program was built in. Empty: nowhere.
QString pageFile(const QString& page) {
    const QString program = QCoreApplication::applicationDirPath();
    for (const QString& name : fileNames(page))
        for (const char* place : {"/../share/doc/vestige/", "/../../../docs/"}) {
            const QString file = QDir::cleanPath(program + place + name);
            if (QFile::exists(file)) return file;
        }
    return {};
}

/// Of what the program carries.
QString carriedPage(const QString& page) {
    for (const QString& name : fileNames(page))
        if (QFile::exists(":/docs/" + name)) return ":/docs/" + name;
    return {};
}

/// As wide as pictures are shown.
constexpr int kPictures = 312;

class GuideBrowser : public QTextBrowser {
  public:
    QVariant loadResource(int type, const QUrl& name) override {
        if (type != QTextDocument::ImageResource || folder_.isEmpty())
            return QTextBrowser::loadResource(type, name);
        QImageReader reader(folder_ + "/" + name.path());
        const QSize size = reader.size();
        // The page may not have its width yet.
        const double scale = devicePixelRatioF();
        const int width = static_cast<int>(kPictures * scale);
        if (size.isValid() && size.width() > width)
            reader.setScaledSize(size.scaled(width, 100000, Qt::KeepAspectRatio));
        QImage picture = reader.read();
        picture.setDevicePixelRatio(scale);
        return QVariant(picture);
    }
    void setFolder(const QString& folder) { folder_ = folder; }

  private:
    QString folder_;
};

/// As the sites that show Markdown name a heading.
QString anchorOf(const QString& heading) {
    QString anchor;
    for (const QChar c : heading.toLower())
        if (c.isLetterOrNumber() || c == '-')
            anchor += c;
        else if (c == ' ')
            anchor += '-';
    return anchor;
}

QToolButton* arrow(const QString& text, const QString& tip) {
    auto* button = new QToolButton;
    button->setText(text);
    button->setToolTip(tip);
    button->setAccessibleName(tip);
    button->setAutoRaise(true);
    return button;
}

}  // namespace

GuidePage::GuidePage(const QString& page, QWidget* parent)
    : QWidget(parent),
      page_(page),
      text_(new GuideBrowser),
      contents_(new QComboBox),
      search_(new QLineEdit) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(10, 10, 0, 0);
    column->setSpacing(8);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 10, 0);
    row->setSpacing(6);
    contents_->setObjectName(page + "-contents");
    contents_->setToolTip(tr("Contents"));
    contents_->setAccessibleName(tr("Contents of the page"));
    contents_->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    contents_->setMinimumContentsLength(12);
    search_->setObjectName(page + "-search");
    search_->setPlaceholderText(tr("Search"));
    search_->setToolTip(tr("Return finds the next place, Shift+Return the one before"));
    search_->setAccessibleName(tr("Search the page"));
    auto* back = arrow(QString::fromUtf8("‹"), tr("Place before"));
    auto* on = arrow(QString::fromUtf8("›"), tr("Next place"));
    row->addWidget(contents_, 1);
    row->addWidget(search_, 1);
    row->addWidget(back);
    row->addWidget(on);
    column->addLayout(row);
    text_->setObjectName(page + "-text");
    text_->setAccessibleName(tr("Documentation"));
    text_->setFrameShape(QFrame::NoFrame);
    text_->setOpenLinks(false);
    column->addWidget(text_, 1);
    setFocusProxy(text_);
    connect(text_, &QTextBrowser::anchorClicked, this, &GuidePage::follow);
    connect(contents_, QOverload<int>::of(&QComboBox::activated), this,
            [this](int index) { goTo(contents_->itemData(index).toInt()); });
    connect(back, &QToolButton::clicked, this, [this] { search(true); });
    connect(on, &QToolButton::clicked, this, [this] { search(false); });
    connect(search_, &QLineEdit::returnPressed, this, [this] { search(false); });
    auto* before = new QShortcut(QKeySequence("Shift+Return"), search_);
    before->setContext(Qt::WidgetShortcut);
    connect(before, &QShortcut::activated, this, [this] { search(true); });
    load();
}

void GuidePage::load() {
    const QString place = pageFile(page_);
    if (!place.isEmpty()) static_cast<GuideBrowser*>(text_)->setFolder(QFileInfo(place).path());
    QFile file(place.isEmpty() ? carriedPage(page_) : place);
    if (!file.open(QIODevice::ReadOnly)) return;
    text_->document()->setDocumentMargin(6);
    text_->document()->setMarkdown(QString::fromUtf8(file.readAll()));
    layOut();
    fillContents();
    text_->moveCursor(QTextCursor::Start);
}

void GuidePage::layOut() {
    QTextCursor cursor(text_->document());
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        QTextBlockFormat format = block.blockFormat();
        const bool heading = format.headingLevel() > 0;
        format.setLineHeight(heading ? 100 : 130, QTextBlockFormat::ProportionalHeight);
        format.setTopMargin(heading ? 16 : format.topMargin());
        format.setBottomMargin(8);
        cursor.setPosition(block.position());
        cursor.setBlockFormat(format);
    }
}

void GuidePage::fillContents() {
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level == 0) continue;
        contents_->addItem(QString(2 * (level - 1), ' ') + block.text(), block.blockNumber());
    }
}

QStringList GuidePage::contents() const {
    QStringList headings;
    for (int i = 0; i < contents_->count(); ++i) headings << contents_->itemText(i).trimmed();
    return headings;
}

void GuidePage::goTo(int block) {
    const QTextBlock wanted = text_->document()->findBlockByNumber(block);
    if (!wanted.isValid()) return;
    QTextCursor cursor(wanted);
    text_->setTextCursor(cursor);
    // A cursor that comes into sight stands at the foot; a heading belongs to the top.
    const int shift = text_->cursorRect(cursor).top();
    text_->verticalScrollBar()->setValue(text_->verticalScrollBar()->value() + shift - 8);
}

void GuidePage::follow(const QUrl& link) {
    if (link.hasFragment() && link.path().isEmpty()) return goToAnchor(link.fragment());
    for (const char* page : {"guide", "tutorial"})
        if (fileNames(page).contains(link.path())) return emit pageWanted(page, link.fragment());
    const QString place = pageFile(page_);
    if (link.isRelative() && !place.isEmpty())
        QDesktopServices::openUrl(QUrl::fromLocalFile(QFileInfo(place).path() + "/" + link.path()));
    else if (!link.isRelative())
        QDesktopServices::openUrl(link);
}

void GuidePage::goToAnchor(const QString& anchor) {
    for (int i = 0; i < contents_->count(); ++i)
        if (anchorOf(contents_->itemText(i).trimmed()) == anchor) return goTo(contents_->itemData(i).toInt());
    text_->verticalScrollBar()->setValue(0);
}

void GuidePage::search(bool backwards) {
    const auto how = backwards ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    if (search_->text().isEmpty() || text_->find(search_->text(), how)) return;
    // Once round.
    QTextCursor cursor = text_->textCursor();
    cursor.movePosition(backwards ? QTextCursor::End : QTextCursor::Start);
    text_->setTextCursor(cursor);
    const bool found = text_->find(search_->text(), how);
    search_->setProperty("problem", !found);
    search_->setStyleSheet(search_->styleSheet());
}

}  // namespace vestige
