// Places in a document's bytes that follow every edit, undo and redo: a caret, the ends of a
// selection, hits of a search, the place where somebody reads.
//
// A place stands between two bytes and stays beside both. Where one of them goes, it stays beside
// the other; where both go, and where text is inserted between them, its gravity decides on which
// side of the new text it comes to stand.
#pragma once

#include "document/document.h"

#include <memory>
#include <vector>

namespace document {

enum class Gravity {
    before, // of new text
    behind,
};

// Where a place is after edits.
[[nodiscard]] std::size_t followed(std::size_t offset, Gravity gravity, const sgml::Edits& edits);

// LIMIT: every change moves every place; a thousand hits of a search take some microseconds.
class Tracker : public QObject {
    Q_OBJECT

public:
    struct Place {
        std::size_t offset = 0;
        Gravity gravity = Gravity::behind;
    };

    // The document outlives the tracker.
    explicit Tracker(const Document& document);

    // Followed as long as somebody holds it.
    [[nodiscard]] std::shared_ptr<const Place> track(std::size_t offset, Gravity gravity);
    // How many are held.
    [[nodiscard]] std::size_t size() const;

private:
    void follow(const sgml::Edits& edits);

    std::vector<std::weak_ptr<Place>> places_;
};

} // namespace document
