// From a draft to edits of the bytes.
#include "authoring/draft.h"

#include "text/difference.h"

#include <algorithm>

namespace authoring {

using sgml::NodeId;
using sgml::noNode;

namespace {

bool isSpecial(char c) { return c == '{' || c == '}' || c == '\\'; }

} // namespace

// Writes the inside of the root, in order. A part kept in the document's order costs no edit; one
// that stands between two kept ranges is the edit there.
class DraftWriter {
public:
    DraftWriter(const Draft& draft, const sgml::Tree& tree) : draft_(draft), tree_(tree) {}

    void write(const Piece& root) {
        const sgml::Node& source = tree_.node(root.start);
        cursor_ = size_ = source.startTag.to;
        writeChildren(root);
        keep({source.endTag.from, source.endTag.to});
        trim();
    }
    [[nodiscard]] text::Edits edits() { return std::move(edits_); }
    [[nodiscard]] std::size_t mark(std::size_t number) const { return marks_[number]; }

private:
    void keep(text::Range range) {
        if (range.empty())
            return;
        if (range.from < cursor_ || copied_ > 0)
            return add(tree_.text(range));
        if (range.from > cursor_ || !pending_.empty())
            edits_.push_back({{cursor_, range.from}, std::move(pending_)});
        pending_.clear();
        cursor_ = range.to;
        size_ += range.size();
    }
    void add(std::string_view text) {
        pending_ += text;
        size_ += text.size();
    }
    void writeGap(const Gap& gap) {
        keep(gap.kept);
        add(gap.fresh);
    }

    void writeElement(const Piece& piece) {
        if (!piece.raw.empty())
            return add(piece.raw);
        if (piece.start != noNode && !piece.isRespelled)
            writeStartTag(piece);
        else
            add("<" + piece.name + piece.attributes + ">");
        writeChildren(piece);
        if (piece.end != noNode)
            keep(tree_.node(piece.end).endTag);
        else
            add("</" + piece.name + ">");
    }

    void writeStartTag(const Piece& piece) {
        const sgml::Node& source = tree_.node(piece.start);
        if (piece.name == tree_.name(piece.start) && piece.attributes.empty())
            return keep(source.startTag);
        keep({source.startTag.from, source.name.from});
        if (piece.name == tree_.name(piece.start))
            keep(source.name);
        else
            add(piece.name);
        keep({source.name.to, source.startTag.to - 1});
        add(piece.attributes);
        keep({source.startTag.to - 1, source.startTag.to});
    }

    void writeChildren(const Piece& element) {
        const Pieces& all = element.children;
        const bool isMixed = std::any_of(all.begin(), all.end(), [](const auto& piece) {
            return piece->isElement() || piece->kind == Piece::Kind::rest;
        });
        for (std::size_t i = 0; i < all.size();) {
            const std::size_t end = endOfText(all, i);
            if (end > i)
                writeText(all, i, end, isMixed);
            else
                writePiece(*all[i]);
            i = std::max(end, i + 1);
        }
        writeGap(element.tail);
    }

    // Behind the texts and marks from `i` on; `i` itself when there is no text among them.
    static std::size_t endOfText(const Pieces& all, std::size_t i) {
        bool hasText = false;
        std::size_t end = i;
        for (; end < all.size() && (all[end]->isText() || all[end]->isMark()); ++end)
            hasText = hasText || all[end]->isText();
        return hasText ? end : i;
    }

    void writePiece(const Piece& piece) {
        if (piece.isMark()) {
            writeGap(piece.gap);
            marks_[piece.mark] = size_;
            return;
        }
        copied_ += piece.isCopied ? 1 : 0;
        writeGap(piece.gap);
        if (piece.isElement())
            writeElement(piece);
        else
            keep({tree_.node(piece.node).range.from, tree_.node(piece.last).range.to});
        copied_ -= piece.isCopied ? 1 : 0;
    }

    // --- content in braces

    struct Segment {
        const Piece* piece = nullptr;
        std::string_view bytes;
        std::vector<std::size_t> escapes; // offsets that a backslash comes before
    };

    void writeText(const Pieces& all, std::size_t from, std::size_t to, bool isMixed) {
        std::vector<Segment> segments;
        for (std::size_t i = from; i < to; ++i)
            segments.push_back(
                {all[i].get(),
                 all[i]->fresh.empty() ? tree_.text(all[i]->kept) : std::string_view(all[i]->fresh),
                 {}});
        escape(segments);
        if (isMixed)
            add("<TEXT>");
        const Piece& first = *std::find_if(all.begin() + static_cast<std::ptrdiff_t>(from),
                                           all.end(), [](const auto& one) { return one->isText(); })
                                  ->get();
        writeGap(first.gap);
        add("{");
        for (const Segment& segment : segments)
            writeSegment(segment);
        add("}");
        if (isMixed)
            add("</TEXT>");
    }

    void writeSegment(const Segment& segment) {
        if (segment.piece->isMark()) {
            marks_[segment.piece->mark] = size_;
            return;
        }
        const bool isFresh = !segment.piece->fresh.empty();
        const auto part = [&](std::size_t from, std::size_t to) {
            const std::size_t start = segment.piece->kept.from;
            if (isFresh)
                add(segment.bytes.substr(from, to - from));
            else
                keep({start + from, start + to});
        };
        std::size_t at = 0;
        for (const std::size_t escape : segment.escapes) {
            part(at, escape);
            add("\\");
            at = escape;
        }
        part(at, segment.bytes.size());
    }

