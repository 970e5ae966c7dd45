#include "language/scene_editor.h"

#include "editing/number_text.h"
#include "frame/readable.h"
#include "language/scene_lexer.h"
#include "plain/plain.h"

#include <QGuiApplication>
#include <QHelpEvent>
#include <QInputMethodEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QResizeEvent>
#include <QToolTip>

#include <algorithm>

namespace views {

namespace {

using Base = QsciScintillaBase;

long signedByte(std::size_t byte) { return static_cast<long>(byte); }

} // namespace

SceneEditor::SceneEditor(QWidget* parent) : QsciScintilla(parent) {
    setUtf8(true);
    followChanges(); // before all others
    setEolMode(EolUnix);
    setLexer(new SceneLexer(this));
    setMarginType(0, NumberMargin);
    setMarginWidth(1, 0);
    SendScintilla(SCI_SETMARGINLEFT, 0UL, 6L);
    setTabWidth(4);
    setIndentationsUseTabs(false);
    setAutoIndent(true);
    setBraceMatching(SloppyBraceMatch);
    setCaretLineVisible(true);
    setCaretWidth(2);
    setAnnotationDisplay(AnnotationIndented);
    setScrollWidth(1);
    setScrollWidthTracking(true);
    setExtraAscent(1);
    setExtraDescent(1);
    setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    viewport()->setMouseTracking(true);
    SendScintilla(SCI_SETCARETSTICKY, 0UL);
    SendScintilla(SCI_STYLESETVISIBLE, static_cast<unsigned long>(SceneLexer::hidden), 0L);
    adaptToPalette();
}

// Scintilla scrolls, and asks for colours, between a change and the word that there was one: the
// text is asked for anew from before a change until that word.
void SceneEditor::followChanges() {
    connect(this, &QsciScintillaBase::SCN_MODIFIED, this, [this](int, int what) {
        changing_ = changing_ || (what & (SC_MOD_BEFOREINSERT | SC_MOD_BEFOREDELETE)) != 0;
    });
    connect(this, &QsciScintilla::textChanged, this, [this] {
        changing_ = false;
        bytes_.reset();
        structure_.reset();
    });
}

bool SceneEditor::isDark() const { return palette().color(QPalette::Base).lightness() < 128; }

void SceneEditor::adaptToPalette() {
    const QPalette& p = palette();
    const QColor base = p.color(QPalette::Base);
    const QColor caretLine = isDark() ? base.lighter(130) : base.darker(103);
    const QColor selected = isDark() ? QColor(0x1F, 0x3D, 0x5E) : QColor(0xC4, 0xDC, 0xF6);
    lexer()->setDefaultPaper(base);
    for (int style = SceneLexer::plain; style <= SceneLexer::mark; ++style) {
        QColor ink = lexer()->defaultColor(style);
        if (style != SceneLexer::mark) // which shows none of its letters
            for (const QColor& paper : {base, caretLine, selected})
                ink = readable(ink, paper);
        lexer()->setColor(ink, style);
        lexer()->setPaper(style == SceneLexer::mark ? lexer()->defaultPaper(style) : base, style);
    }
    setPaper(base);
    setCaretForegroundColor(p.color(QPalette::Text));
    setCaretLineBackgroundColor(caretLine);
    setSelectionBackgroundColor(selected);
    resetSelectionForegroundColor();
    setMarginsBackgroundColor(p.color(QPalette::Window));
    setMarginsFont(lexer()->defaultFont(SceneLexer::plain));
    setMarginsForegroundColor(readable(
        isDark() ? QColor(0x80, 0x86, 0x8C) : QColor(0x90, 0x96, 0x9C), p.color(QPalette::Window)));
    setMatchedBraceBackgroundColor(isDark() ? QColor(0x40, 0x58, 0x70) : QColor(0xD5, 0xE6, 0xF7));
    setMatchedBraceForegroundColor(p.color(QPalette::Text));
    defineMarks();
}

void SceneEditor::defineMarks() {
    const auto define = [this](Mark kind, IndicatorStyle style, const QColor& color, int inside,
                               int outline) {
        const int id = static_cast<int>(kind);
        indicatorDefine(style, id);
        setIndicatorForegroundColor(color, id);
        setIndicatorDrawUnder(true, id);
        SendScintilla(SCI_INDICSETALPHA, static_cast<unsigned long>(id), static_cast<long>(inside));
        SendScintilla(SCI_INDICSETOUTLINEALPHA, static_cast<unsigned long>(id),
                      static_cast<long>(outline));
    };
    const bool dark = isDark();
    define(Mark::error, SquiggleIndicator, QColor(0xD0, 0x20, 0x20), 255, 255);
    define(Mark::warning, SquiggleIndicator, QColor(0xC0, 0x80, 0x00), 255, 255);
    define(Mark::argument, RoundBoxIndicator, QColor(0x50, 0x90, 0xE0), dark ? 70 : 44,
           dark ? 150 : 110);
    SendScintilla(SCI_INDICSETFLAGS, static_cast<unsigned long>(Mark::argument),
                  static_cast<long>(SC_INDICFLAG_VALUEBEFORE));
    define(Mark::elided, HiddenIndicator, QColor(), 0, 0);
    define(Mark::opened, FullBoxIndicator,
           dark ? QColor(0x8A, 0x80, 0xC8) : QColor(0x7A, 0x70, 0xC8), dark ? 60 : 34,
           dark ? 60 : 34);
    define(Mark::conflict, RoundBoxIndicator, QColor(0xE0, 0x90, 0x00), 70, 200);
    define(Mark::found, RoundBoxIndicator, QColor(0xE0, 0xB8, 0x00), dark ? 70 : 90, 160);
    define(Mark::number, RoundBoxIndicator, palette().color(QPalette::Highlight), 50, 200);
}

std::size_t SceneEditor::length() const {
    return static_cast<std::size_t>(SendScintilla(SCI_GETLENGTH));
}

const std::string& SceneEditor::bytes() const {
    if (!bytes_ || changing_) {
        std::string& text = bytes_.emplace(length() + 1, '\0');
        SendScintilla(SCI_GETTEXT, text.size(), text.data());
        text.pop_back();
    }
    return *bytes_;
}

const script::Structure& SceneEditor::structure() const {
    if (!structure_ || changing_)
        structure_ = script::structureOf(bytes());
    return *structure_;
}

void SceneEditor::replace(scene::Range range, std::string_view text) {
    SendScintilla(SCI_SETTARGETRANGE, range.from, signedByte(range.to));
    SendScintilla(SCI_REPLACETARGET, text.size(), text.data());
}

std::size_t SceneEditor::caret() const {
    return static_cast<std::size_t>(SendScintilla(SCI_GETCURRENTPOS));
}

scene::Range SceneEditor::selection() const {
    return {static_cast<std::size_t>(SendScintilla(SCI_GETSELECTIONSTART)),
            static_cast<std::size_t>(SendScintilla(SCI_GETSELECTIONEND))};
}

void SceneEditor::select(scene::Range range) {
    SendScintilla(SCI_SETSEL, range.from, signedByte(range.to));
    ensureCursorVisible();
}

void SceneEditor::reveal(scene::Range range) {
    const long left = SendScintilla(SCI_GETXOFFSET);
    SendScintilla(SCI_SCROLLRANGE, range.to, signedByte(range.from));
    SendScintilla(SCI_SETXOFFSET, static_cast<unsigned long>(left));
    const auto line = static_cast<unsigned long>(lineOf(range.from));
    const long place = SendScintilla(SCI_VISIBLEFROMDOCLINE, line);
    const long notes = SendScintilla(SCI_ANNOTATIONGETLINES, line);
    const long top = place + 1 + notes - SendScintilla(SCI_LINESONSCREEN);
    if (notes > 0 && top > SendScintilla(SCI_GETFIRSTVISIBLELINE))
        SendScintilla(SCI_SETFIRSTVISIBLELINE, std::min(top, place));
}

int SceneEditor::lineOf(std::size_t byte) const {
    return static_cast<int>(SendScintilla(SCI_LINEFROMPOSITION, byte));
}

QString SceneEditor::word(scene::Range range) const {
    const std::string& all = bytes();
    return range.from < all.size()
               ? QString::fromStdString(all.substr(range.from, range.to - range.from))
               : QString();
}

// --- marks ---------------------------------------------------------------------------------

void SceneEditor::mark(Mark kind, scene::Range range, int value) {
    if (!range.known())
        return;
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<int>(kind));
    SendScintilla(SCI_SETINDICATORVALUE, value);
    SendScintilla(SCI_INDICATORFILLRANGE, range.from, signedByte(range.to - range.from));
}

