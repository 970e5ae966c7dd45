#include "sgml/edit.h"

#include "sgml/braces.h"
#include "text/characters.h"

#include <algorithm>

namespace sgml {

// --- edits of content -----------------------------------------------------------------------

namespace {

// Edits of one content's spelling, and the neighbours that must be respelled with them.
class ContentEditor {
public:
    ContentEditor(const Tree& tree, NodeId content)
        : tree_(tree), content_(content), range_(tree.contentRange(content)),
          unescaped_(tree.unescaped(content)) {}

    text::Edits edits(const text::Edits& unescaped) {
        for (const text::Edit& edit : unescaped) {
            const std::size_t size = unescaped_.text().size();
            const std::size_t to = std::min(edit.range.to, size);
            const std::size_t from = std::min(edit.range.from, to);
            edits_.push_back(
                {{unescaped_.fileOffset(from), unescaped_.fileOffset(to)}, escaped(edit.text)});
        }
        escapeWidowedBraces();
        escapeBareBackslashes();
        return std::move(edits_);
    }

private:
    // A bare brace whose partner goes would close the content or never be closed.
    void escapeWidowedBraces() {
        const std::string_view spelling = tree_.text(range_);
        text::Edits widowed;
        std::unordered_map<std::size_t, std::size_t> pairs;
        for (const text::Edit& edit : edits_) {
            if (tree_.text(edit.range).find_first_of("{}") == std::string_view::npos)
                continue;
            if (pairs.empty())
                pairs = bracePairs(spelling);
            for (std::size_t at = edit.range.from; at < edit.range.to; ++at) {
                const auto pair = pairs.find(at - range_.from);
                if (pair != pairs.end() && !isReplaced(range_.from + pair->second))
                    widowed.push_back(
                        {{range_.from + pair->second, range_.from + pair->second}, "\\"});
            }
        }
        edits_.insert(edits_.end(), widowed.begin(), widowed.end());
        std::stable_sort(
            edits_.begin(), edits_.end(),
            [](const text::Edit& a, const text::Edit& b) { return a.range.from < b.range.from; });
    }

    [[nodiscard]] bool isReplaced(std::size_t offset) const {
        return std::any_of(edits_.begin(), edits_.end(),
                           [&](const text::Edit& edit) { return edit.range.contains(offset); });
    }

    // A bare backslash is itself only as long as no brace or backslash follows it.
    void escapeBareBackslashes() {
        for (std::size_t i = 0; i < edits_.size(); ++i) {
            const std::size_t before = edits_[i].range.from - 1;
            const bool kept =
                edits_[i].range.from > range_.from && (i == 0 || edits_[i - 1].range.to <= before);
            if (!kept || !isBareBackslash(before) || !isSpecial(firstAfter(i)))
                continue;
            edits_[i].range.from = before;
            edits_[i].text.insert(0, "\\\\");
        }
    }

    [[nodiscard]] bool isBareBackslash(std::size_t offset) const {
        if (tree_.bytes()[offset] != '\\')
            return false;
        const std::size_t character = unescaped_.textOffset(offset);
        return !unescaped_.isEscaped(character);
    }

    // The byte that comes to stand where edit `i` begins; the closing brace behind the content.
    [[nodiscard]] char firstAfter(std::size_t i) const {
        for (; i < edits_.size(); ++i) {
            if (!edits_[i].text.empty())
                return edits_[i].text.front();
            if (i + 1 >= edits_.size() || edits_[i + 1].range.from > edits_[i].range.to)
                break;
        }
        const std::size_t at = edits_[std::min(i, edits_.size() - 1)].range.to;
        if (at >= range_.to)
            return tree_.node(content_).endTag.empty() ? '\0' : '}';
        return tree_.bytes()[at];
    }

    static bool isSpecial(char c) { return c == '{' || c == '}' || c == '\\'; }

    const Tree& tree_;
    NodeId content_;
    text::Range range_;
    Unescaped unescaped_;
    text::Edits edits_;
};

} // namespace

text::Edits contentEdits(const Tree& tree, NodeId content, const text::Edits& unescaped) {
    return ContentEditor(tree, content).edits(unescaped);
}

text::Edits contentEdit(const Tree& tree, NodeId content, text::Range unescaped,
                        std::string_view text) {
    return contentEdits(tree, content, {{unescaped, std::string(text)}});
}

// --- edits of attributes --------------------------------------------------------------------

std::string attributeText(std::string_view name, std::string_view value) {
    std::string spelled(value);
    std::replace(spelled.begin(), spelled.end(), '"', '\'');
    return std::string(name) + "=\"" + spelled + '"';
}

text::Edits attributeEdit(const Tree& tree, NodeId element, std::string_view name,
                          std::string_view value) {
    const std::string spelled = attributeText(name, value);
    const Node& node = tree.node(element);
    std::size_t end = node.name.to;
    for (const Attribute& attribute : tree.attributes(element)) {
        if (tree.text(attribute.name) == name)
            return {{attribute.whole, spelled}};
        end = attribute.whole.to;
    }
    return {{{end, end}, " " + spelled}};
}

text::Edits attributeRemoval(const Tree& tree, NodeId element, std::string_view name) {
    std::size_t before = tree.node(element).name.to;
    for (const Attribute& attribute : tree.attributes(element)) {
        if (tree.text(attribute.name) == name)
            return {{{before, attribute.whole.to}, ""}}; // the blanks before it go with it
        before = attribute.whole.to;
    }
    return {};
}

std::string elementText(std::string_view name, std::string_view content) {
    const std::string tag(name);
    return "<" + tag + ">{" + escaped(content) + "}</" + tag + ">";
}

} // namespace sgml
