// The footnotes of a page, and what of them goes on to the next.
//
// A note is a flow like the text: it stands on the page of its mark as far as there is room, and
// the rest at the foot of the following pages, before the notes of their own marks.
#pragma once

#include "layout/cells.h"

#include <deque>
#include <map>

namespace layout {

class Notes {
public:
    using Footnote = std::shared_ptr<const document::Footnote>;
    explicit Notes(const Surroundings& in) : in_(in) {}

    // How high these notes are together; more than `most` is not measured further. `least`: what of
    // them must stand on the page of their marks.
    struct Wanted {
        double all = 0, least = 0;
    };
    [[nodiscard]] Wanted wanted(const std::vector<Footnote>& notes, double most);

    // A mark was put on the page.
    void mark(const Footnote& note) { waiting_.push_back(note); }
    // Puts as much of the notes as `room` takes, one strip at least when `forced`. The room is that
    // of all notes of the page.
    void fill(double room, bool forced);
    [[nodiscard]] bool isWaiting() const { return !waiting_.empty(); } // some go on
    [[nodiscard]] bool isEmpty() const { return height_ == 0; }
    [[nodiscard]] double height() const { return height_; } // on this page
    // Their pieces, the top left of the page's notes at the origin; the next page begins.
    [[nodiscard]] std::vector<Piece> take();

private:
    struct Note {
        Flow flow;
        std::deque<Strip> ready;
        double height = 0; // of these, and of what was taken before
        double after = 0;  // of the last that was taken
        bool begun = false, ended = false;
    };
    Note& opened(const Footnote& note);
    static bool makeReady(Note& note, double height);

    Surroundings in_;
    std::map<Footnote, Note> open_;
    std::deque<Footnote> waiting_;
    std::vector<Piece> pieces_;
    double height_ = 0;
};

} // namespace layout
