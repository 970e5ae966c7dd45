// The sections of a model by their headings, and the model without what a reader has folded of it.
//
// Numbers, names and references are those of the whole: it alone is made from the document, and
// what is not folded are its own blocks. So a layout that has followed the whole follows this, too.
#pragma once

#include "model/model.h"

namespace model {

// A heading and what is under it: up to the next one of its level or a higher one, and no further
// than the element with the role `section` that it is in.
struct Section {
    std::size_t heading = 0; // its block
    std::size_t last = 0;    // the last block; the heading itself: nothing is under it
    [[nodiscard]] bool isEmpty() const { return last == heading; }
    bool operator==(const Section&) const = default;
};

// In order of their headings.
[[nodiscard]] std::vector<Section> sectionsOf(const Model& model);

// How much is under a heading.
struct SectionCounts {
    std::size_t sections = 0, paragraphs = 0, figures = 0, tables = 0;
    bool operator==(const SectionCounts&) const = default;
};
[[nodiscard]] SectionCounts countsOf(const Model& model, const Section& section);

class Folding {
public:
    // Without what is under these headings, which come in order. A heading has the anchors of what
    // it hides, so that pages can be told for them. The footnotes are those of the whole.
    [[nodiscard]] std::shared_ptr<const Model> folded(const Model& whole,
                                                      const std::vector<Section>& sections);

private:
    using Pointer = Blocks::value_type;
    struct Heading {
        Pointer whole, shown;
    };
    [[nodiscard]] Pointer headingOf(const Model& whole, const Section& section);

    std::vector<Heading> headings_; // of the last one: those that are equal are the same again
};

} // namespace model
