#include "editing/point_lists.h"

#include "script/numbers.h"

#include <algorithm>

namespace editing {

namespace {

// A word of a command or an element of a list: the same to whom looks for options.
struct Piece {
    scene::Range range, content;
    bool literal = false;
};

bool isPoint(const std::string& value) {
    const script::ElementList numbers = script::elementsOf(value, 5);
    const std::size_t n = numbers.elements.size();
    return numbers.fault.empty() && (n == 3 || n == 4) &&
           std::ranges::all_of(numbers.elements, [](const script::Element& e) {
               return script::decimalNumber(e.value).has_value();
           });
}

class Finder {
public:
    Finder(std::string_view text, std::size_t longerThan) : text_(text), longerThan_(longerThan) {}

    void look(const script::Command& command) {
        const std::string_view name = command.name(text_);
        std::vector<Piece> pieces;
        for (const script::Word& word : command.words)
            pieces.push_back({word.range, word.content, word.literal && !word.expanded});
        if (name == "trajectory" || name == "shape_set" || name == "list")
            look(pieces);
        else if (name == "set" && pieces.size() == 3 && pieces[2].literal)
            lookAtVariable(pieces[2]);
    }

    std::vector<PointList> take() {
        std::ranges::sort(found_, {}, [](const PointList& list) { return list.range.from; });
        return std::move(found_);
    }

private:
    void look(const std::vector<Piece>& pieces) {
        for (std::size_t i = 0; i + 1 < pieces.size(); ++i) {
            const std::string_view option = slice(pieces[i].range);
            const Piece& value = pieces[i + 1];
            if (!value.literal)
                continue;
            if (option == "-points" || option == "-bezier")
                add(value.range, option == "-points" ? Listed::points : Listed::curves,
                    elements(value).size());
            else if (option == "-desc" || option == "-sub")
                look(inside(value));
            else if (option == "-face")
                i = faces(pieces, i);
        }
    }

    // Faces from the i-th piece on; returns the last piece of the last.
    std::size_t faces(const std::vector<Piece>& pieces, std::size_t i) {
        const std::size_t first = i;
        std::size_t count = 0;
        while (i + 1 < pieces.size() && slice(pieces[i].range) == "-face" &&
               pieces[i + 1].literal) {
            ++count;
            i += 2;
        }
        add({pieces[first].range.from, pieces[i - 1].range.to}, Listed::faces, count);
        return i - 1;
    }

    void lookAtVariable(const Piece& value) {
        const auto all = elements(value);
        if (all.size() > 2 &&
            std::ranges::all_of(all, [](const script::Element& e) { return isPoint(e.value); }))
            add(value.range, Listed::points, all.size());
    }

    void add(scene::Range range, Listed what, std::size_t count) {
        if (range.to - range.from > longerThan_ && count > 0)
            found_.push_back({range, what, count});
    }

    [[nodiscard]] std::vector<script::Element> elements(const Piece& piece) const {
        script::ElementList list = script::elementsOf(slice(piece.content));
        return list.fault.empty() ? std::move(list.elements) : std::vector<script::Element>();
    }
    [[nodiscard]] std::vector<Piece> inside(const Piece& piece) const {
        std::vector<Piece> pieces;
        const std::size_t at = piece.content.from;
        for (const script::Element& e : elements(piece))
            pieces.push_back({{at + e.range.from, at + e.range.to},
                              {at + e.content.from, at + e.content.to},
                              e.literal});
        return pieces;
    }
    [[nodiscard]] std::string_view slice(scene::Range range) const {
        return text_.substr(range.from, range.to - range.from);
    }

    std::string_view text_;
    std::size_t longerThan_;
    std::vector<PointList> found_;
};

} // namespace

std::vector<PointList> pointListsOf(std::string_view text, const script::Structure& structure,
                                    std::size_t longerThan) {
    Finder finder(text, longerThan);
    for (const script::Command& command : structure.commands)
        finder.look(command);
    return finder.take();
}

} // namespace editing
