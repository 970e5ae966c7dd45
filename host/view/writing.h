// A view in which the document is written: its caret, and what keys, input methods and the
// clipboard do at it, by the commands of module authoring.
#pragma once

#include "authoring/authoring.h"
#include "view/text_hand.h"

#include <QBasicTimer>
#include <QInputMethodEvent>

namespace view {

class Writing : public QObject {
    Q_OBJECT

public:
    // Both outlive it.
    Writing(DocumentView& view, TextHand& hand);

    // The caret is at the first text that is seen, where it was nowhere.
    void begin();
    void end();
    [[nodiscard]] bool isOn() const { return on_; }

    // Whether a key is for the text, before menus take it for a shortcut.
    [[nodiscard]] static bool isForText(const QKeyEvent& event);
    // False: it is not.
    bool useKey(const QKeyEvent& event);
    void cut();
    void paste(const QMimeData& data);
    void goBy(bool forward); // Tab, and Shift+Tab
    // A command at what is selected. refused() says why one is not allowed.
    using Command =
        std::function<authoring::Result(const authoring::Manuscript&, authoring::Selection)>;
    bool perform(const Command& command);

    // Why a command may not be where the selection is; "": it may.
    [[nodiscard]] QString whyNot(const Command& command) const;
    [[nodiscard]] bool isMarked(schemas::ContainerRole role) const;

    void compose(const QInputMethodEvent& event);
    [[nodiscard]] QVariant answer(Qt::InputMethodQuery query) const;

    // The caret, and over what follows it the text that an input method composes; in twips.
    void paint(QPainter& painter, std::size_t page) const;

Q_SIGNALS:
    void refused(const QString& why); // a sentence

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    [[nodiscard]] authoring::Manuscript manuscript() const;
    void type(const QString& text);
    void blink(); // from now on, shown first

    DocumentView& view_;
    TextHand& hand_;
    authoring::Grammars grammars_;
    bool on_ = false;
    bool isShown_ = true; // the caret
    QBasicTimer blinking_;
    QString composed_; // not typed yet
};

} // namespace view
