// Blocks, runs and their text.
#include "document/model_builder.h"

#include <algorithm>

namespace document {

using sgml::NodeId;
using sgml::noNode;

// --- blocks ---------------------------------------------------------------------------------

const ModelBuilder::Frame& ModelBuilder::blockFrame() const {
    const Frame& top = frames_.back();
    return top.role == Role::inlined ? frames_[top.blockFrame] : top;
}

Block& ModelBuilder::addBlock(BlockKind kind) {
    if (flow_.out == nullptr)
        enterCell({}, frames_.back().node); // text in a row that is in no cell
    closeText();
    const Frame& frame = blockFrame();
    if (frame.together < flow_.out->size())
        flow_.last->style.keepWithNext = true;
    const auto made = std::make_shared<Block>();
    Block& block = *made;
    block.kind = kind;
    block.element = frame.node;
    block.style = frame.style.block;
    block.style.indentLeft = frame.indentLeft;
    block.style.indentRight = frame.indentRight;
    block.style.spaceBefore = flow_.space + flow_.padding;
    block.style.spaceAfter = 0;
    block.style.pageBreakBefore = flow_.pageBreak;
    if (kind != BlockKind::rule) {
        block.style.background.reset();
        block.style.border = {};
        block.style.padding = 0;
    }
    block.textStyle = textStyle(frame.style.text);
    block.headingLevel = kind == BlockKind::text ? frame.style.headingLevel : 0;
    block.anchors.swap(anchors_);
    takeMarker(block);
    flow_.space = flow_.padding = 0;
    flow_.pageBreak = false;
    flow_.out->push_back(made);
    flow_.last = made;
    ++emitted_;
    return block;
}

// The innermost marker that waits for a block, up to the cell or footnote that this is in.
void ModelBuilder::takeMarker(Block& block) {
    for (std::size_t i = frames_.size(); i-- > 0 && markers_ > 0;) {
        Frame& frame = frames_[i];
        if (!frame.marker.empty()) {
            Presentation::Progress progress = frame.progress;
            const ElementStyle style =
                frame.presentation->style({.name = "MARKER"}, frame.style, progress);
            block.marker.swap(frame.marker);
            --markers_;
            block.markerStyle = textStyle(style.text);
            block.style.markerWidth = frame.style.block.markerWidth;
            block.style.markerAlign = frame.style.block.markerAlign;
            return;
        }
        if (frame.role == Role::cell || frame.role == Role::footnote)
            return;
    }
}

void ModelBuilder::openText() {
    if (flow_.open)
        return;
    addBlock(BlockKind::text);
    flow_.open = true;
}

void ModelBuilder::enterCell(const BlockStyle& style, NodeId node) {
    Row& row = flow_.rows->back();
    row.push_back({.element = node, .style = style, .blocks = {}});
    flow_.out = &row.back().blocks;
    flow_.open = false;
    flow_.space = flow_.padding = 0;
}

// --- runs -----------------------------------------------------------------------------------

void ModelBuilder::addRun(Run run) {
    openText();
    run.target = run.target.empty() ? frames_.back().target : run.target;
    if (titles_ > 0 && !titled_ && run.kind == RunKind::text)
        model_.title += run.text;
    if (run.text.empty() && run.target.starts_with('#') &&
        (referring_.empty() || referring_.back() != flow_.last))
        referring_.push_back(flow_.last);
    flow_.last->runs.push_back(std::move(run));
    ++emitted_;
}

void ModelBuilder::addText(std::string text, NodeId content, std::size_t offset) {
    Run run{.text = std::move(text),
            .element = frames_.back().node,
            .content = content,
            .offset = offset};
    run.style = textStyle(frames_.back().style.text);
    addRun(std::move(run));
}

bool ModelBuilder::atLineStart() const { return !flow_.open || flow_.last->runs.empty(); }

void ModelBuilder::addGenerated(const Frame& frame, std::string_view name,
                                const std::string& text) {
    Presentation::Progress progress = frame.progress;
    Frame generated = frameInside(frame.node);
    generated.style = frame.presentation->style({.name = name}, frame.style, progress);
    const bool block = generated.style.display == Display::block;
    generated.emitted = emitted_;
    frames_.push_back(std::move(generated));
    frames_.back().role = Role::inlined;
    if (block)
        beginBlock(frames_.back());
    if (frames_.back().style.show)
        addText(text);
    if (block)
        endBlock(frames_.back());
    frames_.pop_back();
}

void ModelBuilder::addContent(NodeId content) {
    const sgml::Unescaped text = tree_.unescaped(content);
    if (flow_.open && flow_.last->kind == BlockKind::verbatim)
        addLines(text, content);
    else
        addFlowing(text, content);
}

namespace {

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

// Behind the blanks at `at`, and whether a line end is among them.
std::size_t behindBlanks(const std::string& text, std::size_t at, bool& lineEnd) {
    lineEnd = false;
    for (; at < text.size() && isBlank(text[at]); ++at)
        lineEnd = lineEnd || text[at] == '\n' || text[at] == '\r';
    return at;
}

} // namespace

// Blanks with a line end among them are one blank, none at the start of a line; what is left out
// begins a new run, so that a run's bytes always follow each other in the text.
void ModelBuilder::addFlowing(const sgml::Unescaped& unescaped, NodeId content) {
    const std::string& text = unescaped.text();
    std::string piece;
    std::size_t from = 0;
    bool lineStart = atLineStart();
    for (std::size_t at = 0; at < text.size();) {
        bool lineEnd = false;
        const std::size_t next = isBlank(text[at]) ? behindBlanks(text, at, lineEnd) : at + 1;
        if (!lineEnd) {
            piece.append(text, at, next - at);
            at = next;
            continue;
        }
        if (!lineStart || !piece.empty())
            piece += ' ';
        if (!piece.empty() && next - at > 1) {
            addText(std::move(piece), content, from);
            piece.clear();
            lineStart = false;
        }
        if (piece.empty())
            from = next;
        at = next;
    }
    std::replace(piece.begin(), piece.end(), '\t', ' ');
    if (!piece.empty() || text.empty())
        addText(std::move(piece), content, from);
}

// A line end directly behind the opening brace is the brace's.
void ModelBuilder::addLines(const sgml::Unescaped& unescaped, NodeId content) {
    const std::string& text = unescaped.text();
    std::size_t at = 0;
    const auto lineEndAt = [&](std::size_t i) -> std::size_t {
        return text[i] == '\r' && i + 1 < text.size() && text[i + 1] == '\n' ? 2 : 1;
    };
    if (!text.empty() && (text[0] == '\n' || text[0] == '\r'))
        at = lineEndAt(0);
    while (at < text.size()) {
        const std::size_t end = std::min(text.find_first_of("\r\n", at), text.size());
        std::string line = text.substr(at, end - at);
        if (end < text.size())
            line += '\n';
        addText(std::move(line), content, at);
        at = end < text.size() ? end + lineEndAt(end) : end;
    }
}

// LIMIT: of long stray text the first 500 bytes are shown; the file keeps all of it.
void ModelBuilder::addStray(NodeId node) {
    constexpr std::size_t most = 500;
    std::string text(tree_.text(tree_.node(node).range));
    if (text.size() > most)
        text = text.substr(0, most) + "...";
    std::replace(text.begin(), text.end(), '\n', ' ');
    Run run{.text = std::move(text), .element = node};
    TextStyle style = frames_.back().style.text;
    style.family = "mono";
    style.color = {176, 0, 0};
    run.style = textStyle(style);
    addRun(std::move(run));
}

// --- small things ---------------------------------------------------------------------------

std::string ModelBuilder::attribute(NodeId node, std::string_view name) const {
    return std::string(tree_.attribute(node, name).value_or(""));
}

std::optional<double> ModelBuilder::lengthAttribute(NodeId node, std::string_view name) const {
    return numberIn(tree_.attribute(node, name), 1, longestLength);
}

// Of its name among the children of the frame on top; to be asked once for each.
bool ModelBuilder::isFirst(NodeId node) {
    return frames_.back().seen.insert(tree_.name(node)).second;
}

} // namespace document
