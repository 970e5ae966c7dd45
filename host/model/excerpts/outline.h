// The entries of a document, for a list to go by: its headings, figures and tables.
//
// An outline follows the models of a document. It reads the blocks that are not those of the model
// before, and keeps the entries of the others. LIMIT: elements in a table's cell or in a footnote
// are not listed.
#pragma once

#include "model/model.h"

namespace model {

class Outline {
public:
    enum class Kind { heading, figure, table };
    struct Entry {
        Kind kind = Kind::heading;
        int level = 1;    // of a heading
        std::string text; // with its number; a figure's or a table's is its caption, or what it is
        sgml::NodeId element = sgml::noNode; // the heading's own
        bool operator==(const Entry&) const = default;
    };

    // In order of their places; all kinds together.
    [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
    // False: all entries are as they were.
    bool follow(const std::shared_ptr<const Model>& model);
    // Since it was made, for tests.
    [[nodiscard]] std::size_t blocksRead() const { return blocksRead_; }

private:
    // The blocks that an entry is of.
    struct Place {
        std::size_t first = 0, last = 0;
        std::size_t container = 0; // of a figure or table
    };
    struct Range {
        std::size_t from = 0, to = 0;
    };
    void addHeadings(const Model& model, Range blocks);
    void addContainer(const Model& model, std::size_t index);
    void add(Place place, Entry entry);
    void sort();

    std::shared_ptr<const Model> model_;
    std::vector<Entry> entries_;
    std::vector<Place> places_; // of the entries
    std::size_t blocksRead_ = 0;
};

} // namespace model
