#include "language/elision.h"

#include "language/scene_lexer.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>
#include <utility>

namespace views {

using scene::Range;

namespace {

// About half a line (dissertation 4.2.1).
constexpr std::size_t halfLine = 40;

QString labelOf(const editing::PointList& list) {
    const int n = static_cast<int>(list.count);
    switch (list.what) {
    case editing::Listed::points:
        return n == 1 ? QObject::tr("1 point") : QObject::tr("%1 points").arg(n);
    case editing::Listed::curves:
        return n == 1 ? QObject::tr("1 curve") : QObject::tr("%1 curves").arg(n);
    case editing::Listed::faces:
        break;
    }
    return n == 1 ? QObject::tr("1 face") : QObject::tr("%1 faces").arg(n);
}

bool overlap(Range a, Range b) { return a.from < b.to && b.from < a.to; }

QFont chipFont(const SceneEditor& editor) {
    QFont font = editor.font();
    font.setPointSizeF(editor.lexer()->defaultFont(SceneLexer::plain).pointSizeF() * 0.88);
    return font;
}

} // namespace

Elision::Elision(SceneEditor& editor) : editor_(editor) {
    editor_.addTool(this);
    static_cast<SceneLexer*>(editor_.lexer())->setHidden([this] {
        std::vector<SceneLexer::Hidden> all;
        for (const Chip& chip : chips_)
            all.push_back({chip.range.from, chip.marked, chip.range.to});
        return all;
    });
    connect(&editor_, &QsciScintilla::textChanged, this, &Elision::changed);
    connect(&editor_, &QsciScintillaBase::SCN_UPDATEUI, this, &Elision::jump);
}

std::vector<editing::PointList> Elision::lists() const {
    return editing::pointListsOf(editor_.bytes(), editor_.structure(), halfLine);
}

void Elision::refresh() {
    const Range selected = editor_.selection();
    const auto opened = editor_.marks(Mark::opened);
    for (const editing::PointList& list : lists()) {
        const bool inUse =
            editor_.hasFocus() && list.range.from < selected.to && selected.from < list.range.to;
        const bool wasOpened =
            std::ranges::any_of(opened, [&](Range range) { return overlap(range, list.range); });
        if (!inUse && !wasOpened)
            editor_.mark(Mark::elided, list.range);
    }
    changed();
}

bool Elision::toggle(std::size_t byte) {
    for (const editing::PointList& list : lists()) {
        if (byte < list.range.from || byte > list.range.to)
            continue;
        if (editor_.isMarked(Mark::elided, list.range.from))
            open(list.range);
        else
            hide(list.range);
        return true;
    }
    return false;
}

void Elision::hide(Range range) {
    editor_.unmark(Mark::opened, range);
    editor_.mark(Mark::elided, range);
    const Range selected = editor_.selection();
    if (selected.from < range.to && range.from < selected.to)
        editor_.SendScintilla(QsciScintillaBase::SCI_SETEMPTYSELECTION, range.to);
    changed();
}

void Elision::open(Range range) {
    editor_.unmark(Mark::elided, range);
    editor_.mark(Mark::opened, range);
    changed();
}

void Elision::openAll() {
    for (const Range& range : hidden()) {
        editor_.unmark(Mark::elided, range);
        editor_.mark(Mark::opened, range);
    }
    changed();
}

void Elision::hideAll() {
    editor_.unmark(Mark::opened);
    for (const editing::PointList& list : lists())
        editor_.mark(Mark::elided, list.range);
    changed();
}

void Elision::reveal(Range range) {
    for (const Range& one : hidden())
        if (overlap(one, {range.from, std::max(range.to, range.from + 1)}))
            open(one);
}

void Elision::releaseSelected() {
    const Range selected = editor_.selection();
    bool any = false;
    for (const Range& one : hidden())
        if (overlap(one, selected)) {
            editor_.unmark(Mark::elided, one);
            any = true;
        }
    if (any)
        changed();
}

// What is hidden is a list still; the rest of the marks go.
void Elision::changed() {
    const bool none = hidden().empty() && chips_.empty();
    if (none)
        return;
    chips_.clear();
    const auto marked = hidden();
    const auto all = lists();
    editor_.unmark(Mark::elided);
    const QFontMetricsF chip(chipFont(editor_));
    const double column =
        std::max(1.0, QFontMetricsF(editor_.lexer()->defaultFont(SceneLexer::plain))
                          .horizontalAdvance(QLatin1Char('0')));
    const std::string& text = editor_.bytes();
    for (const editing::PointList& list : all) {
        if (std::ranges::none_of(marked, [&](Range range) { return overlap(range, list.range); }))
            continue;
        editor_.mark(Mark::elided, list.range);
        const QString label = labelOf(list);
        const auto room =
            static_cast<std::size_t>(std::ceil((chip.horizontalAdvance(label) + 26) / column));
        std::size_t end = std::min(list.range.to, list.range.from + room);
        end = std::min(end, text.find('\n', list.range.from));
        chips_.push_back({list.range, label, end});
    }
    editor_.SendScintilla(QsciScintillaBase::SCI_COLOURISE, 0UL, -1L);
    hideLines();
    editor_.viewport()->update();
}

// Lines that have nothing but hidden bytes; the first of a list has its mark.
void Elision::hideLines() {
    const auto lineEnd = [this](int line) {
        return static_cast<std::size_t>(editor_.SendScintilla(
            QsciScintillaBase::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line)));
    };
    if (linesHidden_)
        editor_.SendScintilla(QsciScintillaBase::SCI_SHOWLINES, 0UL,
                              static_cast<long>(editor_.lines() - 1));
    linesHidden_ = false;
    for (const Chip& chip : chips_) {
        const int first = editor_.lineOf(chip.range.from) + 1;
        int last = editor_.lineOf(chip.range.to);
        if (last >= first && lineEnd(last) > chip.range.to)
            --last; // something follows the list
        if (last < first)
            continue;
        editor_.SendScintilla(QsciScintillaBase::SCI_HIDELINES, static_cast<unsigned long>(first),
                              static_cast<long>(last));
        linesHidden_ = true;
    }
}

