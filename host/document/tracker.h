// Places in a document's bytes that follow every edit, undo and redo: a caret, the ends of a
// selection, hits of a search, the place where somebody reads.
//
// A place stands between two bytes; text::Gravity says on which side of new text it comes to stand.
#pragma once

#include "document/document.h"

#include <memory>
#include <vector>

namespace document {

// LIMIT: every change moves every place; a thousand hits of a search take some microseconds.
class Tracker : public QObject {
    Q_OBJECT

public:
    struct Place {
        std::size_t offset = 0;
        text::Gravity gravity = text::Gravity::behind;
    };

    // The document outlives the tracker.
    explicit Tracker(const Document& document);

    // Followed as long as somebody holds it.
    [[nodiscard]] std::shared_ptr<const Place> track(std::size_t offset, text::Gravity gravity);
    // How many are held.
    [[nodiscard]] std::size_t size() const;

private:
    void follow(const text::Edits& edits);

    std::vector<std::weak_ptr<Place>> places_;
};

} // namespace document
