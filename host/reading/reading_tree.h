// A document for those who hear it: parts within parts, and what each of them is.
//
// The parts of a model are its containers and blocks, the cells of its tables, its footnotes, and
// what stands in a line and is more than letters: links, formulas, figures. The parts inside one
// are made when somebody asks for them. The tree follows the models of a document, and a part stays
// the same as long as its element does: who listens to a paragraph hears what is typed in it. A
// letter costs the part that it is typed in, besides a comparison of pointers for each block.
#pragma once

#include "document/document.h"
#include "model/model.h"

#include <functional>

namespace reading {

using model::Block, model::Blocks, model::Containers, model::Footnote, model::Model;

// Blocks that stand together: of a document, a cell, a footnote, the entries of contents.
struct Flow {
    const Blocks* blocks = nullptr;
    const Containers* containers = nullptr;
};

struct Part {
    enum class Kind {
        document,
        container, // section, list, item, figure, quote; a table with its caption
        text,      // a block of letters; a caption or an item that is no more than one
        contents,  // a list of its entries
        formula,
        figure, // a subdocument, an image, a chart
        separator,
        table,
        cell,
        note,
        link, // in a line, as formulas and figures may be
    };
    // Data that the user of a tree keeps with a part: gone with it.
    struct Companion {
        Companion() = default;
        Companion(const Companion&) = delete;
        Companion& operator=(const Companion&) = delete;
        virtual ~Companion() = default;
    };

    Kind kind = Kind::document;
    schemas::ContainerRole role = schemas::ContainerRole::none;
    int level = 0; // of a container with its role; of a heading
    sgml::NodeId element = sgml::noNode;
    std::shared_ptr<const Block> block{};   // that it is, or that its line is in
    std::size_t run = 0, runs = 0;          // in a line: which of the block's, and how many
    std::shared_ptr<const Footnote> note{}; // a footnote
    document::GridCell place{};             // a cell: in its table
    std::size_t size = 0;                   // of its parent's flow so many blocks are its own
    Flow flow{};                            // that stands in it, if it has one of its own
    Part* parent = nullptr;
    bool isOpen = false; // its parts are made
    std::vector<std::unique_ptr<Part>> parts{};
    std::unique_ptr<Companion> companion{};
};

class ReadingTree {
public:
    explicit ReadingTree(const document::Document& document);

    [[nodiscard]] Part& root() { return root_; }
    [[nodiscard]] const std::shared_ptr<const Model>& model() const { return model_; }
    // Its parts, made now if nobody asked for them before.
    [[nodiscard]] const std::vector<std::unique_ptr<Part>>& partsOf(Part& part);
    [[nodiscard]] std::size_t indexOf(const Part& part) const; // among its parent's
    // The part that shows a place of the document, which is that of the model: text, a figure, a
    // formula; null: none does.
    [[nodiscard]] Part* partAt(std::size_t place);
    [[nodiscard]] Part* figureOf(document::SubdocumentId id);
    // A table's cell that covers a place of it; null: none does.
    [[nodiscard]] Part* cellAt(Part& table, std::size_t row, std::size_t column);

    // A model's changes are told of parts that had been made. `leaves` comes before a part is
    // gone with all in it; `changed` when its block is another one.
    struct Listener {
        std::function<void(Part&)> came, leaves;
        std::function<void(Part& part, const std::shared_ptr<const Block>& before)> changed;
    };
    void follow(const std::shared_ptr<const Model>& model, const Listener& listener);

    // Parts that were made or read again, for tests.
    [[nodiscard]] std::size_t work() const { return work_; }

private:
    using Parts = std::vector<std::unique_ptr<Part>>;
    struct Window { // blocks of a flow that changed, before and after
        std::size_t from = 0, oldEnd = 0, newEnd = 0;
    };
    [[nodiscard]] static Window changed(const Flow& old, const Flow& now);
    [[nodiscard]] std::unique_ptr<Part> made(Part::Kind kind, Part& parent, sgml::NodeId element);
    [[nodiscard]] Parts partsIn(Part& parent, const Flow& flow, std::size_t from, std::size_t to);
    [[nodiscard]] std::unique_ptr<Part> partOf(Part& parent,
                                               const std::shared_ptr<const Block>& block);
    [[nodiscard]] Parts lineOf(Part& text);
    [[nodiscard]] Parts cellsOf(Part& table);
    [[nodiscard]] Parts notesOf(Part& parent);
    void refill(Part& owner, const Flow& now, const Listener& listener);
    void refillIn(Part& part, std::size_t oldStart, std::size_t newStart, std::size_t newSize,
                  const Flow& now, const Window& window, const Listener& listener);
    // How a part that stays is now, and where its blocks begin, before and after.
    using Keep = std::function<void(Part& kept, const Part& fresh, std::size_t oldStart,
                                    std::size_t newStart)>;
    struct Exchange { // of some parts of a part for others
        Part& parent;
        std::size_t first = 0, end = 0;
        Parts fresh;
        std::size_t oldStart = 0, newStart = 0; // of the first one's blocks
    };
    static void exchange(Exchange what, const Keep& keep, const Listener& listener);
    void update(Part& kept, const Part& fresh, const Listener& listener);
    void exchangeAll(Part& part, Parts fresh, const Listener& listener);
    [[nodiscard]] Part* partIn(Part& owner, std::size_t place);
    [[nodiscard]] std::size_t blockAt(const Blocks& blocks, std::size_t place) const;
    [[nodiscard]] std::size_t startOf(const Block& block) const;
    [[nodiscard]] bool holds(sgml::NodeId element, std::size_t place) const;
    [[nodiscard]] Part* blockPart(Part& owner, std::size_t index);

    const document::Document& document_;
    std::shared_ptr<const Model> model_;
    Part root_;
    std::size_t work_ = 0;
};

} // namespace reading
