#include "language/completer.h"

#include <QKeyEvent>

#include <cctype>

namespace views {

Completer::Completer(SceneEditor& editor, SceneDocument& document)
    : editor_(editor), document_(document) {
    using Base = QsciScintillaBase;
    editor_.addTool(this);
    editor_.SendScintilla(Base::SCI_AUTOCSETSEPARATOR, 0x0AUL);
    editor_.SendScintilla(Base::SCI_AUTOCSETAUTOHIDE, 1UL);
    editor_.SendScintilla(Base::SCI_AUTOCSETDROPRESTOFWORD, 0UL);
    editor_.SendScintilla(Base::SCI_AUTOCSETORDER,
                          static_cast<unsigned long>(Base::SC_ORDER_CUSTOM));
    editor_.SendScintilla(Base::SCI_AUTOCSETMAXHEIGHT, 10UL);
    editor_.SendScintilla(Base::SCI_SETWORDCHARS,
                          "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
    connect(&editor_, &QsciScintillaBase::SCN_CHARADDED, this, &Completer::typed);
}

editing::Completion Completer::completion() const {
    return editing::completionAt(editor_.bytes(), editor_.structure(), editor_.caret(),
                                 *document_.shown().scene);
}

void Completer::typed(int character) {
    // A code point, which isalnum() takes only where it is a byte.
    const bool word =
        character >= 0 && character < 0x80 && (std::isalnum(character) != 0 || character == '_');
    const bool opens = character == '-' || character == '.';
    if (!word && !opens)
        return;
    // While the list is there, each letter leaves fewer in it.
    const auto begins = static_cast<std::size_t>(
        editor_.SendScintilla(QsciScintillaBase::SCI_WORDSTARTPOSITION, editor_.caret(), 1L));
    if (!opens && !editor_.isListActive() && editor_.caret() < begins + 2)
        return;
    const editing::Completion found = completion();
    if (!found.words.empty())
        show(found);
    else
        editor_.cancelList();
}

void Completer::ask() {
    const editing::Completion found = completion();
    if (!found.words.empty())
        show(found);
    else if (!found.hint.empty() && editor_.isOnScreen(editor_.caret()))
        editor_.SendScintilla(QsciScintillaBase::SCI_CALLTIPSHOW, editor_.caret(),
                              found.hint.c_str());
}

void Completer::show(const editing::Completion& completion) {
    const std::size_t caret = editor_.caret();
    if (!editor_.isOnScreen(completion.from) || !editor_.isOnScreen(caret))
        return;
    std::string words;
    if (completion.whole)
        words = editor_.bytes().substr(completion.from, caret - completion.from);
    for (const std::string& word : completion.words)
        words += (words.empty() ? "" : "\n") + word;
    editor_.SendScintilla(QsciScintillaBase::SCI_AUTOCSHOW, caret - completion.from, words.c_str());
}

std::string Completer::chosen() const {
    const long size = editor_.SendScintilla(QsciScintillaBase::SCI_AUTOCGETCURRENTTEXT);
    std::string word(static_cast<std::size_t>(size) + 1, '\0');
    editor_.SendScintilla(QsciScintillaBase::SCI_AUTOCGETCURRENTTEXT, 0UL, word.data());
    word.pop_back();
    return word;
}

bool Completer::key(const QKeyEvent& event) {
    if ((event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter) || !editor_.isListActive())
        return false;
    const std::string word = chosen();
    const std::size_t caret = editor_.caret();
    if (caret >= word.size() &&
        editor_.bytes().compare(caret - word.size(), word.size(), word) == 0)
        editor_.cancelList();
    return false;
}

} // namespace views
