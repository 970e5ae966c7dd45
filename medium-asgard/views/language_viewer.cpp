#include "views/language_viewer.h"

#include "views/scene_lexer.h"

#include <QApplication>
#include <QCloseEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QSplitter>
#include <QStyle>
#include <QVBoxLayout>

#include <algorithm>

namespace views {

namespace {

enum Indicator { errorMark = 8, warningMark, argumentMark };

// Options whose literal values graphical views show and change (dissertation 4.2).
bool isGraphical(const std::string& option) {
    for (const char* name : {"-init_pos", "-init_rot", "-init_dpos", "-init_drot", "-offset",
                             "-offset1", "-offset2", "-pos", "-direction", "-points", "-bezier"})
        if (option == name)
            return true;
    return false;
}

bool isDark(const QWidget& widget) {
    return widget.palette().color(QPalette::Base).lightness() < 128;
}

} // namespace

LanguageViewer::LanguageViewer(SceneDocument& document, Windows windows, int number)
    : document_(document), windows_(std::move(windows)), number_(number),
      editor_(new QsciScintilla), messages_(new QListWidget), notice_(new QLabel) {
    setAttribute(Qt::WA_DeleteOnClose);
    auto* whole = new QWidget;
    auto* column = new QVBoxLayout(whole);
    column->setContentsMargins(8, 8, 8, 8);
    column->setSpacing(8);
    buildEditor();
    messages_->setAccessibleName(tr("Messages"));
    messages_->setWordWrap(true);
    messages_->setIconSize(QSize(16, 16));
    messages_->setAlternatingRowColors(true);
    notice_->setWordWrap(true);
    notice_->setAccessibleName(tr("Notice"));
    notice_->setAutoFillBackground(true);
    notice_->setBackgroundRole(QPalette::ToolTipBase);
    notice_->setForegroundRole(QPalette::ToolTipText);
    notice_->setMargin(8);
    connect(notice_, &QLabel::linkActivated, this, &LanguageViewer::dropDraft);
    auto* splitter = new QSplitter(Qt::Vertical);
    splitter->addWidget(editor_);
    splitter->addWidget(messages_);
    splitter->setStretchFactor(0, 1);
    splitter->setCollapsible(0, false);
    splitter->setSizes({420, 90});
    column->addWidget(notice_);
    column->addWidget(splitter, 1);
    column->addWidget(buildFindBar());
    column->addWidget(buildButtons());
    setCentralWidget(whole);
    buildMenus();
    connect(editor_, &QsciScintilla::textChanged, this, &LanguageViewer::textTyped);
    connect(messages_, &QListWidget::itemActivated, this, [this](QListWidgetItem* item) {
        const QPoint range = item->data(Qt::UserRole).toPoint();
        if (range.y() >= 0)
            select(static_cast<std::size_t>(range.x()), static_cast<std::size_t>(range.y()));
    });
    connect(messages_, &QListWidget::itemClicked, messages_, &QListWidget::itemActivated);
    connect(&document_, &SceneDocument::textChanged, this, &LanguageViewer::followDocument);
    connect(&document_, &SceneDocument::diagnosticsChanged, this, &LanguageViewer::showDiagnostics);
    connect(&document_, &SceneDocument::sceneChanged, this, &LanguageViewer::showDiagnostics);
    connect(&document_, &SceneDocument::nameChanged, this, &LanguageViewer::updateTitle);
    connect(&document_, &SceneDocument::changeAccepted, this, [this] { submitted_.reset(); });
    connect(&document_, &SceneDocument::changeRefused, this, &LanguageViewer::becomeDraftAgain);
    setEditorText(document_.text());
    draftRevision_ = document_.revision();
    showDiagnostics();
    updateTitle();
    updateNotice();
    editor_->setFocus();
    resize(680, 640);
}

void LanguageViewer::buildEditor() {
    editor_->setUtf8(true);
    editor_->setEolMode(QsciScintilla::EolUnix);
    editor_->setLexer(new SceneLexer(editor_));
    editor_->setMarginType(0, QsciScintilla::NumberMargin);
    editor_->setMarginWidth(1, 0);
    editor_->SendScintilla(QsciScintillaBase::SCI_SETMARGINLEFT, 0UL, 6L);
    editor_->setTabWidth(4);
    editor_->setIndentationsUseTabs(false);
    editor_->setAutoIndent(true);
    editor_->setBraceMatching(QsciScintilla::SloppyBraceMatch);
    editor_->setCaretLineVisible(true);
    editor_->setAnnotationDisplay(QsciScintilla::AnnotationIndented);
    editor_->setScrollWidth(1);
    editor_->setScrollWidthTracking(true);
    editor_->setAccessibleName(tr("Text of the scene"));
    editor_->indicatorDefine(QsciScintilla::SquiggleIndicator, errorMark);
    editor_->indicatorDefine(QsciScintilla::SquiggleIndicator, warningMark);
    editor_->indicatorDefine(QsciScintilla::FullBoxIndicator, argumentMark);
    editor_->setIndicatorDrawUnder(true, argumentMark);
    editor_->setFrameStyle(QFrame::StyledPanel | QFrame::Sunken);
    editor_->installEventFilter(this);
    colourEditor();
}

void LanguageViewer::colourEditor() {
    const QPalette& p = palette();
    const bool dark = isDark(*this);
    editor_->lexer()->setDefaultPaper(p.color(QPalette::Base));
    for (int style = SceneLexer::plain; style <= SceneLexer::string; ++style) {
        editor_->lexer()->setColor(editor_->lexer()->defaultColor(style), style);
        editor_->lexer()->setPaper(p.color(QPalette::Base), style);
    }
    editor_->setPaper(p.color(QPalette::Base));
    editor_->setCaretForegroundColor(p.color(QPalette::Text));
    editor_->setCaretLineBackgroundColor(dark ? p.color(QPalette::Base).lighter(130)
                                              : p.color(QPalette::Base).darker(104));
    editor_->setSelectionBackgroundColor(p.color(QPalette::Highlight));
    editor_->setSelectionForegroundColor(p.color(QPalette::HighlightedText));
    editor_->setMarginsBackgroundColor(p.color(QPalette::Window));
    editor_->setMarginsForegroundColor(p.color(QPalette::PlaceholderText));
    editor_->setMarginsFont(editor_->lexer()->defaultFont(SceneLexer::plain));
    editor_->setMatchedBraceBackgroundColor(dark ? QColor(0x40, 0x58, 0x70)
                                                 : QColor(0xD5, 0xE6, 0xF7));
    editor_->setMatchedBraceForegroundColor(p.color(QPalette::Text));
    editor_->setIndicatorForegroundColor(QColor(0xD0, 0x20, 0x20), errorMark);
    editor_->setIndicatorForegroundColor(QColor(0xC0, 0x80, 0x00), warningMark);
    editor_->setIndicatorForegroundColor(
        dark ? QColor(0x60, 0x90, 0xC0, 0x60) : QColor(0x50, 0x90, 0xE0, 0x40), argumentMark);
}

QWidget* LanguageViewer::buildFindBar() {
    findBar_ = new QWidget;
    auto* row = new QHBoxLayout(findBar_);
    row->setContentsMargins(0, 0, 0, 0);
    findText_ = new QLineEdit;
    findText_->setPlaceholderText(tr("Find"));
    findText_->setAccessibleName(tr("Find"));
    findText_->setClearButtonEnabled(true);
    findText_->installEventFilter(this);
    auto* previous = new QPushButton(tr("&Previous"));
    auto* next = new QPushButton(tr("&Next"));
    row->addWidget(findText_, 1);
    row->addWidget(previous);
    row->addWidget(next);
    connect(findText_, &QLineEdit::returnPressed, this, [this] { find(findText_->text()); });
    connect(next, &QPushButton::clicked, this, [this] { find(findText_->text()); });
    connect(previous, &QPushButton::clicked, this, [this] { find(findText_->text(), false); });
    findBar_->hide();
    return findBar_;
}

QWidget* LanguageViewer::buildButtons() {
    auto* buttons = new QWidget;
    auto* row = new QHBoxLayout(buttons);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    updateButton_ = new QPushButton(tr("&Update"));
    updateButton_->setToolTip(tr("Make this the scene's text, in every view (Ctrl+Return)"));
    saveButton_ = new QPushButton(tr("&Save"));
    saveButton_->setToolTip(tr("Update, and write the file (Ctrl+S)"));
    saveButton_->setVisible(static_cast<bool>(windows_.save));
    revertButton_ = new QPushButton(tr("&Revert"));
    revertButton_->setToolTip(document_.hasHost()
                                  ? tr("Drop the draft: back to the document's text")
                                  : tr("Back to the text that was saved last, in every view"));
    auto* dismiss = new QPushButton(tr("&Dismiss"));
    dismiss->setToolTip(tr("Close this viewer"));
    for (QPushButton* button : {updateButton_, saveButton_, revertButton_})
        row->addWidget(button);
    row->addStretch();
    row->addWidget(dismiss);
    connect(updateButton_, &QPushButton::clicked, this, &LanguageViewer::updateDocument);
    connect(saveButton_, &QPushButton::clicked, this, [this] {
        updateDocument();
        windows_.save();
    });
    connect(revertButton_, &QPushButton::clicked, this, &LanguageViewer::revert);
    connect(dismiss, &QPushButton::clicked, this, &QWidget::close);
    return buttons;
}

void LanguageViewer::buildMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addAction(tr("New &Graphical Viewer"), QKeySequence(Qt::CTRL | Qt::Key_N), this,
                    [this] { windows_.openGraphicalViewer(); });
    file->addAction(tr("New &Language Viewer"), QKeySequence(Qt::CTRL | Qt::Key_L), this,
                    [this] { windows_.openLanguageViewer(); });
    file->addSeparator();
    file->addAction(tr("&Update"), QKeySequence(Qt::CTRL | Qt::Key_Return), this,
                    &LanguageViewer::updateDocument);
    if (windows_.save)
        file->addAction(tr("&Save"), QKeySequence::Save, saveButton_, &QPushButton::click);
    file->addAction(tr("&Revert"), this, &LanguageViewer::revert);
    file->addAction(tr("&Close"), QKeySequence::Close, this, &QWidget::close);

