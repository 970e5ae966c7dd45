// Reports and memos for tests, and edits of them, made from a seed: with numbers, references,
// tables, footnotes and nested documents, and with faults of every kind.
#pragma once

#include "sgml/tree.h"

#include <cstdint>
#include <iterator>
#include <random>
#include <string>

namespace document {

class Author {
public:
    explicit Author(std::uint64_t seed) : random_(seed) {}

    std::size_t below(std::size_t bound) { return static_cast<std::size_t>(random_() % bound); }

    std::string report(int parts) {
        std::string text = "DOCUMENT REPORT\n<REPORT>\n";
        text += chance(80) ? "<TITLE>{" + words() + "}</TITLE>\n" : "";
        text += chance(30) ? "<ABSTRACT>" + parts_(2, 1) + "</ABSTRACT>\n" : "";
        return text + parts_(parts, 0) + "</REPORT>";
    }
    std::string memo(int parts) {
        return "DOCUMENT CMEMO\n<CMEMO><TO>{a}</TO><SUBJECT>{b}</SUBJECT><BODY>" +
               parts_(parts, 1) + "</BODY></CMEMO>";
    }
    std::string part(int depth) {
        if (depth > 4)
            return paragraph();
        switch (below(18)) {
        case 0:
        case 1:
            return "<SECTION" + id() + "><HEADING>{" + words() + "}</HEADING>\n" +
                   parts_(4, depth + 1) + "</SECTION>\n";
        case 2:
            return "<LIST" + std::string(chance(50) ? " KIND=\"number\"" : "") + "><ITEM" + id() +
                   ">" + (chance(30) ? part(depth + 1) : content()) + "</ITEM><ITEM>" +
                   parts_(2, depth + 2) + "</ITEM></LIST>\n";
        case 3:
            return "<TABLE" + id() + "><CAPTION>{" + words() + "}</CAPTION><ROW><CELL>" +
                   inlines() + "</CELL><CELL>" + part(depth + 3) + "</CELL></ROW></TABLE>\n";
        case 4:
            return "<FIGURE" + id() + "><IMAGE FILE=\"a.png\"></IMAGE><CAPTION>" + inlines() +
                   "</CAPTION></FIGURE>\n";
        case 5:
            return "<NEW" + id() + ">" + (chance(50) ? content() : part(depth + 1)) + "</NEW>\n";
        case 6:
            return "<DOCUMENT>DOCUMENT " +
                   std::string(chance(70) ? "REPORT\n<REPORT>" + parts_(3, depth + 2) + "</REPORT>"
                                          : "MOVIE\n<MOVIE" + id() + "></MOVIE>") +
                   "</DOCUMENT>\n";
        case 7:
            return "<VERBATIM>{\n a\n  b\n}</VERBATIM>\n";
        case 8:
            return chance(50)   ? "<PAGEBREAK></PAGEBREAK>"
                   : chance(50) ? "<RULE></RULE>"
                   : chance(50) ? "<CONTENTS></CONTENTS>"
                                : "<CONTENTS OF=\"tables\"></CONTENTS>";
        case 9:
            return "stray ";
        default:
            return paragraph();
        }
    }
    std::string inlines() {
        std::string text;
        for (std::size_t count = below(4); count > 0; --count)
            switch (below(7)) {
            case 0:
                text += "<EMPH>{" + words() + "}</EMPH>";
                break;
            case 1:
            case 2:
                text += "<REF TO=\"n" + std::to_string(below(names)) + "\"></REF>";
                break;
            case 3:
                text += "<FOOTNOTE" + id() + "><TEXT>{" + words() + "}</TEXT><REF TO=\"n" +
                        std::to_string(below(names)) + "\"></REF></FOOTNOTE>";
                break;
            case 4:
                text += "<LINK TO=\"http://x\">{" + words() + "}</LINK>";
                break;
            default:
                text += "<TEXT>{" + words() + "}</TEXT>";
            }
        return text;
    }
    std::string words() {
        std::string text;
        for (std::size_t count = below(5); count > 0; --count)
            text += "word" + std::to_string(below(100)) + (chance(20) ? "\n " : " ");
        return text;
    }
    std::string id() { return chance(50) ? " ID=\"n" + std::to_string(below(names)) + "\"" : ""; }

    // Some edit of the bytes, sound or not.
    text::Edits edit(const sgml::Tree& tree) {
        const std::string& bytes = tree.bytes();
        const sgml::NodeId node = anyNode(tree);
        const text::Range range = tree.node(node).range;
        const bool isContent = tree.node(node).kind == sgml::NodeKind::content;
        switch (below(12)) {
        case 0: // another part before, behind or in it
            return {{{range.from, range.from}, part(2)}};
        case 1:
            return {{{range.to, range.to}, part(2)}};
        case 2:
            return isContent ? text::Edits{} : text::Edits{{range, ""}};
        case 3: { // moved
            const std::size_t to = tree.node(anyNode(tree)).range.from;
            if (to <= range.from)
                return {{{to, to}, std::string(tree.text(range))}, {range, ""}};
            if (to >= range.to)
                return {{range, ""}, {{to, to}, std::string(tree.text(range))}};
            return {};
        }
        case 4: // split, as Enter does it
            if (isContent && tree.node(tree.node(node).parent).kind == sgml::NodeKind::element) {
                const std::string name(tree.name(tree.node(node).parent));
                return {{{range.from + 1, range.from + 1}, "}</" + name + "><" + name + ">{"}};
            }
            return {};
        case 5: // an attribute
            if (tree.isElement(node) && tree.node(node).name.to < bytes.size())
                return {{{tree.node(node).name.to, tree.node(node).name.to},
                         chance(70) ? " ID=\"n" + std::to_string(below(names)) + "\""
                                    : " KIND=\"number\""}};
            return {};
        case 6: { // broken bytes
            constexpr const char* pieces[] = {"<", ">", "{", "}", "\"", "</SECTION>", "<BODY>"};
            const std::size_t at = below(bytes.size() + 1);
            const std::size_t to = std::min(bytes.size(), at + below(4));
            return {{{at, to}, pieces[below(std::size(pieces))]}};
        }
        default: // letters
            if (!isContent || range.to - range.from < 2)
                return {};
            const std::size_t at = range.from + 1 + below(range.to - range.from - 1);
            return {{{at, std::min(at + below(3), range.to - 1)}, chance(70) ? "x" : ""}};
        }
    }

private:
    static constexpr std::size_t names = 25;
    bool chance(std::size_t percent) { return below(100) < percent; }
    std::string content() { return "{" + words() + "}"; }
    std::string paragraph() {
        return chance(50) ? "<PARAGRAPH" + id() + ">" + inlines() + "</PARAGRAPH>\n"
                          : "<PARAGRAPH>" + content() + "</PARAGRAPH>\n";
    }
    std::string parts_(int most, int depth) {
        std::string text;
        for (std::size_t count = below(static_cast<std::size_t>(most) + 1); count > 0; --count)
            text += part(depth);
        return text;
    }
    sgml::NodeId anyNode(const sgml::Tree& tree) {
        std::vector<sgml::NodeId> all;
        for (sgml::NodeId id = tree.root(); id != sgml::noNode; id = tree.following(id))
            all.push_back(id);
        return all[below(all.size())];
    }

    std::mt19937_64 random_;
};

} // namespace document
