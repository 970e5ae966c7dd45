// A window whose document is written in, and what tests of writing ask of it.
#pragma once

#include "view/text_hand.h"
#include "view/writing.h"
#include "window/window_testing.h"

namespace writing {

using namespace window; // what tests of windows have

class WritingTest : public WindowTest {
protected:
    void write(const QByteArray& body) {
        window_ = open(memo(body));
        ASSERT_TRUE(waitFor([&] { return view().isLaidOut(); }));
        writeIn(*window_);
        ASSERT_TRUE(view().isWriting());
    }
    view::DocumentView& view() const { return window_->view(); }
    document::Document& document() const { return window_->document().document(); }
    const QWidget& asWidget() const { return view(); }
    QAction* action(const char* name) const { return window_->findChild<QAction*>(name); }
    void goTo(const std::string& words) const {
        const std::size_t at = document().bytes().find(words);
        view().text().cursor().set({at, at});
    }
    void press(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) const {
        QTest::keyClick(&view(), key, modifiers);
    }
    void type(const char* letters) const { QTest::keyClicks(&view(), letters); }
    std::string body() const {
        const std::string& bytes = document().bytes();
        const std::size_t from = bytes.find("<BODY>\n") + 7;
        return bytes.substr(from, bytes.find("</BODY>") - from);
    }
    // The text on the pages, line by line.
    std::string shown() const {
        std::string lines;
        for (const auto& page : view().pages().pages)
            for (const layout::Piece& piece : page->pieces)
                if (const auto* text = std::get_if<layout::TextPiece>(&piece))
                    lines += text->paragraph->textOfLine(text->line).toStdString() + "\n";
        return lines;
    }

    // `open` opens a dialog, and `act` gets it; false: none came.
    static bool answers(const std::function<void(QDialog&)>& act,
                        const std::function<void()>& open) {
        bool isAnswered = false;
        QTimer timer;
        QObject::connect(&timer, &QTimer::timeout, [&] {
            auto* dialog = qobject_cast<QDialog*>(QApplication::activeModalWidget());
            if (!dialog || std::exchange(isAnswered, true))
                return;
            act(*dialog);
        });
        timer.start(5);
        open();
        return isAnswered;
    }
    // Triggers an action that asks, and answers.
    void answering(const char* name, const std::function<void(QDialog&)>& act) const {
        EXPECT_TRUE(answers(act, [&] { action(name)->trigger(); })) << name;
    }

    DocumentWindow* window_ = nullptr;
};

} // namespace writing