    // While there is a draft, undo takes back what was typed; else the scene's last change.
    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addAction(tr("&Undo"), QKeySequence::Undo, this, [this] {
        if (edited_ && editor_->isUndoAvailable())
            editor_->undo();
        else
            document_.undo();
    });
    edit->addAction(tr("&Redo"), QKeySequence::Redo, this, [this] {
        if (editor_->isRedoAvailable())
            editor_->redo();
        else if (!edited_)
            document_.redo();
    });
    edit->addSeparator();
    edit->addAction(tr("Cu&t"), QKeySequence::Cut, editor_, &QsciScintilla::cut);
    edit->addAction(tr("&Copy"), QKeySequence::Copy, editor_, &QsciScintilla::copy);
    edit->addAction(tr("&Paste"), QKeySequence::Paste, editor_, &QsciScintilla::paste);
    edit->addSeparator();
    edit->addAction(tr("&Find…"), QKeySequence::Find, this, &LanguageViewer::openFind);
    edit->addAction(tr("Find &Next"), QKeySequence::FindNext, this,
                    [this] { find(findText_->text()); });
}

std::string LanguageViewer::draft() const {
    const auto length = editor_->SendScintilla(QsciScintillaBase::SCI_GETLENGTH);
    std::string text(static_cast<std::size_t>(length) + 1, '\0');
    editor_->SendScintilla(QsciScintillaBase::SCI_GETTEXT, text.size(), text.data());
    text.pop_back();
    return text;
}

