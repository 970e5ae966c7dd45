// The menu Figure: what may be done with the figure that is chosen, or whose caption has the caret,
// whatever medium shows it.
//
// The menu is there while the document has figures. Without such a figure, its first entry
// says what to do. An entry that may not be done is grey, and its tip says why: the view is read
// and not written, the medium has no time or no files.
#pragma once

#include "session/open_document.h"
#include "view/writing.h"

#include <QMenu>

namespace view {
class DocumentView;
}

namespace menus {

// The window of its medium in which a figure is built, where there is one.
void openEditor(view::DocumentView& view, document::SubdocumentId id);

class FigureMenu : public QMenu {
    Q_OBJECT

public:
    // The view outlives it.
    FigureMenu(view::DocumentView& view, QWidget* parent);

    // At the pointer: the medium's own menu, if there is one, and below it this one.
    void showAt(const QPoint& at, QMenu* ofMedium);

private:
    struct Entry {
        QAction* action = nullptr;
        std::function<QString()> whyNot; // a sentence; "": it may be done
    };
    void add(const QString& name, const QString& text, std::function<QString()> whyNot,
             std::function<void()> done);
    void offer();
    void offerPresentations();
    [[nodiscard]] document::SubdocumentId id() const;
    [[nodiscard]] const document::Subdocument* figure() const; // null: there is none
    [[nodiscard]] const media::Manifest* manifest() const;     // null: it is not installed
    [[nodiscard]] media::LiveSubdocument* live() const;
    [[nodiscard]] QString whyNotChosen() const;
    [[nodiscard]] QString whyNotWritten() const;
    [[nodiscard]] QString whyNotEdited() const;
    [[nodiscard]] QString whyNoCaption() const;
    [[nodiscard]] QString whyNoMoment() const;
    [[nodiscard]] view::Writing::Command caption() const; // of its caption
    [[nodiscard]] QString whyNoText() const;
    void setAttributes(const authoring::Attributes& attributes, const QString& label);
    void addAlignment(document::Placement placement, const QString& name, const QString& text);
    void askForSize();
    void askForAlternative();
    void takeMoment();
    void saveCopy();
    void replace();

    view::DocumentView& view_;
    QAction* hint_;
    QMenu* presentations_ = nullptr;
    std::vector<Entry> entries_;
    std::vector<std::pair<QAction*, document::Placement>> alignments_;
};

} // namespace menus
