#include "language/number_drag.h"

#include "editing/number_text.h"
#include "element_edits/options.h"
#include "language/scene_lexer.h"
#include "plain/plain.h"
#include "script/numbers.h"
#include "script/structure.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

using scene::Range;

namespace {

constexpr int pixelsPerStep = 2;

// One of Tcl's own, without a point, that something is counted by.
bool countsWhole(const std::string& text, const script::Structure& structure, Range number) {
    const script::Command* command = structure.at(number.from);
    if (!command ||
        text.substr(number.from, number.to - number.from).find_first_of(".eE") != std::string::npos)
        return false;
    constexpr std::string_view counts[] = {"for",    "while",  "if",     "incr",
                                           "lindex", "lrange", "string", "lrepeat"};
    if (std::ranges::find(counts, command->name(text)) != std::end(counts))
        return true;
    if (command->name(text) != "set" || command->parent < 0)
        return false;
    const script::Command& loop = structure.commands[static_cast<std::size_t>(command->parent)];
    return loop.name(text) == "for" && loop.words.size() > 1 && number.to <= loop.words[1].range.to;
}

// A tenth of the number's own size, or its last decimal; of whole quantities, one.
double stepOf(const std::string& text, const script::Structure& structure, Range number,
              double value) {
    if (const script::Command* command = structure.at(number.from))
        if (const editing::CommandHint* hint = editing::hintOf(command->name(text)))
            for (std::size_t i = 1; i + 1 < command->words.size(); ++i) {
                const Range word = command->words[i].range, next = command->words[i + 1].range;
                const editing::OptionHint* option = editing::hintOf(
                    *hint, std::string_view(text).substr(word.from, word.to - word.from));
                if (option && next.from <= number.from && number.to <= next.to &&
                    (option->wants == editing::Wants::integer ||
                     option->wants == editing::Wants::flag))
                    return 1;
            }
    if (countsWhole(text, structure, number))
        return 1;
    const double tenth =
        value == 0 ? 0.1 : std::pow(10, std::floor(std::log10(std::abs(value))) - 1);
    const std::size_t point = text.find('.', number.from);
    return point < number.to
               ? std::min(tenth, std::pow(10, -static_cast<double>(number.to - point - 1)))
               : tenth;
}

} // namespace

NumberDrag::NumberDrag(SceneEditor& editor, SceneDocument& document, Draft& draft)
    : editor_(editor), document_(document), draft_(draft) {
    editor_.addTool(this);
    connect(&draft_, &Draft::aboutToFollow, this, &NumberDrag::letGo);
}

std::optional<Range> NumberDrag::numberAt(std::size_t byte) const {
    const auto style =
        editor_.SendScintilla(QsciScintillaBase::SCI_GETSTYLEAT, static_cast<unsigned long>(byte));
    if (style == SceneLexer::comment || style == SceneLexer::hidden || style == SceneLexer::mark)
        return std::nullopt;
    return editing::numberAt(editor_.bytes(), byte);
}

bool NumberDrag::begin(Range number) {
    const std::string text = editor_.bytes();
    const std::string written = text.substr(number.from, number.to - number.from);
    const auto value = script::decimalNumber(written);
    if (!value)
        return false;
    gesture_ = std::make_unique<Gesture>();
    gesture_->text = text;
    gesture_->since = document_.revision();
    gesture_->number = number;
    gesture_->value = *value;
    gesture_->step = stepOf(text, editor_.structure(), number, *value);
    gesture_->now = written;
    gesture_->inDraft = draft_.edited();
    if (gesture_->inDraft)
        editor_.beginUndoAction();
    editor_.mark(Mark::number, number);
    return true;
}

std::optional<Asked> NumberDrag::asked() const {
    if (!gesture_)
        return std::nullopt;
    Asked asked{gesture_->since, {}};
    asked.answer.edits = {{{gesture_->number.from, gesture_->number.to}, gesture_->now}};
    return asked;
}

// In a draft what was counted stays; places in it are about to be others.
void NumberDrag::letGo() {
    if (!gesture_ || (!gesture_->inDraft && document_.mayGoOn(gesture_->since)))
        return;
    if (gesture_->inDraft)
        return finish();
    const QRect number = editor_.rectOf(gesture_->number.from);
    gesture_.reset();
    editor_.unmark(Mark::number);
    if (editor_.isVisible())
        QToolTip::showText(editor_.viewport()->mapToGlobal(number.bottomLeft()),
                           plain::ours(SceneDocument::overtaken()), editor_.viewport());
}

void NumberDrag::set(long steps) {
    Gesture& gesture = *gesture_;
    gesture.steps = steps;
    const Range number = gesture.number;
    const std::string written = gesture.text.substr(number.from, number.to - number.from);
    const double value = gesture.value + static_cast<double>(steps) * gesture.step;
    const std::string now =
        steps == 0 ? written : editing::numberText(value, gesture.step, written);
    if (now == gesture.now)
        return;
    const Range old = {number.from, number.from + gesture.now.size()};
    gesture.now = now;
    if (gesture.inDraft)
        editor_.replace(old, now);
    else
        document_.preview(gesture.text.substr(0, number.from) + now +
                              gesture.text.substr(number.to),
                          gesture.since, this);
    editor_.unmark(Mark::number);
    editor_.mark(Mark::number, {number.from, number.from + now.size()});
}

