// Puts strips onto pages (see pages.h).
#pragma once

#include "layout/frames.h"
#include "layout/notes.h"
#include "layout/pages.h"

#include <array>

namespace layout {

class Paginator {
public:
    Paginator(const document::Model& model, const Objects& objects);

    [[nodiscard]] bool step();
    [[nodiscard]] const Pages& pages() const { return pages_; }
    [[nodiscard]] Pages take() { return std::move(pages_); }

private:
    // Strips that must stand on one page, if they fit.
    struct Group {
        std::vector<Strip> strips;
        double height = 0; // without what stands above it, without notes
        bool mayFloat = false;
    };
    enum class Stage { text, rest, headers, done };

    [[nodiscard]] Made readGroup();
    void append(Strip strip);
    [[nodiscard]] double gapBefore(const Strip& strip) const;
    [[nodiscard]] bool fits(const Group& group);
    [[nodiscard]] bool mayBegin(const Group& group);
    [[nodiscard]] bool fits(double height, const std::vector<Notes::Footnote>& notes);
    [[nodiscard]] double roomBelow() const;
    [[nodiscard]] double pageHeight() const { return bottom_ - top_; }
    [[nodiscard]] bool atTop() const { return y_ == top_; }
    [[nodiscard]] bool isFresh() const { return atTop() && notes_.isEmpty(); }

    void placeOrFloat(Group group);
    void placeFloats();
    void place(const Group& group);
    void placeOn(const Strip& strip);
    void placeCells(const Strip& strip);
    void remember(const Strip& strip);
    void put(const Strip& strip, bool first, bool last);
    void put(const Piece& piece);
    void fillNotes(bool forced);
    void newPage();
    void finishPage();
    void addNotes();
    void addHeaders(std::size_t page);
    void addLine(std::size_t page, const std::string& pattern, document::Align align, double y);

    const document::Model& model_;
    Pages pages_;
    double left_ = 0, top_ = 0, bottom_ = 0, width_ = 0;
    Surroundings in_;
    Flow flow_;
    Notes notes_;
    Frames frames_;
    Group group_;                // that is being read
    std::optional<Strip> ahead_; // read, and of the next group
    bool tooTall_ =
        false; // the group that is being read is taller than a page: each strip for itself
    std::deque<Group> floats_;
    double y_ = 0, after_ = 0;
    std::vector<Placed> placed_; // on the page that is being filled
    Stage stage_ = Stage::text;
    std::size_t headed_ = 0; // pages that have their headers
};

} // namespace layout
