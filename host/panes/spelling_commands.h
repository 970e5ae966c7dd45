// Commands about words that are not spelled right: the switch in the menu View, and the suggestions
// under the right button.
#pragma once

#include "view/spell_marks.h"

#include <QAction>

class QMenu;

namespace panes {

class SpellingCommands : public QObject {
    Q_OBJECT

public:
    // The view outlives what they do.
    SpellingCommands(view::DocumentView& view, QObject* parent);

    [[nodiscard]] QAction& toggle() { return *toggle_; }
    [[nodiscard]] const view::SpellMarks& marks() const { return marks_; }
    // Entries for the word at a place of the screen; none where it is right.
    void addTo(QMenu& menu, const QPoint& at);

Q_SIGNALS:
    void said(const QString& sentence);
    void languageChanged(const QString& name); // in which words are checked; "": they are not

private:
    [[nodiscard]] spelling::Dictionary dictionary() const;
    void followLanguage();
    void update();
    void replace(text::Range place, const QString& word);

    view::DocumentView& view_;
    view::SpellMarks marks_;
    QAction* toggle_;
    std::optional<QString> language_; // of the document, when it was asked last
};

} // namespace panes