void NumberDrag::finish() {
    const auto gesture = std::exchange(gesture_, nullptr);
    if (!gesture)
        return;
    editor_.unmark(Mark::number);
    const Range number = gesture->number;
    if (gesture->inDraft)
        editor_.endUndoAction();
    else
        document_.finishPreview(gesture->text.substr(0, number.from) + gesture->now +
                                    gesture->text.substr(number.to),
                                tr("Change a Number"), gesture->since, this);
    editor_.select({number.from, number.from + gesture->now.size()});
}

void NumberDrag::cancel() {
    if (!gesture_)
        return;
    set(0);
    finish();
}

bool NumberDrag::count(int steps) {
    if (!gesture_) {
        const Range selected = editor_.selection();
        auto number = numberAt(editor_.caret());
        if (!number && selected.known())
            number = numberAt(selected.from);
        if (!number && editor_.caret() > 0)
            number = numberAt(editor_.caret() - 1);
        if (!number || !begin(*number))
            return false;
    }
    set(gesture_->steps + steps);
    return true;
}

// --- pointer -------------------------------------------------------------------------------

QRectF NumberDrag::gripOf(Range number) const {
    const QRect from = editor_.rectOf(number.from), to = editor_.rectOf(number.to);
    const double width = std::max(26.0, static_cast<double>(to.left() - from.left()) + 6);
    const double middle = (from.left() + to.left()) / 2.0;
    return {middle - width / 2, from.bottom() - 2.0, width, 11};
}

void NumberDrag::hover(const QPoint& position, bool alt) {
    auto number = hovered_ && gripOf(*hovered_).contains(position) ? hovered_ : std::nullopt;
    if (!number)
        if (const auto byte = editor_.byteAt(position))
            number = numberAt(*byte);
    const bool onGrip = number && (alt || gripOf(*number).contains(position));
    if (number != hovered_) {
        hovered_ = number;
        editor_.viewport()->update();
    }
    editor_.viewport()->setCursor(onGrip ? Qt::SizeHorCursor : Qt::IBeamCursor);
}

bool NumberDrag::pressed(const QMouseEvent& event) {
    if (event.button() != Qt::LeftButton)
        return gesture_ != nullptr;
    hover(event.pos(), (event.modifiers() & Qt::AltModifier) != 0);
    const bool wanted = hovered_ && ((event.modifiers() & Qt::AltModifier) != 0 ||
                                     gripOf(*hovered_).contains(event.pos()));
    if (!wanted)
        return false;
    finish(); // what keys began
    if (!begin(*hovered_))
        return false;
    gesture_->byPointer = true;
    gesture_->startX = event.pos().x();
    return true;
}

bool NumberDrag::moved(const QMouseEvent& event) {
    if (!gesture_ || !gesture_->byPointer) {
        if (event.buttons() == Qt::NoButton)
            hover(event.pos(), (event.modifiers() & Qt::AltModifier) != 0);
        return false;
    }
    const int factor = (event.modifiers() & Qt::ShiftModifier) != 0 ? 10 : 1;
    set(static_cast<long>(event.pos().x() - gesture_->startX) / pixelsPerStep * factor);
    return true;
}

bool NumberDrag::released(const QMouseEvent&) {
    if (!gesture_ || !gesture_->byPointer)
        return false;
    finish();
    return true;
}

void NumberDrag::left() {
    if (gesture_ && !gesture_->byPointer)
        finish();
    if (hovered_ && !gesture_) {
        hovered_.reset();
        editor_.viewport()->update();
    }
}

// --- keys ----------------------------------------------------------------------------------

bool NumberDrag::key(const QKeyEvent& event) {
    if (hovered_ && !gesture_) { // the grip would cover what is typed
        hovered_.reset();
        editor_.viewport()->update();
    }
    if (gesture_ && event.key() == Qt::Key_Escape) {
        cancel();
        return true;
    }
    const bool up = event.key() == Qt::Key_Up, down = event.key() == Qt::Key_Down;
    if ((event.modifiers() & Qt::AltModifier) == 0 || (!up && !down)) {
        if (gesture_ && event.key() != Qt::Key_Alt && event.key() != Qt::Key_Shift)
            finish();
        return false;
    }
    const int many = (event.modifiers() & Qt::ShiftModifier) != 0 ? 10 : 1;
    return count(up ? many : -many);
}

bool NumberDrag::keyReleased(const QKeyEvent& event) {
    if (!gesture_ || gesture_->byPointer || event.key() != Qt::Key_Alt)
        return false;
    finish();
    return true;
}

void NumberDrag::paint(QPainter& painter) {
    const auto number = gesture_ && gesture_->byPointer
                            ? std::optional<Range>({gesture_->number.from,
                                                    gesture_->number.from + gesture_->now.size()})
                            : hovered_;
    if (!number)
        return;
    const QRectF grip = gripOf(*number);
    const QPalette& p = editor_.palette();
    QColor paper = p.color(QPalette::Highlight);
    paper.setAlpha(gesture_ ? 255 : 215);
    painter.setPen(Qt::NoPen);
    painter.setBrush(paper);
    painter.drawRoundedRect(grip, 4, 4);
    painter.setBrush(p.color(QPalette::HighlightedText));
    const double y = grip.center().y();
    for (const double side : {-1.0, 1.0}) {
        const double x = grip.center().x() + side * 5;
        QPainterPath arrow;
        arrow.moveTo(x + side * 4, y);
        arrow.lineTo(x - side * 1, y - 3.5);
        arrow.lineTo(x - side * 1, y + 3.5);
        arrow.closeSubpath();
        painter.drawPath(arrow);
    }
}

} // namespace views
