#include "source/document_mirror.h"

#include "source/letters.h"
#include "source/line_marks.h"
#include "source/shown_bytes.h"
#include "text/characters.h"
#include "text/difference.h"

#include <QScrollBar>
#include <QTextBlock>

#include <algorithm>
#include <chrono>

namespace source {

namespace {

std::chrono::milliseconds now() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::steady_clock::now().time_since_epoch());
}

// A mark of the byte order, which no line shows.
std::size_t firstByte(std::string_view bytes) {
    return bytes.starts_with(text::byteOrderMark) ? text::byteOrderMark.size() : 0;
}

// Of bytes from that place of the document on.
QString shownFrom(std::size_t place, std::string_view bytes) {
    return shown(bytes.substr(place == 0 ? firstByte(bytes) : 0));
}

} // namespace

DocumentMirror::DocumentMirror(document::Document& document, QPlainTextEdit& edit)
    : document_(document), edit_(edit) {
    edit_.setUndoRedoEnabled(false);
    timer_.setSingleShot(true);
    connect(&timer_, &QTimer::timeout, this, &DocumentMirror::fill);
    connect(&document_, &document::Document::edited, this,
            [this](const sgml::Change& change, const text::Edits& back) { follow(change, back); });
    // The widget's text must not change while it tells of a change: take() comes when it has.
    connect(edit_.document(), &QTextDocument::contentsChange, this,
            [this](int from, int removed, int added) {
                if (isOn_ && !isFollowing())
                    typed_ = Typed{from, removed, added};
            });
    connect(edit_.document(), &QTextDocument::contentsChanged, this, &DocumentMirror::take);
    const auto note = [this] {
        if (!isFollowing() && !typed_)
            selected_ = selection();
    };
    connect(&edit_, &QPlainTextEdit::cursorPositionChanged, this, note);
    connect(&edit_, &QPlainTextEdit::selectionChanged, this, note);
}

void DocumentMirror::start() {
    if (std::exchange(isOn_, true))
        return;
    filled_ = firstByte(document_.bytes());
    fill();
}

void DocumentMirror::stop() {
    timer_.stop();
    if (std::exchange(isOn_, false))
        change([this] { edit_.document()->clear(); });
}

bool DocumentMirror::isComplete() const { return isOn_ && !timer_.isActive(); }

// --- places ------------------------------------------------------------------------------------

// The document's lines are the text's blocks.
std::size_t DocumentMirror::lineStart(int line) const {
    const std::string& bytes = document_.bytes();
    std::size_t from = firstByte(bytes), to = bytes.size();
    while (from < to) {
        const std::size_t middle = from + (to - from) / 2;
        if (document_.tree().position(middle).line > line)
            to = middle;
        else
            from = middle + 1;
    }
    return from;
}

std::size_t DocumentMirror::offsetOf(int position) const {
    const QTextBlock block = edit_.document()->findBlock(position);
    if (!block.isValid())
        return document_.bytes().size();
    const std::size_t start = lineStart(block.blockNumber());
    const std::string_view rest = std::string_view(document_.bytes()).substr(start);
    return start + bytesOf(rest, position - block.position());
}

int DocumentMirror::positionOf(std::size_t offset) const {
    const std::string& bytes = document_.bytes();
    offset = std::clamp(offset, firstByte(bytes), bytes.size());
    if (offset > 0 && offset < bytes.size() && bytes[offset] == '\n' && bytes[offset - 1] == '\r')
        --offset;
    const int line = document_.tree().position(offset).line - 1;
    const QTextBlock block = edit_.document()->findBlockByNumber(line);
    if (!block.isValid())
        return edit_.document()->characterCount() - 1;
    std::size_t start = offset;
    while (start > firstByte(bytes) && bytes[start - 1] != '\n' && bytes[start - 1] != '\r')
        --start;
    const int letters = lettersIn(std::string_view(bytes).substr(start, offset - start));
    return std::min(block.position() + letters, block.position() + block.length() - 1);
}

document::Selection DocumentMirror::selection() const {
    const QTextCursor cursor = edit_.textCursor();
    const std::size_t caret = offsetOf(cursor.position());
    return {cursor.hasSelection() ? offsetOf(cursor.anchor()) : caret, caret};
}

void DocumentMirror::select(const document::Selection& selection) {
    ++following_;
    QTextCursor cursor(edit_.document());
    cursor.setPosition(positionOf(selection.anchor));
    cursor.setPosition(positionOf(selection.caret), QTextCursor::KeepAnchor);
    edit_.setTextCursor(cursor);
    --following_;
    selected_ = this->selection();
}

// --- the document's text comes in --------------------------------------------------------------

// The lines that are seen stay where they are.
void DocumentMirror::change(const std::function<void()>& how) {
    ++following_;
    QScrollBar* bar = edit_.verticalScrollBar();
    QTextCursor top = edit_.cursorForPosition({0, 0});
    top.movePosition(QTextCursor::StartOfBlock);
    const int below = bar->value() - top.block().firstLineNumber();
    how();
    bar->setValue(top.block().firstLineNumber() + below);
    --following_;
}

