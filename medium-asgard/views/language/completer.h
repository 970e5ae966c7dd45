// Completion while one writes: commands, options and names in a list below the caret, and what a
// value is to be (element_edits/completion.h).
//
// The list comes by itself after two letters of a word, after "-" and after "."; Ctrl+Space asks
// for it anywhere. Return and Tab take the chosen word, Escape closes the list. A word that is
// typed in full stands first in the list: Return leaves it and makes a new line.
#pragma once

#include "element_edits/completion.h"
#include "language/scene_editor.h"
#include "workbench/scene_document.h"

namespace views {

class Completer : public QObject, public EditorTool {
    Q_OBJECT
public:
    Completer(SceneEditor& editor, SceneDocument& document);

    void ask(); // shows what there is, a hint at least
    [[nodiscard]] editing::Completion completion() const;
    bool key(const QKeyEvent& event) override;

private:
    void typed(int character);
    void show(const editing::Completion& completion);
    [[nodiscard]] std::string chosen() const; // in the list

    SceneEditor& editor_;
    SceneDocument& document_;
};

} // namespace views
