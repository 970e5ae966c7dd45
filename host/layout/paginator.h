// Puts strips onto pages (see pages.h).
#pragma once

#include "layout/old_pages.h"
#include "layout/page_plan.h"

#include <deque>

namespace layout {

class Paginator {
public:
    Paginator(const ModelPointer& model, const paragraphs::Objects& objects, const Pages& old);

    [[nodiscard]] bool step();
    [[nodiscard]] Pages pages() const;
    [[nodiscard]] std::size_t count() const { return pages_.pages.size(); }
    [[nodiscard]] Pages take();

private:
    enum class Stage { read, begin, afterBreak, consider, afterFull, place, rest, done };
    struct Filling { // the page that is being filled
        std::shared_ptr<Page> page;
        std::vector<Placed> placed;
        double y = 0, after = 0;
        double top = 0; // below a header that is repeated
    };

    void follow(const OldPages::Part& part);
    void resume(const PageStart& start);
    [[nodiscard]] Group groupAt(const GroupStart& start);
    [[nodiscard]] Stage readGroup();
    [[nodiscard]] Stage considerGroup();
    [[nodiscard]] Stage placeHand();

    [[nodiscard]] double gapBefore(const Strip& strip) const;
    [[nodiscard]] bool fits(const Group& group);
    [[nodiscard]] bool mayBegin(const Group& group);
    [[nodiscard]] bool fits(double height, const std::vector<Notes::Pointer>& notes);
    // Of the group, from that strip on: it and the lines that it does not part from.
    [[nodiscard]] bool fits(const Group& group, std::size_t strip);
    [[nodiscard]] bool fits(const Strip& strip) {
        return fits(gapBefore(strip) + strip.height, strip.footnotes);
    }
    [[nodiscard]] double roomBelow() const;
    [[nodiscard]] bool atTop() const { return filling_.y == filling_.top; }
    [[nodiscard]] bool isFresh() const { return atTop() && notes_.isEmpty(); }

    void placeFloats();
    void placeStrip(const Strip& strip);
    void placeCells(const Strip& strip);
    void remember(const Strip& strip);
    void rememberRows(const Strip& strip);
    void repeatHeader(const Strip& strip);
    void put(const Strip& strip, bool first, bool last);
    void put(const Piece& piece, const model::Block* block);
    void fillNotes(bool forced);
    void newPage(PageStart::Next next);
    void beginPage(const PageStart& start);
    void finishPage();
    void addNotes();

    TextArea area_;
    Pages pages_;
    std::shared_ptr<Basis> basis_;
    OldPages old_;
    Surroundings in_;
    Groups groups_;
    Notes notes_;
    PagePlan plan_;
    std::deque<Group> floats_;
    Group hand_;            // that was read last
    std::size_t strip_ = 0; // of it, the next one
    Filling filling_;
    Stage stage_ = Stage::read;
    bool pageBegun_ = false;
};

} // namespace layout
