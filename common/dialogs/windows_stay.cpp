#include "dialogs/windows_stay.h"

#include <QApplication>
#include <QDialog>
#include <QEvent>
#include <QThread>

#include <algorithm>
#include <utility>

namespace dialogs {

namespace {

constexpr int pause = 20; // ms

bool isQuestion(const QWidget& widget) {
    return widget.isWindow() && (widget.isModal() || widget.windowType() == Qt::Popup);
}

bool isQuestionSeen() {
    return QApplication::activeModalWidget() != nullptr ||
           QApplication::activePopupWidget() != nullptr;
}

void closeQuestionsOf(const QWidget* window) {
    for (QWidget* question : {QApplication::activePopupWidget(), QApplication::activeModalWidget()})
        for (const QWidget* over = question; over != nullptr; over = over->parentWidget())
            if (over == window) {
                question->close();
                break;
            }
}

} // namespace

WindowsStay::WindowsStay() {
    timer_.setInterval(pause);
    connect(&timer_, &QTimer::timeout, this, &WindowsStay::release);
    qApp->installEventFilter(this);
}

WindowsStay::~WindowsStay() {
    for (const QPointer<QWidget>& window : waiting_)
        delete window;
}

// It may be closed, and its loop still run.
bool WindowsStay::isQuestionOpen() {
    if (askedAt_ && QThread::currentThread()->loopLevel() <= *askedAt_)
        askedAt_.reset();
    return askedAt_ || isQuestionSeen();
}

bool WindowsStay::eventFilter(QObject* of, QEvent* event) {
    if (!of->isWidgetType())
        return false;
    if (event->type() == QEvent::Show && isQuestion(*static_cast<QWidget*>(of))) {
        const int level = QThread::currentThread()->loopLevel();
        askedAt_ = std::min(askedAt_.value_or(level), level);
    }
    if (event->type() != QEvent::DeferredDelete)
        return false;
    auto* window = static_cast<QWidget*>(of);
    if (!window->isWindow() || qobject_cast<QDialog*>(window) != nullptr || !isQuestionOpen())
        return false;
    if (std::ranges::find(waiting_, window, &QPointer<QWidget>::data) == waiting_.end())
        waiting_.emplace_back(window);
    window->hide();
    closeQuestionsOf(window);
    timer_.start();
    return true;
}

void WindowsStay::release() {
    for (const QPointer<QWidget>& window : waiting_)
        closeQuestionsOf(window);
    if (isQuestionOpen())
        return;
    timer_.stop();
    for (const QPointer<QWidget>& window : std::exchange(waiting_, {}))
        delete window;
}

} // namespace dialogs
