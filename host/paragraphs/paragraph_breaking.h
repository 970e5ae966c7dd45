// The ends of the lines of a segment of a paragraph.
//
// Qt's text layout breaks the segment at every place where Unicode's rules let a line end: that
// gives each word its width. typography chooses the ends of lines among these places.
#pragma once

#include "paragraphs/paragraph.h"
#include "typography/lines.h"

namespace paragraphs {

// A word may be divided there; a hyphen is seen where it is.
inline constexpr QChar softHyphen(QChar::SoftHyphen);

class Paragraph::Breaking {
public:
    // `isLast`: no text goes on behind it.
    Breaking(const Paragraph& of, const Letters& letters, int from, int length, bool isLast);

    struct Made {
        Line line;
        double width = 0; // as wide as it is
        double ascent = 0, descent = 0;
    };
    std::vector<Made> lines;
    double leastWidth = 0, numberWidth = 0;

private:
    struct Word {                       // with what Unicode's rules do not break off
        int from = 0, to = 0, next = 0; // blanks follow `to`; in the segment
        typography::Break behind;       // where it ends, and what follows begins
        double left = 0;
        double ascent = 0, descent = 0;
    };
    using Words = std::vector<Word>;
    using Breaks = std::vector<typography::Break>;

    [[nodiscard]] std::span<const InlineObject> objects() const;
    void breakAsWritten();
    void breakWell();
    void measureWords();
    [[nodiscard]] int costBehind(const Word& word) const;
    void findBreaks();
    void addDesperate(std::size_t first, std::size_t last);
    void tear(std::size_t word);
    [[nodiscard]] const LetterRange& rangeAt(int letter);
    [[nodiscard]] double blankAt(int letter);
    [[nodiscard]] double widthOfBlank(int letter);
    [[nodiscard]] std::uint32_t styleAt(int letter) const; // of the segment
    [[nodiscard]] double columnAt(const typography::Break* begin) const;
    [[nodiscard]] Breaks withHyphens(const Breaks& part, const typography::Break* begin) const;
    [[nodiscard]] double widthOf(int from, int to) const;
    [[nodiscard]] Words::const_iterator endOfUnit(Words::const_iterator word) const;
    void divide(Words::const_iterator word, int cost, Breaks& found) const;
    [[nodiscard]] std::optional<std::vector<std::size_t>>
    chosen(Breaks part, const typography::Break* begin, double most) const;
    void breakPart(std::size_t first, std::size_t last, const typography::Break* begin);
    void addLine(const typography::Break* begin, const typography::Break& end);
    [[nodiscard]] double stretched(Line& line, double stretch, double blanks) const;
    [[nodiscard]] int lettersOf(const Line& line) const;

    const Paragraph& of_;
    const Letters& letters_;
    const int from_, length_;
    const bool isLast_;
    std::unique_ptr<QTextLayout> layout_;
    Words words_;
    Breaks breaks_;
    std::size_t range_ = 0; // of the letters looked at last
    std::size_t wordOfLine_ = 0;
};

} // namespace paragraphs
