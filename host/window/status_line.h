// The line below the pages: what was said last, the page, the zoom, and the language in which words
// are checked. A figure's message goes when another one is active, or none.
#pragma once

#include "view/document_view.h"

class QLabel;
class QStatusBar;

namespace window {

class StatusLine : public QObject {
    Q_OBJECT

public:
    // Both outlive it.
    StatusLine(view::DocumentView& view, QStatusBar& bar, QObject* parent);

    void say(const QString& sentence);
    // "": the figure has no more to say; a sentence of others stays.
    void sayOf(document::SubdocumentId figure, const QString& sentence);
    void showLanguage(const QString& name); // "": words are not checked

private:
    void showPlace();
    void followActive();

    view::DocumentView& view_;
    QStatusBar& bar_;
    QLabel* language_;
    QLabel* page_;
    QLabel* zoom_;
    document::SubdocumentId speaker_ = document::noSubdocument; // of what was said last
};

} // namespace window