    // A bare brace without its partner, and a bare backslash that would escape what comes to stand
    // behind it, are escaped, so that each part of a content keeps its meaning in its new place.
    static void escape(std::vector<Segment>& segments) {
        std::vector<std::pair<std::size_t, std::size_t>> open;
        for (std::size_t s = 0; s < segments.size(); ++s) {
            const std::string_view bytes = segments[s].bytes;
            for (std::size_t i = 0; i < bytes.size(); ++i) {
                if (bytes[i] == '\\' && i + 1 < bytes.size() && isSpecial(bytes[i + 1])) {
                    ++i;
                } else if (bytes[i] == '\\') {
                    if (i + 1 == bytes.size() && isSpecial(firstBehind(segments, s)))
                        segments[s].escapes.push_back(i);
                } else if (bytes[i] == '{') {
                    open.emplace_back(s, i);
                } else if (bytes[i] == '}') {
                    if (open.empty())
                        segments[s].escapes.push_back(i);
                    else
                        open.pop_back();
                }
            }
        }
        for (const auto& [segment, offset] : open)
            segments[segment].escapes.push_back(offset);
        for (Segment& segment : segments)
            std::sort(segment.escapes.begin(), segment.escapes.end());
    }

    static char firstBehind(const std::vector<Segment>& segments, std::size_t at) {
        for (std::size_t i = at + 1; i < segments.size(); ++i)
            if (!segments[i].bytes.empty())
                return segments[i].bytes.front();
        return '}';
    }

    // An edit leaves out the bytes that it would put back unchanged.
    void trim() {
        text::Edits trimmed;
        for (const text::Edit& edit : edits_) {
            text::Edit small = text::difference(tree_.text(edit.range), edit.text);
            small.range.from += edit.range.from;
            small.range.to += edit.range.from;
            if (!small.empty())
                trimmed.push_back(std::move(small));
        }
        edits_ = std::move(trimmed);
    }

    const Draft& draft_;
    const sgml::Tree& tree_;
    text::Edits edits_;
    std::string pending_;
    std::size_t cursor_ = 0, size_ = 0; // in the document; of what is written
    int copied_ = 0;
    std::array<std::size_t, 2> marks_{};
};

// --- what is allowed ------------------------------------------------------------------------

namespace {

void addName(const sgml::Tree& tree, const Grammar& grammar, NodeId node,
             Grammar::Children& names) {
    if (tree.node(node).kind == sgml::NodeKind::content)
        names.emplace_back();
    else if (tree.isElement(node) && grammar.knows(tree.name(node)))
        names.push_back(tree.name(node));
}

} // namespace

Grammar::Children Draft::childrenOf(const Piece& element, std::size_t count) const {
    Grammar::Children names;
    for (std::size_t i = 0; i < std::min(count, element.children.size()); ++i) {
        const Piece* const piece = element.children[i].get();
        if (piece->isText() && (names.empty() || !names.back().empty()))
            names.emplace_back();
        else if (piece->isElement() && grammar_->knows(piece->name))
            names.push_back(piece->name);
        else if (piece->kind == Piece::Kind::rest)
            for (NodeId id = piece->node;; id = tree_.node(id).next) {
                addName(tree_, *grammar_, id, names);
                if (id == piece->last)
                    break;
            }
    }
    return names;
}

QString Draft::faultOf(const Piece& element) const {
    return grammar_->whyNot(element.name, childrenOf(element));
}

bool Draft::isUnchanged(const Piece& element) const {
    if (element.start == noNode || element.start != element.end ||
        element.name != tree_.name(element.start))
        return false;
    NodeId expected = tree_.node(element.start).firstChild;
    for (const auto& piece : element.children) {
        if (piece->isMark())
            continue;
        if (expected == noNode || (piece->isElement() ? piece->start : piece->node) != expected)
            return false;
        if (piece->isElement() && piece->name != tree_.name(expected))
            return false;
        expected = tree_.node(piece->kind == Piece::Kind::rest ? piece->last : expected).next;
    }
    return expected == noNode;
}

QString Draft::fault() const {
    std::vector<const Piece*> waiting{root_.get()};
    while (!waiting.empty()) {
        const Piece& element = *waiting.back();
        waiting.pop_back();
        for (const auto& child : element.children)
            if (child->isElement())
                waiting.push_back(child.get());
        if (isBroken(element))
            return faultOf(element);
    }
    return {};
}

bool Draft::wasFaulty(const Piece& element) const {
    if (element.start == noNode)
        return false;
    Grammar::Children names;
    for (NodeId id = tree_.node(element.start).firstChild; id != noNode; id = tree_.node(id).next)
        addName(tree_, *grammar_, id, names);
    return !grammar_->whyNot(tree_.name(element.start), names).isEmpty();
}

Result Draft::result(QString label, bool isTyping) {
    for (Piece* mark : marks_)
        tidy(*mark);
    for (Piece* mark : marks_)
        settle(*mark);
    if (const QString why = fault(); !why.isEmpty())
        return Refusal{why};
    DraftWriter writer(*this, tree_);
    writer.write(*root_);
    return Step{.edits = writer.edits(),
                .after = {writer.mark(0), writer.mark(1)},
                .label = std::move(label),
                .isTyping = isTyping};
}

} // namespace authoring
