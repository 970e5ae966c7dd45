// The part of a model's text that lies in an interval of the document's bytes.
#pragma once

#include "model/model.h"
#include "sgml/tree.h"

namespace model {

// The bytes of a run's text between two places of the document.
struct SelectedRun {
    text::Range bytes{};
    bool isIn = false; // some of it is; an empty run, or a figure in the line, is as a whole
    bool operator==(const SelectedRun&) const = default;
};

// The bytes of the document that a run's text stands for, its ends as places; of one without
// content: where its element is.
class RunPlaces {
public:
    explicit RunPlaces(const sgml::Tree& tree) : tree_(tree) {}

    [[nodiscard]] bool isText(const Run& run) const {
        return run.content != sgml::noNode && tree_.holds(run.content) &&
               tree_.node(run.content).kind == sgml::NodeKind::content;
    }
    // An element that is one sign for who writes: a formula, a footnote's mark, a reference. Its
    // places are those before and behind the element.
    [[nodiscard]] bool isUnit(const Run& run) const {
        return run.element != sgml::noNode && tree_.holds(run.element) &&
               run.kind != RunKind::lineBreak && (run.kind != RunKind::text || run.refers);
    }
    [[nodiscard]] text::Range rangeOf(const Run& unit) const {
        return tree_.node(unit.element).range;
    }
    // Of a run that is text: the place before a byte of its text, and the byte behind a place that
    // lies in it; places outside are those of its ends.
    [[nodiscard]] std::size_t placeOf(const Run& run, std::size_t byte) const;
    [[nodiscard]] std::size_t byteAt(const Run& run, std::size_t place) const;

private:
    [[nodiscard]] const sgml::Unescaped& unescaped(sgml::NodeId content) const;

    const sgml::Tree& tree_;
    mutable sgml::NodeId last_ = sgml::noNode;
    mutable sgml::Unescaped unescaped_; // of the last one
};

// For each run of the block. A unit is selected where its element lies in the interval. Generated
// text is selected with the text on both its sides; at the block's ends with the text beside it, if
// the interval reaches over that end.
[[nodiscard]] std::vector<SelectedRun> selectedRuns(const RunPlaces& places, const Block& block,
                                                    text::Range interval);

// The selected part of a model: blocks cut where the interval ends, figures and rules that lie in
// it, of a table the rows with something in it. A marker is there when its block's beginning is.
// Of a footnote that is selected with its mark all is there; the text of another one that is
// selected alone stands behind the blocks. Boxes are left out.
[[nodiscard]] Model excerpt(const sgml::Tree& tree, const Model& model, text::Range interval);

} // namespace model
