#include "source/source_edit.h"

#include "plain/plain.h"

#include <QFontDatabase>
#include <QHelpEvent>
#include <QMenu>
#include <QMetaMethod>
#include <QPainter>
#include <QScrollBar>
#include <QTextBlock>
#include <QToolTip>

namespace source {

namespace {

constexpr int gap = 6; // around the numbers

class LineNumbers : public QWidget {
public:
    explicit LineNumbers(SourceEdit& edit) : QWidget(&edit), edit_(edit) {}
    [[nodiscard]] QSize sizeHint() const override { return {edit_.numbersWidth(), 0}; }

protected:
    void paintEvent(QPaintEvent* event) override { edit_.paintNumbers(*this, event->rect()); }

private:
    SourceEdit& edit_;
};

QColor faultColor(bool isError, bool isDark) {
    return colorOf(isError ? Kind::stray : Kind::value, isDark);
}

} // namespace

SourceEdit::SourceEdit(QWidget* parent) : QPlainTextEdit(parent), numbers_(new LineNumbers(*this)) {
    setFrameShape(QFrame::NoFrame);
    QFont font = QFontDatabase::systemFont(QFontDatabase::FixedFont);
    font.setPointSizeF(this->font().pointSizeF());
    setFont(font);
    setWordWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
    constexpr int tabLetters = 4;
    setTabStopDistance(tabLetters * fontMetrics().horizontalAdvance(QLatin1Char(' ')));
    const auto makeRoom = [this] {
        setViewportMargins(numbersWidth(), 0, 0, 0);
        numbers_->resize(numbersWidth(), numbers_->height());
    };
    connect(this, &QPlainTextEdit::blockCountChanged, this, makeRoom);
    connect(this, &QPlainTextEdit::updateRequest, numbers_, [this](const QRect& rect, int by) {
        if (by != 0)
            numbers_->scroll(0, by);
        else
            numbers_->update(0, rect.y(), numbers_->width(), rect.height());
    });
    makeRoom();
}

bool SourceEdit::isDark() const {
    constexpr int middle = 128;
    return palette().color(QPalette::Base).lightness() < middle;
}

void SourceEdit::setWhyNotWritable(const QString& why) {
    whyNot_ = why;
    // The caret stays, to select and to go to a place.
    setTextInteractionFlags(why.isEmpty()
                                ? Qt::TextEditorInteraction
                                : Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
}

// --- keys --------------------------------------------------------------------------------------

bool SourceEdit::saves(const QKeyEvent& event) const {
    static const QMetaMethod wanted = QMetaMethod::fromSignal(&SourceEdit::saveWanted);
    return event.matches(QKeySequence::Save) && isSignalConnected(wanted);
}

// Undo is the document's, where this text has none of its own.
bool SourceEdit::event(QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride) {
        auto* key = static_cast<QKeyEvent*>(event);
        const bool isUndo = key->matches(QKeySequence::Undo) || key->matches(QKeySequence::Redo);
        if (isUndo && !isUndoRedoEnabled()) {
            event->ignore();
            return true;
        }
        if (saves(*key)) {
            event->accept();
            return true;
        }
    }
    return QPlainTextEdit::event(event);
}

void SourceEdit::keyPressEvent(QKeyEvent* event) {
    constexpr auto commands = Qt::ControlModifier | Qt::AltModifier | Qt::MetaModifier;
    const bool types = !(event->modifiers() & commands) && !event->text().isEmpty();
    if (event->key() == Qt::Key_Escape) {
        Q_EMIT left();
    } else if (saves(*event)) {
        Q_EMIT saveWanted();
    } else if (types && !whyNot_.isEmpty() && event->key() != Qt::Key_Tab) {
        Q_EMIT refused(whyNot_);
    } else {
        QPlainTextEdit::keyPressEvent(event);
    }
}

void SourceEdit::contextMenuEvent(QContextMenuEvent* event) {
    QMenu* menu = createStandardContextMenu(event->pos());
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (!isUndoRedoEnabled())
        for (QAction* action : menu->actions())
            if (action->objectName() == QLatin1String("edit-undo") ||
                action->objectName() == QLatin1String("edit-redo"))
                action->setVisible(false);
    menu->popup(event->globalPos());
}

// --- marks -------------------------------------------------------------------------------------

void SourceEdit::setMarker(Marker marker) {
    marker_ = std::move(marker);
    viewport()->update();
}

void SourceEdit::setFaults(const std::vector<LineFault>& faults) {
    faults_.clear();
    for (const LineFault& fault : faults)
        if (fault.line > 0)
            faults_.emplace(fault.line - 1, fault);
    viewport()->update();
    numbers_->update();
}

QString SourceEdit::faultOf(int line) const {
    const auto found = faults_.find(line);
    return found == faults_.end() ? QString() : found->second.sentence;
}

LineFault SourceEdit::firstFault() const {
    for (const auto& [line, fault] : faults_)
        if (fault.isError)
            return fault;
    return faults_.empty() ? LineFault{} : faults_.begin()->second;
}

// From the fault's place to the end of the word there, its sign in front included.
std::pair<int, int> SourceEdit::lettersOf(const QTextBlock& block, const LineFault& fault) const {
    const QString line = block.text();
    const auto size = static_cast<int>(line.size());
    int from = 0;
    for (int column = 1; column < fault.column && from < size; ++column)
        from += line[from].isHighSurrogate() ? 2 : 1;
    if (from >= size)
        return {std::max(0, size - 1), std::min(size, 1)};
    int to = from + 1;
    if (line[from] == QLatin1Char('<') && to < size && line[to] == QLatin1Char('/'))
        ++to;
    while (to < size && (line[to].isLetterOrNumber() || line[to].isSurrogate()))
        ++to;
    return {from, to - from};
}

void SourceEdit::mark(const QTextBlock& block, const LineMarks& marks) const {
    QList<QTextLayout::FormatRange> formats;
    for (const LineMark& mark : marks) {
        QTextCharFormat format;
        format.setForeground(colorOf(mark.kind, isDark()));
        formats.append({mark.from, mark.length, format});
    }
    const auto [first, last] = faults_.equal_range(block.blockNumber());
    for (auto fault = first; fault != last; ++fault) {
        const auto [from, length] = lettersOf(block, fault->second);
        QTextCharFormat format;
        format.setUnderlineStyle(QTextCharFormat::WaveUnderline);
        format.setUnderlineColor(faultColor(fault->second.isError, isDark()));
        formats.append({from, length, format});
    }
    if (block.layout()->formats() == formats)
        return;
    block.layout()->setFormats(formats);
    document()->markContentsDirty(block.position(), block.length());
}

void SourceEdit::markSeen() {
    QTextBlock block = firstVisibleBlock();
    const QPointF offset = contentOffset();
    std::vector<QTextBlock> seen;
    for (double top = blockBoundingGeometry(block).translated(offset).top();
         block.isValid() && top <= viewport()->height(); block = block.next()) {
        seen.push_back(block);
        top += blockBoundingRect(block).height();
    }
    if (seen.empty())
        return;
    linesMarked_ += seen.size();
    std::vector<LineMarks> marks(seen.size());
    if (marker_)
        marks = marker_(seen.front().blockNumber(), static_cast<int>(seen.size()));
    for (std::size_t i = 0; i < std::min(seen.size(), marks.size()); ++i)
        mark(seen[i], marks[i]);
}

void SourceEdit::paintEvent(QPaintEvent* event) {
    markSeen();
    QPlainTextEdit::paintEvent(event);
}

bool SourceEdit::viewportEvent(QEvent* event) {
    if (event->type() != QEvent::ToolTip)
        return QPlainTextEdit::viewportEvent(event);
    const auto* help = static_cast<QHelpEvent*>(event);
    const QTextCursor cursor = cursorForPosition(help->pos());
    QString sentence;
    const auto [first, last] = faults_.equal_range(cursor.blockNumber());
    for (auto fault = first; fault != last; ++fault) {
        const auto [from, length] = lettersOf(cursor.block(), fault->second);
        if (from <= cursor.positionInBlock() && cursor.positionInBlock() <= from + length)
            sentence = fault->second.sentence;
    }
    QToolTip::showText(help->globalPos(), plain::tip(sentence), this);
    return true;
}

// --- where the pages are -----------------------------------------------------------------------

void SourceEdit::setBand(int position) {
    band_ = position;
    showBand();
}

void SourceEdit::showBand() {
    QList<QTextEdit::ExtraSelection> bands;
    if (band_ >= 0) {
        QTextEdit::ExtraSelection band;
        band.cursor = QTextCursor(document());
        band.cursor.setPosition(std::min(band_, document()->characterCount() - 1));
        band.format.setBackground(bandColor(isDark()));
        band.format.setProperty(QTextFormat::FullWidthSelection, true);
        bands.append(band);
    }
    setExtraSelections(bands);
}

void SourceEdit::scrollToLine(int position) {
    QTextCursor cursor(document());
    cursor.setPosition(std::min(position, document()->characterCount() - 1));
    const QRect line = cursorRect(cursor);
    if (line.top() < 0 || line.bottom() > viewport()->height())
        verticalScrollBar()->setValue(cursor.block().firstLineNumber());
}

// --- numbers -----------------------------------------------------------------------------------

int SourceEdit::numbersWidth() const {
    const auto digits = std::max<qsizetype>(3, QString::number(blockCount()).size());
    return 2 * gap + fontMetrics().horizontalAdvance(QString(digits, QLatin1Char('0')));
}

void SourceEdit::paintNumbers(QWidget& on, const QRect& area) {
    QPainter painter(&on);
    painter.fillRect(area, palette().color(QPalette::Window));
    painter.setFont(font());
    QTextBlock block = firstVisibleBlock();
    double top = blockBoundingGeometry(block).translated(contentOffset()).top();
    for (; block.isValid() && top <= area.bottom(); block = block.next()) {
        const bool isFaulty = faults_.contains(block.blockNumber());
        painter.setPen(isFaulty ? faultColor(true, isDark()) : numberColor(isDark()));
        painter.drawText(QRectF(0, top, on.width() - gap, fontMetrics().height()), Qt::AlignRight,
                         QString::number(block.blockNumber() + 1));
        top += blockBoundingRect(block).height();
    }
}

void SourceEdit::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    const QRect inside = contentsRect();
    numbers_->setGeometry(inside.left(), inside.top(), numbersWidth(), inside.height());
}

void SourceEdit::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        showBand();
}

} // namespace source
