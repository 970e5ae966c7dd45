// Places in a document's bytes that follow every edit, undo and redo: a caret, the ends of a
// selection, hits of a search, the place where somebody reads.
//
// A place stands between two bytes; text::Gravity says on which side of new text it comes to stand.
// A place in bytes that an edit took away is back among them when they are back by undo, and one in
// text that undo took away is back by redo.
#pragma once

#include "document/document.h"

#include <cstdint>
#include <map>
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
    // A place, and where it stood before changes, by their numbers, which only the change itself
    // knows to bring back.
    struct Tracked {
        Place place;
        std::map<std::uint64_t, std::size_t> lost{};
    };
    void follow(const text::Edits& edits, const text::Edits& back, std::uint64_t number);

    std::vector<std::weak_ptr<Tracked>> places_;
};

} // namespace document
