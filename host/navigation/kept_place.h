// The place where one read a document, its size and folds, and the place where one wrote: it opens
// so again. Kept in the program's settings by the document's file.
#pragma once

#include "view/document_view.h"

namespace navigation {

class KeptPlace : public QObject {
    Q_OBJECT

public:
    // Of the view of a window that opens: folds, goes to the place when the view is shown and its
    // pages reach that far, unless the reader has scrolled meanwhile. Keeps it when the view is
    // hidden.
    explicit KeptPlace(view::DocumentView& view, QObject* parent = nullptr);

    // LIMIT: documents whose places are kept; the one that was read longest ago is forgotten.
    static constexpr int most = 100;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    struct Kept {
        view::ReadingPlace place;
        std::size_t page = 0;
        double zoom = 1;
        std::optional<std::size_t> caret; // of a view in which one wrote
    };
    void recall();
    void restore();
    void writeAgain(const Kept& kept);
    void keep() const;

    view::DocumentView& view_;
    std::optional<Kept> wanted_; // to be shown
};

} // namespace navigation
