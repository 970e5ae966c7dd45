// The caret in a document's source and the place in its pages, each of which leads while it has the
// keyboard.
//
// The pages lead: the source shows their caret and what is selected, or, when that is out of sight,
// the line that one reads at their top. The source leads: the pages show the same place, select
// what is selected, and mark the paragraph, element or figure that the caret is in.
#pragma once

#include "source/document_mirror.h"
#include "source/source_edit.h"
#include "view/document_view.h"

namespace source {

class InStep : public QObject {
    Q_OBJECT

public:
    // All outlive it.
    InStep(view::DocumentView& view, SourceEdit& edit, DocumentMirror& mirror);

    // The range that is marked in the pages; empty: nothing.
    [[nodiscard]] text::Range marked() const { return marked_; }
    // The source begins where the pages are, as soon as it is there.
    void beginAtPages();
    // The keyboard goes to the pages, the caret of a writing view to the place.
    void goToPages();

private:
    void followPages();
    void followSource();
    void showInSource(std::size_t place);
    void showInPages(const document::Selection& selection);
    void markAround(std::size_t offset);
    void paint(QPainter& painter, std::size_t page) const;
    // The medium's subdocument that holds the byte; noSubdocument: it is in text.
    [[nodiscard]] document::SubdocumentId figureAt(std::size_t offset) const;

    view::DocumentView& view_;
    SourceEdit& edit_;
    DocumentMirror& mirror_;
    QTimer pagesLead_, sourceLeads_;
    text::Range marked_{};
    bool isTyping_ = false;
    bool isBeginning_ = false;
};

} // namespace source
