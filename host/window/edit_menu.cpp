#include "window/edit_menu.h"

#include "controls/keyboard.h"
#include "menus/actions.h"
#include "panes/find_bar.h"
#include "panes/text_count_dialog.h"
#include "plain/plain.h"
#include "source/find_line.h"
#include "view/document_view.h"
#include "view/writing.h"

#include <QApplication>
#include <QClipboard>
#include <QPlainTextEdit>
#include <QSettings>

namespace window {

namespace {

// A text beside the pages that has the keyboard: what it is told in the menu is for it.
QPlainTextEdit* typedIn() { return qobject_cast<QPlainTextEdit*>(controls::keyboardWidget()); }

std::function<void()> orInText(void (QPlainTextEdit::*inText)(),
                               const std::function<void()>& inPages) {
    return [inText, inPages] {
        if (QPlainTextEdit* text = typedIn())
            (text->*inText)();
        else
            inPages();
    };
}

} // namespace

EditMenu::EditMenu(view::DocumentView& view, panes::FindBar& find, QWidget* parent)
    : QMenu(tr("&Edit"), parent), view_(view) {
    document::Document& of = view_.document().document();
    undo_ = menus::addTo(*this, "undo", tr("&Undo"), QKeySequence::Undo, [this] { undo(); });
    redo_ =
        menus::addTo(*this, "redo", tr("&Redo"), QKeySequence("Ctrl+Shift+Z"), [this] { redo(); });
    redo_->setShortcuts({QKeySequence("Ctrl+Shift+Z"), QKeySequence("Ctrl+Y")});
    addSeparator();
    cut_ = menus::addTo(*this, "cut", tr("Cu&t"), QKeySequence::Cut,
                        orInText(&QPlainTextEdit::cut, [this] {
                            if (view_.isWriting())
                                view_.writing().cut();
                        }));
    copy_ = menus::addTo(*this, "copy", tr("&Copy"), QKeySequence::Copy,
                         orInText(&QPlainTextEdit::copy, [this] { view_.copy(); }));
    paste_ = menus::addTo(*this, "paste", tr("&Paste"), QKeySequence::Paste,
                          orInText(&QPlainTextEdit::paste, [this] {
                              if (view_.isWriting())
                                  view_.writing().paste(*QApplication::clipboard()->mimeData());
                          }));
    cut_->setShortcuts({QKeySequence(QKeySequence::Cut), QKeySequence("Shift+Del")});
    copy_->setShortcuts({QKeySequence(QKeySequence::Copy), QKeySequence("Ctrl+Ins")});
    paste_->setShortcuts({QKeySequence(QKeySequence::Paste), QKeySequence("Shift+Ins")});
    selectAll_ = menus::addTo(*this, "selectAll", tr("Select &All"), QKeySequence::SelectAll,
                              orInText(&QPlainTextEdit::selectAll, [this] { view_.selectAll(); }));
    addSeparator();
    write_ = menus::addTo(
        *this, "write", tr("&Write"), QKeySequence("Ctrl+E"),
        [this] { view_.setWriting(write_->isChecked()); }, "document-edit");
    write_->setCheckable(true);
    write_->setToolTip(tr("Write in the document (Ctrl+E)"));
    addSigns();
    addSeparator();
    addFinding(find);
    replace_ = menus::addTo(*this, "replaceWords", tr("R&eplace..."), QKeySequence("Ctrl+H"),
                            [&find] { find.openReplace(); });
    addSeparator();
    menus::addTo(*this, "wordCount", tr("W&ord Count..."), {},
                 [this] { (new panes::TextCountDialog(view_, parentWidget()))->open(); });
    connect(&of, &document::Document::undoChanged, this, &EditMenu::updateUndo);
    connect(&view_, &view::DocumentView::selectionChanged, this, &EditMenu::updateSelection);
    connect(&view_, &view::DocumentView::writingChanged, this, &EditMenu::updateSelection);
    connect(this, &QMenu::aboutToShow, this, &EditMenu::updateSelection);
    connect(this, &QMenu::aboutToShow, this, &EditMenu::updateUndo);
    (void)controls::keyboardWidget(); // is followed from now on
    updateUndo();
    updateSelection();
}

// A text beside the pages has a line of its own for what is looked for in it.
void EditMenu::addFinding(panes::FindBar& find) {
    const auto add = [this](const char* name, const QString& text, const QKeySequence& keys,
                            const std::function<void()>& inPages,
                            const std::function<void(source::FindLine&)>& inText) {
        menus::addTo(*this, name, text, keys, [inPages, inText] {
            if (source::FindLine* line = source::FindLine::of(controls::keyboardWidget()))
                inText(*line);
            else
                inPages();
        });
    };
    add(
        "find", tr("&Find..."), QKeySequence::Find, [&find] { find.open(); },
        [](source::FindLine& line) { line.open(); });
    add(
        "findNext", tr("Find &Next"), QKeySequence(Qt::Key_F3), [&find] { find.next(1); },
        [](source::FindLine& line) { line.next(1); });
    add(
        "findPrevious", tr("Find Pre&vious"), QKeySequence(Qt::SHIFT | Qt::Key_F3),
        [&find] { find.next(-1); }, [](source::FindLine& line) { line.next(-1); });
}

// The user's wish, for all windows that open from now on.
void EditMenu::addSigns() {
    static constexpr auto setting = "typographicSigns";
    QAction* signs = menus::addTo(*this, setting, tr("T&ypographic Signs While Typing"), {}, {});
    signs->setCheckable(true);
    connect(signs, &QAction::toggled, this, [this](bool on) {
        QSettings().setValue(setting, on);
        view_.writing().setMakesSigns(on);
    });
    signs->setChecked(QSettings().value(setting, true).toBool());
}

// A text beside the pages may have an undo of its own.
void EditMenu::undo() {
    if (QPlainTextEdit* text = typedIn(); text && text->isUndoRedoEnabled())
        text->undo();
    else
        view_.document().document().undo();
}

void EditMenu::redo() {
    if (QPlainTextEdit* text = typedIn(); text && text->isUndoRedoEnabled())
        text->redo();
    else
        view_.document().document().redo();
}

void EditMenu::updateUndo() {
    const document::Document& of = view_.document().document();
    const QPlainTextEdit* text = typedIn();
    const QTextDocument* own = text && text->isUndoRedoEnabled() ? text->document() : nullptr;
    undo_->setEnabled(own ? own->isUndoAvailable() : of.canUndo());
    redo_->setEnabled(own ? own->isRedoAvailable() : of.canRedo());
    if (own) {
        undo_->setText(tr("&Undo"));
        redo_->setText(tr("&Redo"));
        return;
    }
    undo_->setText(of.canUndo() ? tr("&Undo %1").arg(plain::caption(of.undoLabel())) : tr("&Undo"));
    redo_->setText(of.canRedo() ? tr("&Redo %1").arg(plain::caption(of.redoLabel())) : tr("&Redo"));
}

// A figure that is chosen is copied and cut as a whole.
void EditMenu::updateSelection() {
    const bool writes = view_.isWriting();
    write_->setChecked(view_.isWriting());
    const QPlainTextEdit* text = typedIn();
    cut_->setEnabled(text ? !text->isReadOnly() : writes && view_.canCopy());
    paste_->setEnabled(text ? !text->isReadOnly() : writes);
    replace_->setEnabled(writes);
    copy_->setEnabled(text || view_.canCopy());
    selectAll_->setEnabled(text || !view_.chosen());
}

void EditMenu::showAt(const QPoint& at) {
    auto* menu = new QMenu(parentWidget());
    menu->setObjectName("textMenu");
    menu->setAttribute(Qt::WA_DeleteOnClose);
    Q_EMIT aboutToShowAt(*menu, at);
    menu->addActions(view_.isWriting() ? QList<QAction*>{cut_, copy_, paste_, selectAll_}
                                       : QList<QAction*>{copy_, selectAll_});
    for (const auto& [more, isOfUse] : atPointer_)
        if (view_.isWriting() && isOfUse())
            menu->addMenu(more);
    menu->popup(at);
}

void EditMenu::offerAtPointer(QMenu& menu, std::function<bool()> isOfUse) {
    atPointer_.emplace_back(&menu, std::move(isOfUse));
}

} // namespace window