void SceneEditor::unmark(Mark kind, scene::Range range) {
    SendScintilla(SCI_SETINDICATORCURRENT, static_cast<int>(kind));
    SendScintilla(SCI_INDICATORCLEARRANGE, range.from, signedByte(range.to - range.from));
}

void SceneEditor::unmark(Mark kind) { unmark(kind, {0, length()}); }

bool SceneEditor::isMarked(Mark kind, std::size_t byte) const {
    return SendScintilla(SCI_INDICATORVALUEAT, static_cast<unsigned long>(kind),
                         signedByte(byte)) != 0;
}

std::optional<scene::Range> SceneEditor::markAt(Mark kind, std::size_t byte) const {
    if (!isMarked(kind, byte))
        return std::nullopt;
    const auto id = static_cast<unsigned long>(kind);
    return scene::Range{
        static_cast<std::size_t>(SendScintilla(SCI_INDICATORSTART, id, signedByte(byte))),
        static_cast<std::size_t>(SendScintilla(SCI_INDICATOREND, id, signedByte(byte)))};
}

std::vector<scene::Range> SceneEditor::marks(Mark kind) const {
    std::vector<scene::Range> found;
    const auto id = static_cast<unsigned long>(kind);
    for (std::size_t at = 0; at < length();) {
        const auto end =
            static_cast<std::size_t>(SendScintilla(SCI_INDICATOREND, id, signedByte(at)));
        if (isMarked(kind, at))
            found.push_back({at, end});
        if (end <= at) // nothing is marked at all
            break;
        at = end;
    }
    return found;
}

