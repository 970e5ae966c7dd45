// The relation of a language viewer's text to the document's: the same, or a draft of its own.
//
// Typing makes a draft; the document has it only by submit(). Changes of other views come into the
// draft at once where the draft changed nothing; where both changed a place the draft's own words
// stay, marked as a conflict that the author settles one way or the other. So a draft is never
// lost, and holds back no one.
//
// Typing can be undone step by step whatever came in since: a step back is the draft as it was
// then, with what others have done since merged into it.
#pragma once

#include "language/scene_editor.h"
#include "text/difference.h"
#include "workbench/scene_document.h"

namespace views {

class Draft : public QObject {
    Q_OBJECT
public:
    Draft(SceneEditor& editor, SceneDocument& document);

    // It says something else than the document.
    [[nodiscard]] bool edited() const { return edited_; }
    [[nodiscard]] const QString& refusal() const { return refusal_; } // why a host did not take it
    // In the editor's text, at least a byte long.
    [[nodiscard]] std::vector<scene::Range> conflicts() const {
        return editor_.marks(Mark::conflict);
    }
    // Where it differs from the document's text, which comes first.
    [[nodiscard]] const std::vector<text::Hunk>& hunks() const { return hunks_; }
    // The document's text in the place of a conflict.
    [[nodiscard]] QString theirs(scene::Range conflict) const;

    void submit(); // it becomes everyone's text
    void drop();   // it becomes the document's text
    // Text typed in another process upon a text that the document had then.
    void restore(const std::string& base, const std::string& text);
    [[nodiscard]] const std::string& base() const { return base_; } // that it is a draft of
    // Of what was typed.
    [[nodiscard]] bool canUndo() const;
    [[nodiscard]] bool canRedo() const;
    void undo();
    void redo();
    void keepMine(scene::Range conflict);
    void keepAllMine();
    void takeTheirs(scene::Range conflict);

Q_SIGNALS:
    void aboutToFollow(); // the document's text is another, the editor's is not yet
    void changed();       // whether edited, its conflicts, or why it was refused
    void followed();      // the editor's text is the document's, or took something from it

private:
    // Text typed once, upon the document's text of then.
    struct Typed {
        std::string base, text;
    };
    void keepTyped();
    void bring(std::vector<Typed>& from, std::vector<Typed>& to);
    void showConflicts(const std::vector<text::Range>& conflicts);
    void forgetTyped();
    void typed();
    void follow();
    void refused(const QString& why);
    void take(const std::string& text);
    void merge();
    void markLines();
    [[nodiscard]] std::optional<text::Hunk> hunkAt(scene::Range range) const;

    SceneEditor& editor_;
    SceneDocument& document_;
    bool edited_ = false;
    bool taking_ = false; // the text changes because the document's did
    std::string base_;    // the document's text that the draft is a draft of
    std::vector<text::Hunk> hunks_;
    std::optional<std::string> submitted_; // until the host has accepted it
    std::string submittedOn_;              // the document's text that this was a draft of
    // The draft's text as typing went on after submit(), until the document's text came into it.
    // If the host refuses the submitted text, the document's text has lost it, but this has not.
    std::optional<std::string> goesOn_;
    std::string undisputed_; // base_ before conflicts came
    QString refusal_;
    // Older than what the editor can undo, the newest last; and what was undone of them.
    std::vector<Typed> past_, future_;
};

} // namespace views
