#include "frame/manual_window.h"

#include "plain/plain.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QListWidget>
#include <QMenu>
#include <QMenuBar>
#include <QScrollBar>
#include <QSplitter>
#include <QTextBlock>
#include <QTextBrowser>
#include <QTextTable>
#include <QVBoxLayout>

namespace views {

namespace {

constexpr int blockRole = Qt::UserRole; // the number of a chapter's block

// Thin lines, and room within them.
void drawTablesLightly(const QTextFrame& frame) {
    for (QTextFrame* child : frame.childFrames()) {
        if (auto* table = qobject_cast<QTextTable*>(child)) {
            QTextTableFormat format = table->format();
            format.setBorderCollapse(true);
            format.setBorder(0.5);
            format.setBorderBrush(QColor(0xC8, 0xCC, 0xD2));
            format.setCellPadding(4);
            format.setCellSpacing(0);
            table->setFormat(format);
        }
        drawTablesLightly(*child);
    }
}

// A table without a heading has an empty first row.
void dropEmptyRows(const QTextFrame& frame) {
    for (QTextFrame* child : frame.childFrames()) {
        auto* table = qobject_cast<QTextTable*>(child);
        if (!table)
            continue;
        bool isEmpty = table->rows() > 1;
        for (int column = 0; column < table->columns(); ++column) {
            const QTextTableCell cell = table->cellAt(0, column);
            isEmpty = isEmpty && cell.firstPosition() == cell.lastPosition();
        }
        if (isEmpty)
            table->removeRows(0, 1);
    }
}

} // namespace

ManualWindow::ManualWindow(const QString& markdown)
    : text_(new QTextBrowser), chapters_(new QListWidget), search_(new QLineEdit),
      none_(plain::label(tr("Not found"))) {
    setAttribute(Qt::WA_DeleteOnClose);
    setObjectName("manual");
    setAttribute(Qt::WA_QuitOnClose, false);
    setWindowTitle(tr("Manual"));
    text_->setMarkdown(markdown);
    text_->document()->setDocumentMargin(16);
    dropEmptyRows(*text_->document()->rootFrame());
    drawTablesLightly(*text_->document()->rootFrame());
    search_->setPlaceholderText(tr("Find (Ctrl+F)"));
    search_->setObjectName("search");
    search_->setAccessibleName(tr("Find in the manual"));
    search_->setClearButtonEnabled(true);
    none_->setForegroundRole(QPalette::PlaceholderText);
    none_->hide();
    chapters_->setObjectName("chapters");
    chapters_->setAccessibleName(tr("Chapters"));
    chapters_->setFrameShape(QFrame::NoFrame);
    fillChapters();
    auto* left = new QWidget;
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(8, 8, 4, 8);
    column->addWidget(search_);
    column->addWidget(none_);
    column->addWidget(chapters_, 1);
    auto* whole = new QSplitter;
    whole->addWidget(left);
    whole->addWidget(text_);
    whole->setStretchFactor(1, 1);
    whole->setSizes({220, 760});
    setCentralWidget(whole);
    buildMenus();
    connect(chapters_, &QListWidget::itemClicked, this,
            [this](const QListWidgetItem* item) { goTo(item->text().trimmed()); });
    connect(chapters_, &QListWidget::itemActivated, this,
            [this](const QListWidgetItem* item) { goTo(item->text().trimmed()); });
    connect(search_, &QLineEdit::returnPressed, this, [this] { findAgain(false); });
    connect(search_, &QLineEdit::textEdited, this, [this](const QString& words) {
        QTextCursor from = text_->textCursor(); // a longer word may begin where the shorter did
        from.setPosition(from.selectionStart());
        text_->setTextCursor(from);
        none_->setVisible(!words.isEmpty() && !find(words));
    });
    connect(text_->verticalScrollBar(), &QScrollBar::valueChanged, this,
            &ManualWindow::followScrolling);
    text_->setFocus();
    resize(980, 760);
}

void ManualWindow::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("&Close"), QKeySequence(Qt::CTRL | Qt::Key_W), this, &QWidget::close);
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addAction(tr("&Find"), QKeySequence::Find, this, [this] {
        search_->setFocus();
        search_->selectAll();
    });
    edit->addAction(tr("Find &Next"), QKeySequence(Qt::Key_F3), this, [this] { findAgain(false); });
    edit->addAction(tr("Find &Previous"), QKeySequence(Qt::SHIFT | Qt::Key_F3), this,
                    [this] { findAgain(true); });
}

// Qt gives them the palette's colour of the moment in which the text was read.
void ManualWindow::colourLinks() {
    QTextCharFormat link;
    link.setForeground(palette().color(QPalette::Link));
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next())
        for (auto part = block.begin(); !part.atEnd(); ++part) {
            const QTextFragment fragment = part.fragment();
            if (!fragment.charFormat().isAnchor() ||
                fragment.charFormat().foreground().color() == link.foreground().color())
                continue;
            QTextCursor cursor(block);
            cursor.setPosition(fragment.position());
            cursor.setPosition(fragment.position() + fragment.length(), QTextCursor::KeepAnchor);
            cursor.mergeCharFormat(link);
            part = block.begin(); // what was changed may be parted otherwise
        }
}

void ManualWindow::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        colourLinks();
}

void ManualWindow::fillChapters() {
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next()) {
        const int level = block.blockFormat().headingLevel();
        if (level < 1 || level > 3)
            continue;
        auto* item = new QListWidgetItem(QString(3 * (level - 1), ' ') + block.text(), chapters_);
        item->setData(blockRole, block.blockNumber());
        QFont font = item->font();
        font.setBold(level == 1);
        item->setFont(font);
    }
}

void ManualWindow::goTo(const QString& chapter) {
    for (QTextBlock block = text_->document()->begin(); block.isValid(); block = block.next())
        if (block.blockFormat().headingLevel() > 0 && block.text() == chapter) {
            // The chapter's heading comes to the top: from below, one scrolls no further.
            text_->moveCursor(QTextCursor::End);
            text_->setTextCursor(QTextCursor(block));
            return;
        }
}

bool ManualWindow::find(const QString& words, bool back) {
    const QTextDocument::FindFlags way =
        back ? QTextDocument::FindBackward : QTextDocument::FindFlags();
    if (text_->find(words, way))
        return true;
    const QTextCursor before = text_->textCursor();
    text_->moveCursor(back ? QTextCursor::End : QTextCursor::Start);
    if (text_->find(words, way))
        return true;
    text_->setTextCursor(before);
    return false;
}

void ManualWindow::findAgain(bool back) {
    if (search_->text().isEmpty())
        search_->setFocus();
    else
        none_->setVisible(!find(search_->text(), back));
}

// The chapter that is read is the one that is marked.
void ManualWindow::followScrolling() {
    const int block = text_->cursorForPosition(QPoint(20, 40)).blockNumber();
    for (int row = chapters_->count() - 1; row >= 0; --row)
        if (chapters_->item(row)->data(blockRole).toInt() <= block) {
            chapters_->setCurrentRow(row);
            return;
        }
}

void ManualWindow::keyPressEvent(QKeyEvent* event) {
    if (event->key() != Qt::Key_Escape)
        return QMainWindow::keyPressEvent(event);
    if (!search_->hasFocus() || search_->text().isEmpty()) {
        close();
        return;
    }
    search_->clear();
    none_->hide();
    text_->setFocus();
}

} // namespace views