// The caret stands on either side of what is hidden, not in it.
void Elision::jump() {
    const std::size_t before = std::exchange(caret_, editor_.caret());
    for (const Chip& chip : chips_)
        if (chip.range.from < caret_ && caret_ < chip.range.to) {
            const bool empty = !editor_.selection().known();
            caret_ = before >= chip.range.to ? chip.range.from : chip.range.to;
            if (empty)
                editor_.SendScintilla(QsciScintillaBase::SCI_SETEMPTYSELECTION, caret_);
            else
                editor_.SendScintilla(QsciScintillaBase::SCI_SETCURRENTPOS, caret_);
        }
}

// --- pointer and keys ----------------------------------------------------------------------

QRectF Elision::rectOf(const Chip& chip) const {
    const QRect first = editor_.rectOf(chip.range.from);
    const double width = QFontMetricsF(chipFont(editor_)).horizontalAdvance(chip.label) + 22;
    return QRectF(first.left(), first.top(), width, first.height()).adjusted(1, 1.5, 0, -1.5);
}

const Elision::Chip* Elision::chipAt(const QPoint& position) const {
    for (const Chip& chip : chips_)
        if (rectOf(chip).contains(position))
            return &chip;
    return nullptr;
}

bool Elision::pressed(const QMouseEvent& event) {
    if (event.button() != Qt::RightButton)
        return false;
    if (const Chip* chip = chipAt(event.pos()))
        return toggle(chip->range.from);
    const auto byte = editor_.byteAt(event.pos());
    if (!byte || !editor_.isMarked(Mark::opened, *byte))
        return false;
    return toggle(*byte);
}

