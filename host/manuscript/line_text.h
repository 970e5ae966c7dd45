// The letters of the line around a place, before it and behind it: what an input method asks for
// and may replace, and what typed signs depend on.
#pragma once

#include "manuscript/leaves.h"

#include <QString>

#include <optional>
#include <vector>

namespace manuscript {

class LineText {
public:
    // LIMIT: some 2000 letters on each side of the place are read.
    LineText(const Manuscript& manuscript, std::size_t place);

    // UTF-16. A unit, such as a formula, is U+FFFC; a line end in flowing text is a blank.
    [[nodiscard]] const QString& letters() const { return letters_; }
    [[nodiscard]] qsizetype place() const { return place_; } // among the letters
    // Nothing: it is no place of this line, or too far away.
    [[nodiscard]] std::optional<qsizetype> letterAt(std::size_t place) const;
    // The selection of the letters from one to another, as far as there are.
    [[nodiscard]] Selection between(qsizetype from, qsizetype to) const;

private:
    struct Part { // a leaf, or some of a content
        sgml::NodeId leaf = sgml::noNode;
        std::size_t from = 0; // bytes of the content, before its first letter
        QString letters{};
        qsizetype start = 0; // among all letters
        [[nodiscard]] qsizetype end() const { return start + letters.size(); }
    };
    [[nodiscard]] Part partOf(sgml::NodeId leaf) const;
    void addBeside(sgml::NodeId leaf, Direction direction);
    [[nodiscard]] std::size_t placeIn(const Part& part, qsizetype letter) const;

    const sgml::Tree& tree_;
    const Leaves leaves_;
    std::vector<Part> parts_;
    QString letters_;
    qsizetype place_ = 0;
};

} // namespace manuscript