// --- places on the screen ------------------------------------------------------------------

QRect SceneEditor::rectOf(std::size_t byte) const {
    const auto line = static_cast<unsigned long>(lineOf(byte));
    return {static_cast<int>(SendScintilla(SCI_POINTXFROMPOSITION, 0UL, signedByte(byte))),
            static_cast<int>(SendScintilla(SCI_POINTYFROMPOSITION, 0UL, signedByte(byte))), 1,
            static_cast<int>(SendScintilla(SCI_TEXTHEIGHT, line))};
}

bool SceneEditor::isOnScreen(std::size_t byte) const {
    return QGuiApplication::screenAt(viewport()->mapToGlobal(rectOf(byte).topLeft())) != nullptr;
}

std::optional<std::size_t> SceneEditor::byteAt(const QPoint& position) const {
    const long byte =
        SendScintilla(SCI_CHARPOSITIONFROMPOINTCLOSE, static_cast<unsigned long>(position.x()),
                      static_cast<long>(position.y()));
    if (byte < 0)
        return std::nullopt;
    return static_cast<std::size_t>(byte);
}

// --- events --------------------------------------------------------------------------------

void SceneEditor::mousePressEvent(QMouseEvent* event) {
    taken_ = std::ranges::any_of(tools_, [&](EditorTool* tool) { return tool->pressed(*event); });
    if (!taken_)
        QsciScintilla::mousePressEvent(event);
}

void SceneEditor::mouseMoveEvent(QMouseEvent* event) {
    const bool taken =
        std::ranges::any_of(tools_, [&](EditorTool* tool) { return tool->moved(*event); });
    if (!taken && !taken_)
        QsciScintilla::mouseMoveEvent(event);
}

void SceneEditor::mouseReleaseEvent(QMouseEvent* event) {
    const bool taken =
        std::ranges::any_of(tools_, [&](EditorTool* tool) { return tool->released(*event); });
    if (!taken && !taken_)
        QsciScintilla::mouseReleaseEvent(event);
    taken_ = false;
}

void SceneEditor::mouseDoubleClickEvent(QMouseEvent* event) {
    taken_ = std::ranges::any_of(tools_, [&](EditorTool* tool) { return tool->pressed(*event); });
    if (taken_)
        return;
    QsciScintilla::mouseDoubleClickEvent(event);
    // A number is one word, with its sign and its point.
    if (const auto byte = byteAt(event->pos()))
        if (const auto number = editing::numberAt(bytes(), *byte);
            number && *byte < number->to && event->button() == Qt::LeftButton)
            select(*number);
}

void SceneEditor::contextMenuEvent(QContextMenuEvent* event) {
    event->accept();
    if (!taken_)
        Q_EMIT menuWanted(event->globalPos());
}

void SceneEditor::keyPressEvent(QKeyEvent* event) {
    if (std::ranges::none_of(tools_, [&](EditorTool* tool) { return tool->key(*event); }))
        QsciScintilla::keyPressEvent(event);
}

void SceneEditor::keyReleaseEvent(QKeyEvent* event) {
    if (std::ranges::none_of(tools_, [&](EditorTool* tool) { return tool->keyReleased(*event); }))
        QsciScintilla::keyReleaseEvent(event);
}

void SceneEditor::inputMethodEvent(QInputMethodEvent* event) {
    const bool inserts = !event->commitString().isEmpty() || !event->preeditString().isEmpty();
    if (inserts && selection().known())
        for (EditorTool* tool : tools_)
            tool->replacing();
    QsciScintilla::inputMethodEvent(event);
}

void SceneEditor::focusOutEvent(QFocusEvent* event) {
    QsciScintilla::focusOutEvent(event);
    for (EditorTool* tool : tools_)
        tool->left();
}

void SceneEditor::leaveEvent(QEvent* event) {
    QsciScintilla::leaveEvent(event);
    for (EditorTool* tool : tools_)
        tool->left();
}

void SceneEditor::paintEvent(QPaintEvent* event) {
    QsciScintilla::paintEvent(event);
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    for (EditorTool* tool : tools_)
        tool->paint(painter);
}

// The line that one writes stays seen where something takes room from the text.
void SceneEditor::resizeEvent(QResizeEvent* event) {
    const QRect line = rectOf(caret());
    const bool seen = line.bottom() >= 0 && line.top() < event->oldSize().height();
    QsciScintilla::resizeEvent(event);
    if (seen)
        reveal({caret(), caret()});
}

bool SceneEditor::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QsciScintilla::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    QString tip;
    if (const auto byte = byteAt(help->pos()))
        for (EditorTool* tool : tools_)
            if (tip.isEmpty())
                tip = tool->tip(*byte);
    QToolTip::showText(help->globalPos(), plain::tip(tip), viewport());
    return true;
}

} // namespace views