// Replaces only what differs, so that cursor, scroll position and marks of the rest stay.
void LanguageViewer::setEditorText(const std::string& text) {
    const TextEdit edit = editBetween(draft(), text);
    setting_ = true;
    editor_->SendScintilla(QsciScintillaBase::SCI_SETTARGETRANGE, edit.from,
                           static_cast<long>(edit.to));
    editor_->SendScintilla(QsciScintillaBase::SCI_REPLACETARGET, edit.text.size(),
                           edit.text.data());
    editor_->SendScintilla(QsciScintillaBase::SCI_EMPTYUNDOBUFFER);
    setting_ = false;
    edited_ = false;
    const int digits = static_cast<int>(QString::number(editor_->lines()).size());
    editor_->setMarginWidth(0, QString(std::max(3, digits) + 1, QLatin1Char('9')));
}

void LanguageViewer::textTyped() {
    if (setting_)
        return;
    edited_ = draft() != document_.text();
    editor_->clearAnnotations(); // they tell of the text as it was
    updateTitle();
    updateNotice();
}

void LanguageViewer::followDocument() {
    if (!edited_ || draft() == document_.text()) {
        setEditorText(document_.text());
        draftRevision_ = document_.revision();
    }
    updateTitle();
    updateNotice();
}

void LanguageViewer::updateDocument() {
    draftRevision_ = document_.revision() + 1;
    edited_ = false;
    refusal_.clear();
    const std::string text = draft();
    if (document_.hasHost() && text != document_.text())
        submitted_ = text;
    document_.setText(text, tr("Edit text"));
    draftRevision_ = document_.revision();
    updateTitle();
    updateNotice();
}

