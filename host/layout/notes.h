// The footnotes of a page, and what of them goes on to the next.
//
// A note is a flow like the text: it stands on the page of its mark as far as there is room, and
// the rest at the foot of the following pages, before the notes of their own marks.
#pragma once

#include "strips/cells.h"

#include <deque>
#include <map>

namespace layout {

class Notes {
public:
    using Pointer = std::shared_ptr<const model::Footnote>;
    explicit Notes(const Surroundings& in) : in_(in) {}

    // How high these notes are together; more than `most` is not measured further. `least`: what of
    // them must stand on the page of their marks.
    struct Wanted {
        double all = 0, least = 0;
    };
    [[nodiscard]] Wanted wanted(const std::vector<Pointer>& notes, double most);

    // A mark was put on the page, in that block of the model.
    void mark(const Pointer& note, const model::Block* block);
    // Puts as much of the notes as `room` takes, one strip at least when `forced`. The room is that
    // of all notes of the page.
    void fill(double room, bool forced);
    [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); } // some go on
    [[nodiscard]] bool isEmpty() const { return height_ == 0; }
    [[nodiscard]] double height() const { return height_; } // on this page
    // Their pieces, the top left of the page's notes at the origin; the next page begins.
    struct Taken {
        Piece piece;
        const model::Block* block = nullptr; // of its mark
    };
    [[nodiscard]] std::vector<Taken> take();

    // A note that goes on to the next page, between two pages.
    struct Waiting {
        Pointer note;
        Flow::Place at;                      // what of it comes next
        const model::Block* block = nullptr; // of its mark
        bool operator==(const Waiting&) const = default;
    };
    // Nothing: a row of a table in a note is divided.
    [[nodiscard]] std::optional<std::vector<Waiting>> waiting() const;
    void resume(const std::vector<Waiting>& waiting);

private:
    struct Note {
        Flow flow;
        std::deque<Strip> ready;
        std::deque<Flow::Place> places{}; // of these
        double height = 0;                // of these, and of what was taken before
        double after = 0;                 // of the last that was taken
        bool begun = false, ended = false, divided = false;
    };
    Note& opened(const Pointer& note);
    static bool makeReady(Note& note, double height);

    Surroundings in_;
    std::map<Pointer, Note> open_;
    std::deque<std::pair<Pointer, const model::Block*>> waiting_; // and the block of its mark
    std::vector<Taken> pieces_;
    double height_ = 0;
};

} // namespace layout
