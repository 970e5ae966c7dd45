// Of a page that is to be filled like those behind it (balance.h): where the next one begins.
#pragma once

#include "layout/notes.h"
#include "strips/groups.h"

namespace layout {

class PagePlan {
public:
    // All of it is read as long as this lives.
    PagePlan(const Surroundings& in, const model::Model& model, Notes& notes);

    // A page begins with that group.
    void begin(const GroupStart& first);
    void forget(); // a page begins otherwise, and is filled as far as it goes
    [[nodiscard]] bool beginsNext(const GroupStart& group) const { return next_ == group.at; }
    // So many blocks were read for it.
    [[nodiscard]] std::size_t reached() const { return reached_; }

private:
    [[nodiscard]] double costOf(const Strip& first) const;
    [[nodiscard]] double notesOf(const Group& group);

    double pageHeight_ = 0;
    const model::Model& model_;
    Notes& notes_;
    Groups ahead_;
    std::vector<bool> goesOnInList_; // of each block: the list has begun before it
    std::optional<Flow::Place> next_;
    std::size_t reached_ = 0;
};

} // namespace layout
