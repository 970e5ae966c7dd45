// The letters of a block's runs, as a paragraph sets them: the text of the document and what is
// generated, and a blank of its width for each image, subdocument or piece of a formula.
//
// Runs are read as their letters are asked for. A second reading gives the same: objects have the
// sizes that the lines were made for.
#pragma once

#include "formulas/typeset.h"
#include "paragraphs/kept.h"
#include "paragraphs/materials.h"

#include <span>

namespace paragraphs {

using BlockPointer = std::shared_ptr<const model::Block>;

// A subdocument, an image, or a piece of a formula.
struct InlineObject {
    std::size_t run = 0;
    int position = 0; // of its blank in the paragraph's text
    QSizeF size;
    double left = 0;                                // of its blank in its line
    double depth = 0;                               // of its size, below the base line
    std::shared_ptr<const formulas::Set> formula{}; // null: it is none
    std::size_t piece = 0;                          // of the formula
};

struct NoteMark {
    int position = 0;
    std::shared_ptr<const model::Footnote> note;
};

// Of one look.
struct LetterRange {
    int start = 0, length = 0;
    QTextCharFormat format;
    std::uint32_t style = 0;
    double blank = 0;   // width of a blank that may stretch; 0: there is none
    bool isGap = false; // a blank of that width in a formula
};

struct Letters {
    QString text;
    std::vector<LetterRange> ranges;
    std::vector<int> runStarts;             // of the runs that are read, in order of place
    bool isMixed = false;                   // some go from right to left, or may
    std::optional<std::uint32_t> lastStyle; // of the last range, unless it is an object
};

class RunLetters final : private Kept::Owner {
public:
    // `markerInFront`: the block's marker is set before its runs.
    RunLetters(std::shared_ptr<Materials> materials, BlockPointer block, double width,
               bool markerInFront);
    ~RunLetters();
    RunLetters(const RunLetters&) = delete;
    RunLetters& operator=(const RunLetters&) = delete;

    [[nodiscard]] Materials& materials() const { return *materials_; }
    [[nodiscard]] const BlockPointer& block() const { return block_; }
    [[nodiscard]] double width() const { return width_; } // of a line

    // As far as that letter, and so many runs. Good until somebody reads again.
    const Letters& read(int to, std::size_t runs = 0) const;
    // All lines are made: most letters are asked for no more, and few are kept from now on.
    void finish();

    // Of the runs that were ever read, in order of place.
    [[nodiscard]] const std::vector<InlineObject>& objects() const { return objects_; }
    [[nodiscard]] const std::vector<NoteMark>& marks() const { return marks_; }
    // Those among the letters from one to another.
    [[nodiscard]] std::span<InlineObject> objectsIn(int from, int to) const;
    [[nodiscard]] std::span<const NoteMark> marksIn(int from, int to) const;
    // By all paragraphs so far, those read again included.
    [[nodiscard]] static qsizetype lettersRead() { return lettersRead_; }
    // Are the objects as large as they were when they were read?
    [[nodiscard]] bool isOf(Sizes& sizes) const;

    [[nodiscard]] int startOfRun(std::size_t run) const;
    [[nodiscard]] int endOfRun(std::size_t run) const;
    // Between the letters of a run and the bytes of its text.
    [[nodiscard]] int letterAt(std::size_t run, std::size_t byte) const;
    [[nodiscard]] std::size_t byteAt(std::size_t run, int letter) const;

private:
    void forget(int item) const override;
    void begin() const;
    void append(std::size_t index) const;
    void appendText(const model::Run& run) const;
    void appendNumber(const model::Run& run) const;
    void appendFormula(std::size_t index) const;
    LetterRange& appendBlank(QChar sign, double width, std::uint32_t style) const;
    [[nodiscard]] const InlineObject& objectAt(int position) const; // that was read before
    [[nodiscard]] std::shared_ptr<const formulas::Set> formulaOf(std::size_t run,
                                                                 int position) const;
    [[nodiscard]] QSizeF sizeOfObject(std::size_t run, int position) const;
    [[nodiscard]] QSizeF sizeNow(const model::Run& run) const; // of a subdocument or an image

    static inline qsizetype lettersRead_ = 0;

    std::shared_ptr<Materials> materials_;
    BlockPointer block_;
    double width_;
    bool markerInFront_;
    bool isFinished_ = false;
    mutable std::vector<InlineObject> objects_;
    mutable std::vector<NoteMark> marks_;
    mutable std::size_t runsRead_ = 0;
    mutable std::unique_ptr<Letters> letters_;
    mutable std::optional<Kept::Place> kept_;
};

} // namespace paragraphs
