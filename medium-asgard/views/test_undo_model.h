// A model of a document, its steps of undo and the drafts in its language viewers: a plain string,
// a plain stack of strings, and two strings for each draft.
//
// It is told what viewers ask for, never what became of it: a test that compares it with the
// document has another's word for every byte.
#pragma once

#include "text/merge.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace views {

class UndoModel {
public:
    struct Draft {
        std::string base, text;
        [[nodiscard]] bool edited() const { return text != base; }
    };

    // A document that was opened with the one text and changed to the other.
    void begin(const std::string& opened, const std::string& text, int revision) {
        texts_ = {opened, text};
        at_ = 1;
        held_.reset();
        text_ = text;
        revision_ = revision;
        textAt_ = {{revision, text}};
        for (Draft& draft : drafts)
            draft = {text, text};
    }

    [[nodiscard]] const std::string& text() const { return text_; }
    [[nodiscard]] int revision() const { return revision_; }
    [[nodiscard]] const std::string& textAt(int revision) const { return textAt_.at(revision); }
    [[nodiscard]] bool canUndo() const { return at_ > 0; }
    [[nodiscard]] bool canRedo() const { return at_ + 1 < texts_.size(); }
    [[nodiscard]] const std::string& first() const { return texts_.front(); }
    [[nodiscard]] const std::string& last() const { return texts_.back(); }
    [[nodiscard]] long overtaken() const { return overtaken_; } // gestures that others ended

    // One step of undo.
    void change(const std::string& text) {
        if (text == text_)
            return;
        endGesture();
        become(text);
        addStep();
    }
    // A hand's gesture that began at that revision shows a text; the change by another's is a step
    // then.
    void preview(const std::string& text, int since, const void* hand) {
        const bool goesOn = held_ && held_->since == since && held_->hand == hand;
        if ((!goesOn && since != revision_) || text == text_)
            return;
        if (!goesOn) {
            endGesture();
            held_ = Held{since, hand};
        }
        become(text);
    }
    void finish(const std::string& text, int since, const void* hand) {
        if (!held_ && since == revision_)
            return change(text);
        if (!held_ || held_->since != since || held_->hand != hand)
            return void(++overtaken_); // the text was changed elsewhere: nothing more is taken
        held_.reset();
        if (text != text_)
            become(text);
        if (text != texts_[at_])
            addStep();
    }
    void endGesture() {
        if (held_)
            finish(text_, held_->since, held_->hand);
    }
    void undo() {
        endGesture();
        if (canUndo())
            become(texts_[--at_]);
    }
    void redo() {
        endGesture();
        if (canRedo())
            become(texts_[++at_]);
    }
    void submit(Draft& draft) {
        const std::string text = draft.text;
        draft.base = text;
        change(text);
    }

    std::vector<Draft> drafts;

private:
    void addStep() {
        texts_.resize(++at_);
        texts_.push_back(text_);
    }
    void become(const std::string& text) {
        text_ = text;
        textAt_[++revision_] = text;
        for (Draft& draft : drafts) {
            if (!draft.edited() || draft.text == text)
                draft.text = text;
            else
                draft.text =
                    text::applied(draft.text, text::merged(draft.base, draft.text, text).edits);
            draft.base = text;
        }
    }

    struct Held { // what is dragged has changed the text, and is no step yet
        int since;
        const void* hand;
    };
    std::optional<Held> held_;
    std::string text_;
    int revision_ = 0;
    long overtaken_ = 0;
    std::map<int, std::string> textAt_;
    std::vector<std::string> texts_; // all of the document's, undone ones too
    std::size_t at_ = 0;
};

} // namespace views
