#include "tests/ui/shell/WindowDriver.h"

#include <QAction>
#include <QApplication>
#include <QLabel>
#include <QLineEdit>
#include <QTableView>
#include <QTest>

#include "ui/document/Document.h"
#include "ui/jobs/JobRunner.h"
#include "ui/view/SceneView.h"

namespace vestige::test {

WindowDriver::WindowDriver(std::unique_ptr<MainWindow> window) : window_(std::move(window)) {
    auto answers = std::make_unique<PreparedAnswers>();
    answers_ = answers.get();
    window_->setFileChooser(std::move(answers));
    window_->resize(1400, 875);
    window_->show();
    static_cast<void>(QTest::qWaitForWindowExposed(window_.get()));
}

WindowDriver::~WindowDriver() = default;

const SceneState& WindowDriver::scene() const {
    return window_->document().state();
}

bool WindowDriver::enabled(const char* id) const {
    return window_->findChild<QAction*>(id)->isEnabled();
}

bool WindowDriver::trigger(const char* id) {
    if (!enabled(id)) return false;
    window_->findChild<QAction*>(id)->trigger();
    QApplication::processEvents();
    return true;
}

QString WindowDriver::textOf(const char* id) const {
    return window_->findChild<QAction*>(id)->text().remove('&');
}

bool WindowDriver::settle(int seconds) {
    for (int i = 0; i < 50 * seconds && window_->jobs().busy(); ++i) QTest::qWait(20);
    QTest::qWait(20);
    return !window_->jobs().busy();
}

void WindowDriver::clickOn(const Eigen::Vector3d& world) {
    QWidget* widget = window_->view().widget();
    const auto shown = window_->view().camera().project(world);
    const QPoint at(static_cast<int>(shown->pixel.x()), static_cast<int>(shown->pixel.y()));
    QTest::mouseMove(widget, at);
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, at);
    QApplication::processEvents();
}

void WindowDriver::typeInto(int row, int column, const QString& text) {
    auto* table = window_->findChild<QTableView*>("measurements");
    const QRect cell = table->visualRect(table->model()->index(row, column));
    QTest::mouseClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
    QTest::mouseDClick(table->viewport(), Qt::LeftButton, Qt::NoModifier, cell.center());
    // An editor that has just handed over its text may not be gone yet.
    QLineEdit* editor = nullptr;
    for (auto* field : table->viewport()->findChildren<QLineEdit*>())
        if (field->isVisible()) editor = field;
    if (!editor) return;
    editor->selectAll();
    QTest::keyClicks(editor, text);
    QTest::keyClick(editor, Qt::Key_Return);
    QApplication::processEvents();
}

QString WindowDriver::label(const char* objectName) const {
    const auto* label = window_->findChild<QLabel*>(objectName);
    return label && label->isVisible() ? label->text() : QString();
}

}  // namespace vestige::test
