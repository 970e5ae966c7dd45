#include "language/draft.h"

#include "editing/lines.h"
#include "text/merge.h"

#include <algorithm>
#include <utility>

namespace views {

using scene::Range;

namespace {

constexpr int draftMarker = 2; // in the margin, at lines that the document does not have so

Range asScene(text::Range range) { return {range.from, range.to}; }

} // namespace

Draft::Draft(SceneEditor& editor, SceneDocument& document)
    : editor_(editor), document_(document), base_(document.text()) {
    editor_.setMarginType(1, QsciScintilla::SymbolMargin);
    editor_.setMarginWidth(1, 5);
    editor_.setMarginMarkerMask(1, 1 << draftMarker);
    editor_.markerDefine(QsciScintilla::FullRectangle, draftMarker);
    editor_.setMarkerBackgroundColor(QColor(0xE0, 0xA0, 0x30), draftMarker);
    connect(&editor_, &QsciScintilla::textChanged, this, &Draft::typed);
    connect(&document_, &SceneDocument::textChanged, this, &Draft::follow);
    connect(&document_, &SceneDocument::opened, this, [this] {
        edited_ = false;
        submitted_.reset();
        goesOn_.reset();
    });
    connect(&document_, &SceneDocument::changeAccepted, this, [this] {
        submitted_.reset();
        goesOn_.reset();
    });
    connect(&document_, &SceneDocument::changeRefused, this, &Draft::refused);
    take(document_.text());
}

// Replaces only what differs, so that cursor, scroll position and marks of the rest stay.
void Draft::take(const std::string& text) {
    const text::Edit edit = text::difference(editor_.bytes(), text);
    taking_ = true;
    if (!edit.empty())
        editor_.replace(asScene(edit.range), edit.text);
    editor_.SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    taking_ = false;
    editor_.setScrollWidth(1); // the longest line may be gone; it grows when it is drawn
    forgetTyped();
    base_ = text;
    edited_ = false;
    editor_.setEolMode(editing::lineBreakOf(text) == "\r\n" ? QsciScintilla::EolWindows
                                                            : QsciScintilla::EolUnix);
    editor_.unmark(Mark::conflict);
    markLines();
}

void Draft::typed() {
    if (taking_)
        return;
    future_.clear();
    goesOn_.reset();
    edited_ = editor_.bytes() != base_;
    if (!edited_)
        editor_.unmark(Mark::conflict);
    markLines();
    Q_EMIT changed();
}

void Draft::follow() {
    Q_EMIT aboutToFollow();
    if (!edited_ || editor_.bytes() == document_.text()) {
        take(document_.text());
        refusal_.clear();
    } else {
        if (submitted_)
            goesOn_ = editor_.bytes();
        merge();
    }
    Q_EMIT followed();
    Q_EMIT changed();
}

void Draft::merge() {
    keepTyped();
    if (conflicts().empty())
        undisputed_ = base_;
    const std::string mine = editor_.bytes();
    const text::Merge merge = text::merged(base_, mine, document_.text());
    taking_ = true;
    for (auto edit = merge.edits.rbegin(); edit != merge.edits.rend(); ++edit)
        editor_.replace(asScene(edit->range), edit->text);
    editor_.SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    taking_ = false;
    base_ = document_.text();
    if (base_ == undisputed_) // a gesture that was given up, a change that was undone
        editor_.unmark(Mark::conflict);
    else
        showConflicts(merge.conflicts);
    edited_ = editor_.bytes() != base_;
    markLines();
}

void Draft::showConflicts(const std::vector<text::Range>& conflicts) {
    for (const text::Range& conflict : conflicts) {
        // What the draft left out has no bytes of its own: then the byte beside it is marked.
        const std::size_t end = editor_.length();
        Range range = asScene(conflict);
        if (!range.known() && range.to < end)
            ++range.to;
        else if (!range.known() && range.from > 0)
            --range.from;
        editor_.mark(Mark::conflict, range);
    }
}

// --- what was typed --------------------------------------------------------------------------

// The editor's own steps would bring back what others replaced: they are kept as texts.
// LIMIT: of long typing the oldest steps are forgotten.
void Draft::keepTyped() {
    constexpr std::size_t most = 200;
    std::vector<Typed> steps, undone;
    const Range selection = editor_.selection();
    const std::size_t caret = editor_.caret();
    taking_ = true;
    while (editor_.isRedoAvailable()) {
        editor_.redo();
        undone.push_back({base_, editor_.bytes()});
    }
    for (std::size_t i = 0; i < undone.size(); ++i)
        editor_.undo();
    while (editor_.isUndoAvailable() && steps.size() < most) {
        editor_.undo();
        steps.push_back({base_, editor_.bytes()});
    }
    for (std::size_t i = 0; i < steps.size(); ++i)
        editor_.redo();
    taking_ = false;
    if (!steps.empty() || !undone.empty()) {
        const std::size_t anchor = caret == selection.from ? selection.to : selection.from;
        editor_.SendScintilla(QsciScintillaBase::SCI_SETSEL, anchor, static_cast<long>(caret));
    }
    past_.insert(past_.end(), steps.rbegin(), steps.rend());
    future_.insert(future_.end(), undone.rbegin(), undone.rend());
    if (past_.size() > most)
        past_.erase(past_.begin(), past_.end() - most);
}

void Draft::forgetTyped() {
    past_.clear();
    future_.clear();
}

bool Draft::canUndo() const { return edited_ && (editor_.isUndoAvailable() || !past_.empty()); }

bool Draft::canRedo() const { return editor_.isRedoAvailable() || !future_.empty(); }

void Draft::undo() {
    if (editor_.isUndoAvailable())
        editor_.undo();
    else
        bring(past_, future_);
}

void Draft::redo() {
    if (editor_.isRedoAvailable())
        editor_.redo();
    else
        bring(future_, past_);
}

void Draft::bring(std::vector<Typed>& from, std::vector<Typed>& to) {
    if (from.empty())
        return;
    keepTyped(); // what the editor could do again: it is emptied below
    const Typed step = std::move(from.back());
    from.pop_back();
    to.push_back({base_, editor_.bytes()});
    const text::Merge merge = text::merged(step.base, step.text, base_);
    const std::string text = text::applied(step.text, merge.edits);
    const text::Edit edit = text::difference(editor_.bytes(), text);
    taking_ = true;
    editor_.replace(asScene(edit.range), edit.text);
    editor_.SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    taking_ = false;
    editor_.unmark(Mark::conflict);
    edited_ = text != base_;
    if (edited_)
        showConflicts(merge.conflicts);
    markLines();
    Q_EMIT changed();
}

void Draft::submit() {
    const std::string text = editor_.bytes();
    edited_ = false;
    refusal_.clear();
    submitted_ = document_.hasHost() ? std::optional(text) : std::nullopt;
    submittedOn_ = base_;
    goesOn_.reset();
    base_ = text;
    editor_.unmark(Mark::conflict);
    document_.setText(text, tr("Edit Text"));
    take(document_.text());
    Q_EMIT followed();
    Q_EMIT changed();
}

void Draft::drop() {
    refusal_.clear();
    take(document_.text());
    Q_EMIT followed();
    Q_EMIT changed();
}

void Draft::restore(const std::string& base, const std::string& text) {
    take(text);
    base_ = base;
    merge();
    Q_EMIT followed();
    Q_EMIT changed();
}

void Draft::refused(const QString& why) {
    const auto submitted = std::exchange(submitted_, std::nullopt);
    const auto mine = goesOn_ ? std::exchange(goesOn_, std::nullopt) : submitted;
    if (!submitted || *mine == document_.text())
        return;
    take(*mine);
    base_ = submittedOn_;
    merge();
    edited_ = true;
    refusal_ = why;
    Q_EMIT changed();
}

// --- conflicts -----------------------------------------------------------------------------

// What differs there. Words that were left out beside it, but for blanks, belong to it: the draft
// has no bytes of theirs that could be in the range.
std::optional<text::Hunk> Draft::hunkAt(Range range) const {
    const std::string& mine = editor_.bytes();
    const auto blanksTo = [&](std::size_t from, std::size_t to) {
        return from >= to || mine.find_first_not_of(" \t", from) >= to;
    };
    std::optional<text::Hunk> found;
    for (const text::Hunk& hunk : hunks_) {
        const bool leftOut = hunk.after.empty();
        if (!(hunk.after.from <= range.to && range.from <= hunk.after.to) &&
            !(leftOut && blanksTo(range.to, hunk.after.from) &&
              blanksTo(hunk.after.to, range.from)))
            continue;
        if (!found)
            found = hunk;
        found->before.to = hunk.before.to;
        found->after.to = hunk.after.to;
    }
    return found;
}

QString Draft::theirs(Range conflict) const {
    const auto hunk = hunkAt(conflict);
    return hunk ? QString::fromStdString(base_.substr(hunk->before.from, hunk->before.size()))
                : QString();
}

void Draft::keepMine(Range conflict) {
    editor_.unmark(Mark::conflict, conflict);
    Q_EMIT changed();
}

void Draft::keepAllMine() {
    editor_.unmark(Mark::conflict);
    Q_EMIT changed();
}

void Draft::takeTheirs(Range conflict) {
    const auto hunk = hunkAt(conflict);
    editor_.unmark(Mark::conflict, conflict);
    if (hunk) {
        editor_.replace(asScene(hunk->after), base_.substr(hunk->before.from, hunk->before.size()));
        editor_.select({hunk->after.from, hunk->after.from + hunk->before.size()});
    }
    Q_EMIT changed();
}

void Draft::markLines() {
    editor_.markerDeleteAll(draftMarker);
    hunks_.clear();
    if (!edited_)
        return;
    hunks_ = text::differences(base_, editor_.bytes());
    for (const text::Hunk& hunk : hunks_) {
        const int last =
            editor_.lineOf(std::max(hunk.after.from, hunk.after.to - (hunk.after.empty() ? 0 : 1)));
        for (int line = editor_.lineOf(hunk.after.from); line <= last; ++line)
            editor_.markerAdd(line, draftMarker);
    }
}

} // namespace views
