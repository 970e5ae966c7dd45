// Blocks as strips, made one by one as they are read: what is not read costs nothing.
#pragma once

#include "layout/strip.h"

namespace layout {

// Counts of the work, for tests: it grows with the size of the document and no faster.
struct Work {
    std::size_t letters = 0; // that were given to the text layout for lines
    std::size_t strips = 0;  // that were put on pages, or looked at for it
    std::size_t boxes = 0;   // frames that were looked at for a page
};

struct Surroundings {
    const document::Model& model;
    const Objects& objects;
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
    // The blocks and what `in` refers to are read until the end.
    Flow(const Surroundings& in, const document::Blocks& blocks);
    ~Flow();
    Flow(Flow&&) noexcept;
    Flow& operator=(Flow&&) = delete;
    Flow(const Flow&) = delete;
    Flow& operator=(const Flow&) = delete;

    [[nodiscard]] Made next(Strip& strip);

    // LIMIT: so many letters of a table, and a Paragraph::segmentLength of a cell, decide how wide
    // its columns are.
    static constexpr std::size_t lettersForColumns = 50'000;

private:
    struct Table {
        std::vector<double> columns;
        double left = 0;
        std::size_t row = 0;
        std::shared_ptr<Cells> cells; // of the row that is being made
    };
    [[nodiscard]] Made inBlock(const document::Block& block, Strip& strip, bool& last);
    void finish(const document::Block& block, Strip& strip, bool last);
    void leaveBlock();
    [[nodiscard]] Made text(const document::Block& block, Strip& strip, bool& last);
    void addMarker(const document::Block& block, Strip& strip, double lineBaseline) const;
    void subdocument(const document::Block& block, Strip& strip) const;
    void image(const document::Block& block, Strip& strip) const;
    void rule(const document::Block& block, Strip& strip) const;
    [[nodiscard]] Made table(const document::Block& block, Strip& strip, bool& last);
    [[nodiscard]] double left(const document::Block& block) const;
    [[nodiscard]] double room(const document::Block& block) const;
    [[nodiscard]] double aligned(const document::Block& block, double itsWidth) const;

    Surroundings in_;
    const document::Blocks& blocks_;
    std::size_t block_ = 0;
    std::size_t made_ = 0; // strips of this block
    bool breakNext_ = false;
    std::shared_ptr<Paragraph> paragraph_;
    std::unique_ptr<Table> table_;
};

} // namespace layout
