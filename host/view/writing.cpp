#include "view/writing.h"

#include "authoring/table_nodes.h"
#include "manuscript/gaps.h"
#include "manuscript/places.h"
#include "view/document_view.h"
#include "view/folds.h"
#include "view/gap_caret.h"
#include "view/hints.h"
#include "view/resizing.h"

#include <QApplication>
#include <QMimeData>
#include <chrono>

namespace view {

namespace {

std::chrono::milliseconds now() {
    return std::chrono::duration_cast<std::chrono::milliseconds>(
        std::chrono::steady_clock::now().time_since_epoch());
}

bool isPrintable(const QKeyEvent& event) {
    const QString text = event.text();
    constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    const bool isCommand = (event.modifiers() & commands) != Qt::NoModifier;
    return !isCommand && !text.isEmpty() && (text[0].isPrint() || text[0].isHighSurrogate());
}

bool isReturn(int key) { return key == Qt::Key_Return || key == Qt::Key_Enter; }

// One of the keys of text; those of the clipboard are commands.
bool isEditing(int key) {
    return key == Qt::Key_Backspace || key == Qt::Key_Delete || isReturn(key);
}

bool isMoving(int key) { return (key >= Qt::Key_Home && key <= Qt::Key_PageDown); }

} // namespace

Writing::Writing(DocumentView& view, TextHand& hand)
    : view_(view), hand_(hand), grammars_(view.document().schemas()), composing_(*this, hand),
      gestures_(view), figure_(view), changed_(view.document().document()) {
    connect(&hand_.cursor(), &TextCursor::changed, this, [this] {
        next_ = schemas::ContainerRole::none;
        if (on_)
            blink();
        gestures_.selectionChanged();
    });
    connect(&view_, &DocumentView::laidOut, this, [this] {
        if (!std::exchange(wantsCaret_, wantsCaret_ && !view_.isLaidOut()))
            return;
        hand_.showCaret();
    });
    connect(&view_, &DocumentView::chosenChanged, this, [this] { gestures_.selectionChanged(); });
    // In the view that has the keys; other views of the document keep their places.
    connect(&view_.document().document(), &document::Document::selectionRestored, this,
            [this](const document::Selection& selection) {
                if (on_ && view_.isActiveWindow())
                    goBack(selection);
            });
}

// The selection may be far from what was changed, as where a figure was resized.
void Writing::goBack(const document::Selection& selection) {
    hand_.cursor().set(selection);
    view_.settle();
    if (changed_.holds(selection.caret))
        hand_.showCaret();
    else
        hand_.showPlace(changed_.from());
}

authoring::Manuscript Writing::manuscript() const {
    return {view_.document().document(), grammars_};
}

std::optional<authoring::Selection> Writing::selection() const {
    return hand_.cursor().selection();
}

std::optional<authoring::Selection> Writing::place() const {
    return view_.chosen() ? figure_.behind() : selection();
}

void Writing::begin() {
    on_ = true;
    if (!hand_.cursor().selection())
        hand_.moveIntoView();
    // In a view that shows figures alone no text is seen.
    if (const auto place = manuscript::place(manuscript(), 0, authoring::Direction::forward);
        place && !hand_.cursor().selection())
        hand_.cursor().set({*place, *place});
    blink();
}

void Writing::end() {
    on_ = false;
    composing_.clear();
    blinking_.stop();
    hand_.refresh();
}

// --- the caret ---------------------------------------------------------------------------------

// A desktop that wants nothing to blink, as for reduced motion, says a time of 0.
void Writing::blink() {
    isShown_ = true;
    const int period = QApplication::cursorFlashTime();
    if (period > 0)
        blinking_.start(period / 2, this);
    else
        blinking_.stop();
    hand_.refresh();
}

void Writing::timerEvent(QTimerEvent* event) {
    if (event->timerId() != blinking_.timerId())
        return QObject::timerEvent(event);
    isShown_ = !isShown_;
    if (const std::optional<QRectF> rect = hand_.caretRect())
        view_.viewport()->update(rect->toAlignedRect().adjusted(-2, -2, 3, 2));
}

void Writing::paint(QPainter& painter, std::size_t page) const {
    if (on_)
        paintHints(painter, view_, page);
    if (!on_ || view_.chosen() || !view_.hasFocus())
        return;
    const QColor paper = view_.pages().paper;
    const QColor ink = paper.lightness() < 128 ? Qt::white : Qt::black;
    const double pixel = 1 / painter.transform().m11();
    constexpr double width = 1.6;
    if (const std::optional<GapPlace> gap = gapOfCaret(view_)) {
        if (gap->page == page && isShown_)
            painter.fillRect(gap->caret().adjusted(0, 0, 0, pixel * width), ink);
        return;
    }
    const places::Carets carets(view_.pages(), view_.document().document().tree());
    const std::optional<places::Caret> caret = hand_.cursor().caret(carets);
    if (!caret || caret->page != page)
        return;
    const auto rect = composing_.paint(painter, carets.rectOf(*caret), ink, paper);
    if (!isShown_ || !rect)
        return;
    painter.fillRect(
        QRectF(rect->left() - pixel * width / 2, rect->top(), pixel * width, rect->height()), ink);
}

// --- commands ----------------------------------------------------------------------------------

bool Writing::perform(const Command& command, const QString& group) {
    if (!apply(command, place(), group))
        return false;
    view_.choose(document::noSubdocument);
    hand_.showCaret();
    wantsCaret_ = !view_.isLaidOut();
    blink();
    return true;
}

bool Writing::change(const Command& command) {
    const bool done = apply(command, selection(), {});
    if (done)
        blink();
    return done;
}

bool Writing::apply(const Command& command, const std::optional<authoring::Selection>& at,
                    const QString& group) {
    if (!at) {
        Q_EMIT refused(tr("There is no caret in the text."));
        return false;
    }
    authoring::Result result = command(manuscript(), *at);
    if (const auto* refusal = std::get_if<authoring::Refusal>(&result)) {
        Q_EMIT refused(refusal->why);
        return false;
    }
    const auto& step = std::get<authoring::Step>(result);
    const document::Selection after{step.after.anchor, step.after.caret};
    // Nothing changes unseen: what is folded is seen first.
    if (view_.folds().opensBefore(
            step.edits, {std::min(at->anchor, at->caret), std::max(at->anchor, at->caret)})) {
        hand_.showCaret();
        Q_EMIT refused(tr("This would change text that was folded. It is unfolded now, and nothing "
                          "has changed: do it again to go on."));
        return false;
    }
    if (!step.edits.empty()) {
        document::EditNote note{.label = step.label, .group = group};
        note.before = *at;
        note.after = after;
        if (step.isTyping)
            note.typed = now();
        view_.document().document().edit(step.edits, note);
    }
    hand_.cursor().set(after);
    view_.settleSoon();
    return true;
}

namespace {

Writing::Command toggled(schemas::ContainerRole role) {
    return [role](const authoring::Manuscript& in, authoring::Selection at) -> authoring::Result {
        authoring::Result result = authoring::toggle(in, at, role);
        // Between words it is for what will be typed.
        if (std::holds_alternative<authoring::Refusal>(result) && at.isEmpty())
            if (auto typed = authoring::typeToggled(in, at, "x", role);
                std::holds_alternative<authoring::Step>(typed))
                return authoring::Step{.after = at};
        return result;
    };
}

} // namespace

QString Writing::whyNotToggled(schemas::ContainerRole role) const { return whyNot(toggled(role)); }

void Writing::toggle(schemas::ContainerRole role) {
    const bool wasNext = next_ == role;
    const std::size_t steps = view_.document().document().steps();
    if (perform(toggled(role)) && steps == view_.document().document().steps())
        next_ = wasNext ? schemas::ContainerRole::none : role;
}

QString Writing::whyUseless(const Command& command) const {
    return whyNot([&](const authoring::Manuscript& in, authoring::Selection at) {
        authoring::Result result = command(in, at);
        const auto* step = std::get_if<authoring::Step>(&result);
        if (step && step->edits.empty() && step->after == at)
            return authoring::Result(authoring::Refusal{tr("It is so already.")});
        return result;
    });
}

QString Writing::whyNot(const Command& command) const {
    const std::optional<authoring::Selection> at = place();
    if (!at)
        return tr("There is no caret in the text.");
    const authoring::Result result = command(manuscript(), *at);
    const auto* refusal = std::get_if<authoring::Refusal>(&result);
    return refusal ? refusal->why : QString();
}

bool Writing::isMarked(schemas::ContainerRole role) const {
    const std::optional<authoring::Selection> at = place();
    return at && authoring::isMarked(manuscript(), *at, role) != (next_ == role);
}

void Writing::takeBack() { view_.document().document().undo(); }

void Writing::type(const QString& text, const QString& group) {
    const std::string bytes = text.toStdString();
    const auto command = [&, role = next_](const authoring::Manuscript& in,
                                           authoring::Selection at) {
        return role == schemas::ContainerRole::none ? authoring::type(in, at, bytes)
                                                    : authoring::typeToggled(in, at, bytes, role);
    };
    if (perform(command, group) && makesSigns_ && text.size() == 1)
        makeSign();
}

// A step of its own: undo takes the sign back and leaves what was typed.
void Writing::makeSign() {
    const std::optional<authoring::Selection> at = selection();
    const auto sign = at ? authoring::signTyped(manuscript(), at->caret) : std::nullopt;
    if (sign)
        perform([&](const authoring::Manuscript&, authoring::Selection) { return *sign; });
}

void Writing::goTo(QPointF point) {
    if (const sgml::NodeId image = imageAt(view_, point); image != sgml::noNode)
        return selectImage(view_, image);
    if (hand_.isSelected(point))
        return;
    if (const std::optional<places::Caret> caret = hand_.caretAt(point))
        hand_.moveTo(*caret);
}

bool Writing::movesInTable(const QKeyEvent& event) const {
    const bool isArrow = event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down;
    return isArrow && event.modifiers() == Qt::AltModifier && selection() &&
           authoring::tableAround(manuscript(), *selection());
}

bool Writing::isForClipboard(const QKeyEvent& event) {
    return event.modifiers() == Qt::ShiftModifier &&
           (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Insert);
}

bool Writing::isForText(const QKeyEvent& event) {
    if (isForClipboard(event))
        return false;
    // Alt+Left; Ctrl+Return. With Ctrl the other keys are for words.
    const auto commands = Qt::AltModifier | Qt::MetaModifier |
                          (isReturn(event.key()) ? Qt::ControlModifier : Qt::NoModifier);
    const bool isCommand = event.modifiers() & commands;
    return isPrintable(event) || (!isCommand && (isEditing(event.key()) || isMoving(event.key())));
}

// If another window has taken the text with the caret, it goes on with the text that follows.
void Writing::settleCaret() {
    using authoring::Direction;
    const std::optional<authoring::Selection> at = selection();
    if (!at || !at->isEmpty() || manuscript::isGap(manuscript(), at->caret))
        return;
    const auto next = manuscript::place(manuscript(), at->caret, Direction::forward);
    if (next && next != at->caret &&
        manuscript::place(manuscript(), at->caret, Direction::backward) != at->caret)
        hand_.cursor().set({*next, *next});
}

// From the caption of a figure that has floated one comes to the page before, and learns why.
void Writing::breakLine(bool isWithinParagraph) {
    const auto page = [this] {
        const places::Carets carets(view_.pages(), view_.document().document().tree());
        const std::optional<places::Caret> caret = hand_.cursor().caret(carets);
        return caret ? caret->page : 0;
    };
    const std::size_t before = page();
    const bool isDone = perform([&](const authoring::Manuscript& in, authoring::Selection at) {
        return isWithinParagraph ? authoring::breakLine(in, at) : authoring::breakParagraph(in, at);
    });
    if (isDone && page() < before)
        Q_EMIT refused(tr("The figure had no room here and stands on the next page. The text "
                          "behind it fills this one."));
}

// A section that is folded there stays so.
void Writing::goBehindEnd() {
    const std::optional<authoring::Selection> at = selection();
    if (!at || !view_.isLaidOut())
        return;
    const std::size_t end = manuscript::everything(manuscript(), at->caret).caret;
    if (view_.folds().pages().hiding(end) == sgml::noNode &&
        whyNot(authoring::goBehindEnd).isEmpty())
        perform(authoring::goBehindEnd);
}

void Writing::pressBelow(QPointF point) {
    if (!on_ || view_.pages().pages.empty())
        return;
    const auto [page, on] = view_.pagePointAt(point);
    if (places::Carets(view_.pages(), view_.document().document().tree()).isBelowAll(page, on))
        goBehindEnd();
}

// An arrow that leads nowhere leads behind the document's end.
bool Writing::moveCaret(const QKeyEvent& event) {
    const std::optional<authoring::Selection> before = selection();
    if (!hand_.useKey(event.key(), event.modifiers(), true))
        return false;
    const std::optional<authoring::Selection> after = selection();
    constexpr auto others = Qt::ShiftModifier | Qt::ControlModifier;
    if (!before || !after || !before->isEmpty() || (event.modifiers() & others))
        return true;
    const bool isArrow = event.key() >= Qt::Key_Left && event.key() <= Qt::Key_Down;
    if (isArrow && enterGap(view_, event.key(), before->caret, after->caret)) {
        hand_.showCaret();
        return true;
    }
    if (after->caret != before->caret)
        return true;
    const bool isAside = event.key() == Qt::Key_Right || event.key() == Qt::Key_Left;
    if (event.key() == Qt::Key_Down ||
        (isAside && after->caret == manuscript::everything(manuscript(), after->caret).caret))
        goBehindEnd();
    return true;
}

bool Writing::useKey(const QKeyEvent& event) {
    using authoring::Direction, authoring::Unit;
    settleCaret();
    const Unit unit = event.modifiers() & Qt::ControlModifier ? Unit::word : Unit::character;
    const auto erase = [&](Direction direction) {
        perform([&](const authoring::Manuscript& in, authoring::Selection at) {
            return authoring::erase(in, at, direction, unit);
        });
    };
    if (isForClipboard(event))
        return true; // there was nothing to cut or paste
    constexpr auto others = Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier;
    if (!(event.modifiers() & others) && leaveGap(view_, event.key())) {
        const std::optional<authoring::Selection> at = selection();
        if (at && at->caret > manuscript::everything(manuscript(), at->caret).caret)
            goBehindEnd();
        hand_.showCaret();
        return true;
    }
    if (movesInTable(event)) {
        const bool isRow = event.key() == Qt::Key_Up || event.key() == Qt::Key_Down;
        const bool isBack = event.key() == Qt::Key_Up || event.key() == Qt::Key_Left;
        perform([&](const authoring::Manuscript& in, authoring::Selection at) {
            const Direction to = isBack ? Direction::backward : Direction::forward;
            return isRow ? authoring::moveRow(in, at, to) : authoring::moveColumn(in, at, to);
        });
        return true;
    }
    switch (event.key()) {
    case Qt::Key_Backspace:
        erase(Direction::backward);
        return true;
    case Qt::Key_Delete:
        erase(Direction::forward);
        return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
        if (!isForText(event))
            return false;
        if (!activateSelected())
            breakLine(event.modifiers() & Qt::ShiftModifier);
        return true;
    default:
        break;
    }
    if (moveCaret(event))
        return true;
    if (!isPrintable(event))
        return false;
    type(event.text());
    return true;
}

sgml::NodeId Writing::selectedAlone(schemas::Display display) const {
    const auto at = place();
    const sgml::Tree& tree = view_.document().document().tree();
    const authoring::Grammar* grammar = grammars_.of(view_.document().document().className());
    if (!at || grammar == nullptr)
        return sgml::noNode;
    const std::size_t first = std::min(at->anchor, at->caret),
                      last = std::max(at->anchor, at->caret);
    const sgml::NodeId node = tree.innermostAt(first);
    const bool isIt = node != sgml::noNode && tree.isElement(node) &&
                      grammar->of(tree.name(node)).display == display;
    return isIt && tree.node(node).range == text::Range{first, last} ? node : sgml::noNode;
}

// An element with a dialog of its own opens it.
bool Writing::activateSelected() {
    using schemas::Display;
    for (const Display as : {Display::formula, Display::value, Display::reference})
        if (const sgml::NodeId element = selectedAlone(as); element != sgml::noNode) {
            Q_EMIT view_.elementActivated(element, as);
            return true;
        }
    return false;
}

// In a table to the cell beside, in a form to the field; in a list the item into the one before or
// out of its list.
void Writing::goBy(bool forward) {
    perform([forward](const authoring::Manuscript& in, authoring::Selection at) {
        const auto side = forward ? authoring::Direction::forward : authoring::Direction::backward;
        for (const auto go : {authoring::goToCell, authoring::goToField})
            if (authoring::Result result = go(in, at, side);
                std::holds_alternative<authoring::Step>(result))
                return result;
        return forward ? authoring::indentItems(in, at) : authoring::outdentItems(in, at);
    });
}

// --- input methods -----------------------------------------------------------------------------

void Writing::compose(const QInputMethodEvent& event) {
    composing_.take(event);
    view_.viewport()->update();
}

QVariant Writing::answer(Qt::InputMethodQuery query) const {
    switch (query) {
    case Qt::ImEnabled:
        return on_ && !view_.chosen();
    case Qt::ImCursorRectangle:
        return hand_.caretRect().value_or(QRectF());
    case Qt::ImHints:
        return static_cast<int>(Qt::ImhMultiLine);
    case Qt::ImCurrentSelection: {
        const std::unique_ptr<QMimeData> copy = hand_.copied();
        return copy ? copy->text() : QString();
    }
    default:
        return composing_.answer(query);
    }
}

} // namespace view