void DocumentMirror::fill() {
    const std::string& bytes = document_.bytes();
    const std::size_t from = filled_;
    filled_ = lineAfter(bytes, std::min(from + sliceBytes, bytes.size()));
    const bool isFirst = edit_.document()->isEmpty();
    ++following_;
    QTextCursor end(edit_.document());
    end.movePosition(QTextCursor::End);
    end.insertText(shown(std::string_view(bytes).substr(from, filled_ - from)));
    if (isFirst)
        edit_.moveCursor(QTextCursor::Start);
    --following_;
    ++slices_;
    if (filled_ < bytes.size()) {
        timer_.start(0);
        return;
    }
    if (wanted_)
        select(*std::exchange(wanted_, std::nullopt));
    Q_EMIT completed();
}

// From the line on that holds this byte.
void DocumentMirror::emptyFrom(std::size_t offset) {
    if (!wanted_)
        wanted_ = selected_;
    const QTextBlock block =
        edit_.document()->findBlockByNumber(document_.tree().position(offset).line - 1);
    filled_ = lineStart(block.blockNumber());
    change([&] {
        QTextCursor cursor(block);
        cursor.movePosition(QTextCursor::End, QTextCursor::KeepAnchor);
        cursor.removeSelectedText();
    });
    timer_.start(0);
}

// --- an edit of the document -------------------------------------------------------------------

// Each stretch stands in the text behind what is already as in the document, so the document's
// places say where.
void DocumentMirror::follow(const sgml::Change& change, const text::Edits& back) {
    if (!isOn_ || change.edits.empty() || std::exchange(isOwn_, false))
        return;
    const auto follows = [&](document::Selection& selection) {
        selection.anchor = text::moved(selection.anchor, change.edits, text::Gravity::behind);
        selection.caret = text::moved(selection.caret, change.edits, text::Gravity::behind);
    };
    follows(selected_);
    if (wanted_)
        follows(*wanted_);
    const std::vector<Stretch> stretches = stretchesOf(document_.bytes(), back);
    if (!isComplete()) {
        if (stretches.front().now.from < filled_)
            emptyFrom(stretches.front().now.from);
        return;
    }
    for (const Stretch& stretch : stretches) {
        if (stretch.now.size() + stretch.before.size() > sliceBytes)
            return emptyFrom(stretch.now.from);
        show(stretch);
    }
    selected_ = selection();
}

void DocumentMirror::show(const Stretch& stretch) {
    const std::string_view bytes = document_.bytes();
    replace(positionOf(stretch.now.from), shownFrom(stretch.now.from, stretch.before),
            shownFrom(stretch.now.from, bytes.substr(stretch.now.from, stretch.now.size())));
}

// Only the letters that differ: a caret beside them stays.
void DocumentMirror::replace(int from, const QString& letters, const QString& by) {
    const auto [here, there] = std::ranges::mismatch(letters, by);
    qsizetype same = here - letters.begin();
    if (same > 0 && letters[same - 1].isHighSurrogate())
        --same;
    qsizetype end = letters.size(), byEnd = by.size();
    while (end > same && byEnd > same && letters[end - 1] == by[byEnd - 1]) {
        --end;
        --byEnd;
    }
    if (end < letters.size() && letters[end].isLowSurrogate()) {
        ++end;
        ++byEnd;
    }
    if (end == same && byEnd == same)
        return;
    change([&] {
        QTextCursor cursor(edit_.document());
        cursor.setPosition(from + static_cast<int>(same));
        cursor.setPosition(from + static_cast<int>(end), QTextCursor::KeepAnchor);
        cursor.insertText(by.sliced(same, byEnd - same));
    });
}

// --- an edit of the text -----------------------------------------------------------------------

void DocumentMirror::take() {
    if (!typed_ || isFollowing())
        return;
    Typed letters = *std::exchange(typed_, std::nullopt);
    // Qt may count the end of the text as a letter.
    const int end = edit_.document()->characterCount() - 1;
    letters.added = std::min(letters.added, end - letters.from);
    const std::string_view bytes = document_.bytes();
    const std::size_t from = offsetOf(letters.from);
    const std::size_t to = from + bytesOf(bytes.substr(from), letters.removed);
    const std::string came = spelled(
        lettersOf(*edit_.document(), letters.from, letters.from + letters.added), lineEndOf(bytes));
    text::Edit edit = text::difference(bytes.substr(from, to - from), came);
    edit.range = {edit.range.from + from, edit.range.to + from};
    if (!edit.empty())
        enter(edit, letters, from + came.size());
    check({from, from + came.size()}, letters);
    selected_ = selection();
    Q_EMIT typed();
}

void DocumentMirror::enter(const text::Edit& edit, const Typed& letters, std::size_t caret) {
    document::EditNote note{.label = tr("Typing in the Source")};
    note.before = selected_;
    note.after = document::Selection{caret, caret};
    constexpr int oneLetter = 2; // beyond the first 65,536
    if (std::max(letters.added, letters.removed) <= oneLetter)
        note.typed = now();
    isOwn_ = true;
    document_.edit({edit}, note);
    isOwn_ = false;
}

// Bytes without a picture, and line ends that have met, become letters as they are read.
void DocumentMirror::check(text::Range came, const Typed& letters) {
    const std::string_view bytes = document_.bytes();
    const text::Range around = stretchesOf(bytes, {{came, {}}}).front().now;
    const int behind = lettersIn(bytes.substr(came.to, around.to - came.to));
    const int from = positionOf(around.from), end = edit_.document()->characterCount() - 1;
    replace(
        from,
        lettersOf(*edit_.document(), from, std::min(letters.from + letters.added + behind, end)),
        shownFrom(around.from, bytes.substr(around.from, around.size())));
}

} // namespace source