// What Ctrl and a key take out at once: a word, a part of the line, all of it.
void Elision::releaseAround(const QKeyEvent& event) {
    using Base = QsciScintillaBase;
    const bool back = event.key() == Qt::Key_Backspace, forth = event.key() == Qt::Key_Delete;
    const bool whole = event.key() == Qt::Key_L || event.key() == Qt::Key_T;
    if (chips_.empty() || (!back && !forth && !whole))
        return;
    const bool shift = (event.modifiers() & Qt::ShiftModifier) != 0;
    const std::size_t at = editor_.caret();
    const int line = editor_.lineOf(at);
    if (whole || shift) // the line before is part of what Ctrl+T exchanges
        editor_.SendScintilla(
            Base::SCI_SETSEL,
            editor_.SendScintilla(Base::SCI_POSITIONFROMLINE,
                                  static_cast<unsigned long>(std::max(0, line - 1))),
            editor_.SendScintilla(Base::SCI_GETLINEENDPOSITION, static_cast<unsigned long>(line)));
    else
        editor_.SendScintilla(back ? Base::SCI_WORDLEFTEXTEND : Base::SCI_WORDRIGHTEXTEND);
    releaseSelected();
    editor_.SendScintilla(Base::SCI_SETEMPTYSELECTION, at);
}

bool Elision::key(const QKeyEvent& event) {
    const bool back = event.key() == Qt::Key_Backspace, forth = event.key() == Qt::Key_Delete;
    if (editor_.selection().known()) {
        const bool breaks = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter ||
                            event.key() == Qt::Key_Tab;
        if (back || forth || breaks || (!event.text().isEmpty() && event.text().front().isPrint()))
            releaseSelected();
        return false;
    }
    if ((event.modifiers() & Qt::ControlModifier) != 0) {
        releaseAround(event);
        return false;
    }
    if (!back && !forth)
        return false;
    const std::size_t at = editor_.caret();
    for (const Chip& chip : chips_)
        if (at == (back ? chip.range.to : chip.range.from)) {
            editor_.SendScintilla(QsciScintillaBase::SCI_SETSEL, chip.range.from,
                                  static_cast<long>(chip.range.to));
            return true;
        }
    return false;
}

void Elision::paint(QPainter& painter) {
    const bool dark = editor_.isDark();
    const QColor paper = editor_.lexer()->defaultPaper(SceneLexer::mark);
    const QColor ink = dark ? QColor(0xD4, 0xCE, 0xF0) : QColor(0x44, 0x3C, 0x80);
    painter.setFont(chipFont(editor_));
    for (const Chip& chip : chips_) {
        const QRectF rect = rectOf(chip);
        if (!editor_.viewport()->rect().intersects(rect.toAlignedRect()))
            continue;
        // All of the room behind it is the text's paper again, so that the mark has round corners.
        const int line = editor_.lineOf(chip.range.from);
        const bool current = editor_.lineOf(editor_.caret()) == line;
        const int right = editor_.rectOf(chip.marked).left();
        const QColor behind = editor_.palette().color(QPalette::Base);
        painter.fillRect(QRectF(rect.left() - 1, rect.top() - 1.5,
                                std::max<double>(right - rect.left() + 1, rect.width() + 2),
                                rect.height() + 3),
                         current ? (dark ? behind.lighter(130) : behind.darker(103)) : behind);
        painter.setPen(QPen(dark ? paper.lighter(140) : paper.darker(115), 1));
        painter.setBrush(editor_.selection().from <= chip.range.from &&
                                 chip.range.to <= editor_.selection().to
                             ? (dark ? paper.lighter(150) : paper.darker(120))
                             : paper);
        painter.drawRoundedRect(rect.adjusted(0.5, 0.5, -0.5, -0.5), 5, 5);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ink);
        const QPointF c(rect.left() + 9, rect.center().y());
        QPainterPath arrow;
        arrow.moveTo(c + QPointF(-2.5, -4));
        arrow.lineTo(c + QPointF(3, 0));
        arrow.lineTo(c + QPointF(-2.5, 4));
        arrow.closeSubpath();
        painter.drawPath(arrow);
        painter.setPen(ink);
        painter.drawText(rect.adjusted(16, 0, -4, 0), Qt::AlignVCenter | Qt::AlignLeft, chip.label);
    }
}

QString Elision::tip(std::size_t byte) const {
    for (const Chip& chip : chips_)
        if (chip.range.from <= byte && byte < chip.range.to)
            return tr("%1, not shown. The right button or Ctrl+E shows them.").arg(chip.label);
    if (editor_.isMarked(Mark::opened, byte))
        return tr("The right button or Ctrl+E hides these points again.");
    return {};
}

} // namespace views
