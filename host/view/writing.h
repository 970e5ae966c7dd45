// A view in which the document is written: its caret, and what keys, input methods and the
// clipboard do at it, by the commands of module authoring.
#pragma once

#include "authoring/authoring.h"
#include "onpage/changed_place.h"
#include "view/chosen_figure.h"
#include "view/composing.h"
#include "view/gestures.h"
#include "view/text_hand.h"

#include <QBasicTimer>

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
    // Shift+Delete and Shift+Insert: those of the menu Edit.
    [[nodiscard]] static bool isForClipboard(const QKeyEvent& event);
    // False: it is not.
    bool useKey(const QKeyEvent& event);
    void cut();
    void cutAway(); // the same without a copy: another window has it
    // False: nothing of it came in.
    bool paste(const QMimeData& data);
    // At a place of the viewport; moved text goes from where it was, in the same step of undo.
    void drop(const QMimeData& data, QPointF at, std::optional<text::Range> moved);
    // If the document ends with a table or the like, a paragraph is made behind it, if the place
    // of the viewport is below it.
    void pressBelow(QPointF point);
    void goBy(bool forward); // Tab, and Shift+Tab
    // A command at its place, place(); the caret is in the text then, and no figure is chosen any
    // more. refused() says why one is not allowed.
    using Command =
        std::function<authoring::Result(const authoring::Manuscript&, authoring::Selection)>;
    bool perform(const Command& command) { return perform(command, {}); }
    // Of one group (document::EditNote::group): one step of undo.
    bool perform(const Command& command, const QString& group);
    void takeBack(); // the last step
    // Instead of what is selected.
    void type(const QString& text, const QString& group = {});
    // Emphasis and the like for what is selected, or the word at the caret; between words, for what
    // is typed next.
    void toggle(schemas::ContainerRole role);
    [[nodiscard]] QString whyNotToggled(schemas::ContainerRole role) const;
    // The same at what is selected. The view stays where it is, and a figure stays chosen.
    bool change(const Command& command);
    // The caret, or the image there, unless what is there is selected.
    void goTo(QPointF point);
    [[nodiscard]] bool movesInTable(const QKeyEvent& event) const; // rows and columns: Alt, arrows
    [[nodiscard]] Gestures& gestures() { return gestures_; }
    [[nodiscard]] ChosenFigure& chosenFigure() { return figure_; }

    // The arguments of commands: the document with its grammars, and the selection; nothing
    // where no caret is in the text.
    [[nodiscard]] authoring::Manuscript manuscript() const;
    [[nodiscard]] std::optional<authoring::Selection> selection() const;
    // The place at which commands act: behind the figure that is chosen, else at the selection.
    [[nodiscard]] std::optional<authoring::Selection> place() const;
    // Why a command may not be at its place; "": it may.
    [[nodiscard]] QString whyNot(const Command& command) const;
    // The same, or that it would change and move nothing there.
    [[nodiscard]] QString whyUseless(const Command& command) const;
    [[nodiscard]] bool isMarked(schemas::ContainerRole role) const;
    // The element with that display that is selected, and nothing else; noNode: none is.
    [[nodiscard]] sgml::NodeId selectedAlone(schemas::Display display) const;
    // Quotes and the like become typographic signs as they are typed (authoring::signTyped).
    void setMakesSigns(bool makes) { makesSigns_ = makes; }

    void compose(const QInputMethodEvent& event); // of an input method
    [[nodiscard]] QVariant answer(Qt::InputMethodQuery query) const;

    // The caret, and over what follows it the text that an input method composes; in twips.
    void paint(QPainter& painter, std::size_t page) const;

Q_SIGNALS:
    void refused(const QString& why); // a sentence

protected:
    void timerEvent(QTimerEvent* event) override;

private:
    bool paste(const QMimeData& data, const QString& group);
    bool activateSelected();
    [[nodiscard]] bool apply(const Command& command, const std::optional<authoring::Selection>& at,
                             const QString& group);
    void makeSign();
    void settleCaret();
    void goBehindEnd();
    bool moveCaret(const QKeyEvent& event);
    void breakLine(bool isWithinParagraph);
    void goBack(const document::Selection& selection);
    void blink(); // from now on, shown first

    DocumentView& view_;
    TextHand& hand_;
    authoring::Grammars grammars_;
    bool on_ = false;
    bool isShown_ = true; // the caret
    QBasicTimer blinking_;
    Composing composing_;
    bool makesSigns_ = true;
    bool wantsCaret_ = false; // to be seen, as soon as its page is there
    schemas::ContainerRole next_ = schemas::ContainerRole::none; // toggled for what is typed next
    Gestures gestures_;
    ChosenFigure figure_;
    ChangedPlace changed_;
};

} // namespace view
