// Blocks as strips, made one by one as they are read: what is not read costs nothing.
#pragma once

#include "strips/stock.h"
#include "strips/strip.h"
#include "strips/work.h"

namespace layout {

struct Surroundings {
    Stock& stock;
    Work& work;
    double width = 0;         // of the text area
    double pictureHeight = 0; // the most of a picture
    double pageHeight = 0;    // of the text area
};

enum class Made {
    strip,
    pause, // some work was done, and more is to be done before there is a strip
    end,
};

class Flow {
public:
    // The list and what `in` refers to are read until the end.
    Flow(const Surroundings& in, const model::Blocks& blocks);
    ~Flow();
    Flow(Flow&&) noexcept;
    Flow& operator=(Flow&&) = delete;
    Flow(const Flow&) = delete;
    Flow& operator=(const Flow&) = delete;

    [[nodiscard]] Made next(Strip& strip);

    // Between two strips: where the next one is.
    struct Place {
        std::size_t block = 0, strip = 0; // of that block
        auto operator<=>(const Place&) const = default;
    };
    [[nodiscard]] Place place() const { return {block_, made_}; }
    void seek(Place place);

    // LIMIT: so many letters of a table, and a Paragraph::segmentLength of a cell, decide how wide
    // its columns are.
    static constexpr std::size_t lettersForColumns = 50'000;

private:
    struct Table {
        std::shared_ptr<const Columns> columns;
        double left = 0;
        std::shared_ptr<const Strip> header{}; // that is repeated
        std::shared_ptr<Cells> cells{};        // of the rows that are being made
    };
    [[nodiscard]] Made inBlock(const paragraphs::BlockPointer& block, Strip& strip, bool& last);
    void finish(const paragraphs::BlockPointer& block, Strip& strip, bool last);
    void leaveBlock();
    void beginText(const paragraphs::BlockPointer& block);
    void countText();
    [[nodiscard]] Made text(const paragraphs::BlockPointer& block, Strip& strip, bool& last);
    void addMarker(const paragraphs::BlockPointer& block, Strip& strip, double lineBaseline) const;
    void subdocument(const paragraphs::BlockPointer& block, Strip& strip) const;
    void image(const paragraphs::BlockPointer& block, Strip& strip) const;
    void rule(const paragraphs::BlockPointer& block, Strip& strip) const;
    [[nodiscard]] Made contents(const paragraphs::BlockPointer& block, Strip& strip, bool& last);
    void beginTable(const paragraphs::BlockPointer& block);
    [[nodiscard]] std::shared_ptr<Cells> cellsOf(const paragraphs::BlockPointer& block,
                                                 std::size_t band) const;
    [[nodiscard]] std::shared_ptr<const Strip>
    headerOf(const paragraphs::BlockPointer& block) const;
    [[nodiscard]] Made table(const paragraphs::BlockPointer& block, Strip& strip, bool& last);
    [[nodiscard]] double left(const paragraphs::BlockPointer& block) const;
    [[nodiscard]] double room(const paragraphs::BlockPointer& block) const;
    [[nodiscard]] double aligned(const paragraphs::BlockPointer& block, double itsWidth) const;

    Surroundings in_;
    const model::Blocks& blocks_;
    std::size_t block_ = 0;
    std::size_t made_ = 0; // strips of this block: lines or rows
    bool breakNext_ = false;
    std::shared_ptr<paragraphs::Paragraph> paragraph_;
    std::size_t lettersBefore_ = 0; // of the paragraph, when this flow came to it
    std::unique_ptr<Table> table_;
    struct Entry {
        std::size_t index = 0, line = 0; // of the next strip
        std::size_t made = 0;            // strips before it
        std::shared_ptr<paragraphs::Paragraph> paragraph{};
    };
    Entry entry_; // of a table of contents
};

} // namespace layout
