// The rules of Appendix G, each for a kind of node.
#pragma once

#include "formulas/empty_parts.h"
#include "formulas/typeset.h"

namespace formulas {

[[nodiscard]] inline bool isScriptStyle(Style style) {
    return style == Style::script || style == Style::scriptscript;
}

class Typesetter {
public:
    Typesetter(const Formula& formula, double size, const Font& font,
               std::vector<EmptyPart> framed = {})
        : formula_(formula), size_(size), font_(font), framed_(std::move(framed)) {}

    // How a part is set. A cramped one raises its superscripts less: it is under something.
    struct Setting {
        Style style = Style::text;
        bool cramped = false;
    };
    struct Item { // of a row
        Box box;
        Atom atom = Atom::ordinary;
        double before = 0; // the space on its left
    };

    [[nodiscard]] std::vector<Item> row(NodeId list, Setting setting, bool afterOrdinary = false);
    [[nodiscard]] static Box joined(const std::vector<Item>& items);
    [[nodiscard]] std::vector<Fault> takeFaults() { return std::move(faults_); }

private:
    using Constant = hb_ot_math_constant_t;
    struct Place { // of scripts: how far up and down
        double up = 0, down = 0;
    };

    [[nodiscard]] Box node(NodeId id, Setting setting);
    [[nodiscard]] Box list(NodeId id, Setting setting);
    [[nodiscard]] Box frame(std::size_t place, Setting setting) const;
    [[nodiscard]] Box symbol(const Node& node, Setting setting);
    [[nodiscard]] Box bigOperator(const Node& node, GlyphId glyph, Setting setting);
    [[nodiscard]] Box words(const Node& node, Setting setting);
    [[nodiscard]] Box scripts(const Node& node, Setting setting);
    [[nodiscard]] Place scriptPlace(const Box& base, const Box* above, const Box* below,
                                    Setting setting) const;
    [[nodiscard]] double corner(const Box& base, const Box& script, bool above, double shift) const;
    [[nodiscard]] Box limits(const Node& node, Setting setting);
    [[nodiscard]] Box fraction(const Node& node, Setting setting);
    [[nodiscard]] Place fractionPlace(const Box& above, const Box& below, bool line,
                                      Setting setting) const;
    [[nodiscard]] Box root(const Node& node, Setting setting);
    [[nodiscard]] Box accent(const Node& node, Setting setting);
    [[nodiscard]] Box accented(const Node& node, Setting setting);
    [[nodiscard]] Box bar(const Node& node, Setting setting);
    [[nodiscard]] Box stretch(const Node& node, Setting setting);
    [[nodiscard]] Box arrow(const Node& node, Setting setting);
    [[nodiscard]] Box fenced(const Node& node, Setting setting);
    [[nodiscard]] Box delimiter(char32_t code, double atLeast, Setting setting);
    [[nodiscard]] Box array(const Node& node, Setting setting);
    [[nodiscard]] Box phantom(const Node& node, Setting setting);
    [[nodiscard]] Box inRoom(const Node& node, Setting setting);
    [[nodiscard]] Box glyphBox(GlyphId glyph, double size) const;
    [[nodiscard]] Box grownBox(const Grown& grown, bool vertical, double size) const;
    void centre(Box& box, Setting setting) const; // about the axis

    [[nodiscard]] double sizeOf(Setting setting) const;
    [[nodiscard]] double length(Constant constant, Setting setting) const;
    [[nodiscard]] double axis(Setting setting) const;
    [[nodiscard]] std::optional<GlyphId> glyphOf(char32_t code, Setting setting);
    void report(const Node& node, const std::string& letter);

    const Formula& formula_;
    double size_ = 0;
    const Font& font_;
    std::vector<EmptyPart> framed_;
    std::vector<Fault> faults_;
};

} // namespace formulas