void LanguageViewer::becomeDraftAgain(const QString& why) {
    const auto mine = std::exchange(submitted_, std::nullopt);
    if (!mine || (!edited_ && *mine == document_.text()))
        return;
    if (!edited_)
        setEditorText(*mine);
    edited_ = true;
    refusal_ = why;
    clearMarks();
    updateTitle();
    updateNotice();
}

void LanguageViewer::revert() {
    edited_ = false;
    if (!document_.hasHost())
        document_.setText(document_.savedText(), tr("Revert"));
    dropDraft();
}

void LanguageViewer::dropDraft() {
    refusal_.clear();
    setEditorText(document_.text());
    draftRevision_ = document_.revision();
    showDiagnostics();
    updateTitle();
    updateNotice();
}

void LanguageViewer::select(std::size_t from, std::size_t to) {
    editor_->SendScintilla(QsciScintillaBase::SCI_SETSEL, from, static_cast<long>(to));
    editor_->ensureCursorVisible();
    editor_->setFocus();
}

bool LanguageViewer::find(const QString& what, bool forward) {
    if (what.isEmpty())
        return false;
    int line = -1, column = -1;
    if (!forward) {
        int endLine = 0, endColumn = 0;
        editor_->getSelection(&line, &column, &endLine, &endColumn);
    }
    const bool found =
        editor_->findFirst(what, false, false, false, true, forward, line, column, true);
    findText_->setStyleSheet(found ? QString() : QStringLiteral("color: #C02020"));
    return found;
}

void LanguageViewer::openFind() {
    findBar_->show();
    if (editor_->hasSelectedText() && !editor_->selectedText().contains(QLatin1Char('\n')))
        findText_->setText(editor_->selectedText());
    findText_->setFocus();
    findText_->selectAll();
}

void LanguageViewer::clearMarks() {
    editor_->clearAnnotations();
    const auto length = editor_->SendScintilla(QsciScintillaBase::SCI_GETLENGTH);
    for (int indicator : {errorMark, warningMark, argumentMark}) {
        editor_->SendScintilla(QsciScintillaBase::SCI_SETINDICATORCURRENT, indicator);
        editor_->SendScintilla(QsciScintillaBase::SCI_INDICATORCLEARRANGE, 0UL, length);
    }
}

void LanguageViewer::markDiagnostic(const scene::Diagnostic& diagnostic) {
    const bool isError = diagnostic.severity == scene::Severity::error;
    if (diagnostic.range.known()) {
        editor_->SendScintilla(QsciScintillaBase::SCI_SETINDICATORCURRENT,
                               isError ? errorMark : warningMark);
        editor_->SendScintilla(QsciScintillaBase::SCI_INDICATORFILLRANGE, diagnostic.range.from,
                               static_cast<long>(diagnostic.range.to - diagnostic.range.from));
    }
    if (diagnostic.line <= 0)
        return;
    QString note = QString::fromStdString(diagnostic.message);
    if (!diagnostic.suggestion.empty())
        note += QLatin1Char('\n') + QString::fromStdString(diagnostic.suggestion);
    const QString before = editor_->annotation(diagnostic.line - 1);
    if (!before.isEmpty())
        note = before + QLatin1Char('\n') + note;
    const bool dark = isDark(*this);
    const QColor paper = isError ? (dark ? QColor(0x50, 0x28, 0x28) : QColor(0xFC, 0xE8, 0xE6))
                                 : (dark ? QColor(0x4A, 0x3E, 0x1C) : QColor(0xFD, 0xF3, 0xD8));
    const QColor ink = isError ? (dark ? QColor(0xF0, 0xB0, 0xA8) : QColor(0x8A, 0x1C, 0x14))
                               : (dark ? QColor(0xEC, 0xD0, 0x8C) : QColor(0x6E, 0x4C, 0x00));
    QFont font = editor_->lexer()->defaultFont(SceneLexer::plain);
    font.setPointSizeF(font.pointSizeF() * 0.92);
    editor_->annotate(diagnostic.line - 1, note,
                      QsciStyle(isError ? 40 : 41, tr("Fault"), ink, paper, font));
}

// The words that graphical views show: literal values of commands that ran once.
void LanguageViewer::markArguments() {
    if (!document_.sceneIsCurrent() || edited_)
        return;
    editor_->SendScintilla(QsciScintillaBase::SCI_SETINDICATORCURRENT, argumentMark);
    const auto mark = [this](const scene::Source& source) {
        for (const scene::Argument& argument : source.arguments)
            if (source.runs == 1 && argument.literal && isGraphical(argument.option))
                editor_->SendScintilla(QsciScintillaBase::SCI_INDICATORFILLRANGE,
                                       argument.word.from,
                                       static_cast<long>(argument.word.to - argument.word.from));
    };
    const scene::Scene& scene = *document_.shown().scene;
    const auto all = [&](const auto& elements) {
        for (const auto& element : elements)
            mark(element.source);
    };
    all(scene.bodies);
    all(scene.forces);
    all(scene.links);
    all(scene.trajectories);
    all(scene.lights);
}

