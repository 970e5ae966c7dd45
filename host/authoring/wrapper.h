// Puts text between the marks of a draft into elements of one kind, or takes it out of them.
#pragma once

#include "authoring/draft.h"

#include <functional>
#include <set>

namespace authoring {

class Wrapper {
public:
    // Is an inlined element one of that kind?
    using Wanted = std::function<bool(const Piece& element)>;
    Wrapper(Draft& draft, Wanted wanted);

    [[nodiscard]] bool hasText() const { return !texts_.empty(); }
    [[nodiscard]] bool isAllInside() const;
    void unwrap();
    void wrap(const std::string& name, const std::string& attributes);

private:
    void collect(Piece& piece);
    [[nodiscard]] static bool holdsMark(const Piece& piece);
    [[nodiscard]] bool isInProse(Piece& text) const;
    [[nodiscard]] Piece* wrapperOf(const Piece& text) const;
    void wrap(Piece& text, const std::string& name, const std::string& attributes);
    Piece& isolate(Piece& piece, Piece& stop);
    void separate(Piece& at, Direction direction);

    Draft& draft_;
    Wanted wanted_;
    std::set<sgml::NodeId> passed_; // cells of a table beside those that are selected
    std::size_t marks_ = 0;         // passed
    std::vector<Piece*> texts_, made_;
};

} // namespace authoring
