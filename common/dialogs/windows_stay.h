// Keeps windows while a question is open.
//
// A question runs an event loop of its own inside a function of some window. If that window is
// deleted meanwhile, since its document or process has ended, the function goes on with nothing,
// and the question, which is its child, is deleted twice. So while one object of this class exists,
// a window that is to be deleted later (deleteLater(), WA_DeleteOnClose) waits until no question
// and no menu is open. The questions and menus of such a window are closed, as by Escape.
#pragma once

#include <QPointer>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

namespace dialogs {

class WindowsStay : public QObject {
    Q_OBJECT

public:
    WindowsStay(); // after the QApplication
    ~WindowsStay() override;

    bool eventFilter(QObject* of, QEvent* event) override;

private:
    [[nodiscard]] bool isQuestionOpen();
    void release();

    std::vector<QPointer<QWidget>> waiting_;
    QTimer timer_;
    // The level of event loops at which a question was asked: its own loop is above.
    std::optional<int> askedAt_;
};

} // namespace dialogs