void LanguageViewer::showDiagnostics() {
    messages_->clear();
    if (!edited_) {
        clearMarks();
        markArguments();
    }
    for (const scene::Diagnostic& diagnostic : document_.diagnostics()) {
        const bool isError = diagnostic.severity == scene::Severity::error;
        QString text = QString::fromStdString(diagnostic.message);
        if (diagnostic.line > 0)
            text = tr("Line %1: %2").arg(diagnostic.line).arg(text);
        if (!diagnostic.suggestion.empty())
            text += QStringLiteral(" — ") + QString::fromStdString(diagnostic.suggestion);
        auto* item =
            new QListWidgetItem(style()->standardIcon(isError ? QStyle::SP_MessageBoxCritical
                                                              : QStyle::SP_MessageBoxWarning),
                                text, messages_);
        const bool placed = diagnostic.line > 0 && !edited_;
        item->setData(Qt::UserRole, placed ? QPoint(static_cast<int>(diagnostic.range.from),
                                                    static_cast<int>(diagnostic.range.to))
                                           : QPoint(-1, -1));
        if (!edited_)
            markDiagnostic(diagnostic);
    }
    messages_->setVisible(messages_->count() > 0);
}

void LanguageViewer::updateTitle() {
    const QString viewer =
        number_ == 1 ? tr("Language Viewer") : tr("Language Viewer %1").arg(number_);
    setWindowTitle(tr("%1[*] – %2").arg(document_.name(), viewer));
    setWindowModified(edited_ || (!document_.hasHost() && document_.isModified()));
    updateButton_->setEnabled(edited_);
    updateButton_->setDefault(edited_);
    saveButton_->setEnabled(edited_ || document_.isModified());
    revertButton_->setEnabled(edited_ || (!document_.hasHost() && document_.isModified()));
    Q_EMIT draftChanged();
}

void LanguageViewer::updateNotice() {
    const bool refused = edited_ && !refusal_.isEmpty();
    const bool overtaken = edited_ && draftRevision_ != document_.revision();
    const QString what =
        refused ? tr("The document did not take this change: %1.").arg(refusal_.toHtmlEscaped())
                : tr("The scene was changed in another view.");
    notice_->setText(what + QLatin1Char(' ') +
                     tr("This draft is kept: Update makes it the scene's text, or "
                        "<a href=\"drop\">drop the draft</a>."));
    notice_->setVisible(refused || overtaken);
}

bool LanguageViewer::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress &&
        static_cast<QKeyEvent*>(event)->key() == Qt::Key_Escape && findBar_->isVisible()) {
        findBar_->hide();
        editor_->setFocus();
        return true;
    }
    // Scintilla has shortcuts of its own for what the menus do; the menus shall have them.
    if (watched == editor_ && event->type() == QEvent::ShortcutOverride) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (key->modifiers() & Qt::ControlModifier) {
            for (int mine : {Qt::Key_Z, Qt::Key_Y, Qt::Key_L, Qt::Key_N, Qt::Key_F, Qt::Key_S,
                             Qt::Key_Return, Qt::Key_W})
                if (key->key() == mine) {
                    event->ignore();
                    return true;
                }
        }
    }
    return QMainWindow::eventFilter(watched, event);
}

void LanguageViewer::closeEvent(QCloseEvent* event) {
    if (!edited_) {
        event->accept();
        return;
    }
    QMessageBox box(QMessageBox::Question, tr("Close the language viewer"),
                    tr("The draft in this viewer was not made the scene's text."),
                    QMessageBox::NoButton, this);
    QPushButton* update = box.addButton(tr("&Update and Close"), QMessageBox::AcceptRole);
    QPushButton* drop = box.addButton(tr("&Drop the Draft"), QMessageBox::DestructiveRole);
    box.addButton(QMessageBox::Cancel);
    box.setDefaultButton(update);
    box.exec();
    if (box.clickedButton() == update)
        updateDocument();
    event->setAccepted(box.clickedButton() == update || box.clickedButton() == drop);
}

void LanguageViewer::changeEvent(QEvent* event) {
    QMainWindow::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && editor_->lexer() != nullptr)
        colourEditor();
}

} // namespace views
