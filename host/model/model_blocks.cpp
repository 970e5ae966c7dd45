// Blocks, runs and their text.
#include "model/contents.h"
#include "model/model_walk.h"

#include <algorithm>

namespace model {

using sgml::NodeId;
using sgml::noNode;

// --- blocks ---------------------------------------------------------------------------------

const ModelWalk::Frame& ModelWalk::blockFrame() const {
    const Frame& top = state_.frames.back();
    return top.role == Role::inlined ? state_.frames[top.blockFrame] : top;
}

Block& ModelWalk::addBlock(BlockKind kind) {
    if (flow_.out == nullptr)
        enterCell({}, state_.frames.back().node); // text in a row that is in no cell
    closeText();
    const Frame& frame = blockFrame();
    if (frame.content.together < flow_.out->size())
        flow_.last->style.keepWithNext = true;
    const auto made = std::make_shared<Block>();
    Block& block = *made;
    block.kind = kind;
    block.element = frame.node;
    block.style = frame.style.block;
    block.style.indentLeft = frame.indent.left;
    block.style.indentRight = frame.indent.right;
    block.style.spaceBefore = flow_.gap.space + flow_.gap.padding;
    block.style.spaceAfter = 0;
    block.style.pageBreakBefore = flow_.gap.pageBreak;
    if (kind != BlockKind::rule) {
        block.style.background.reset();
        block.style.border = {};
        block.style.padding = 0;
    }
    block.textStyle = textStyle(frame.style.text);
    block.headingLevel = kind == BlockKind::text ? frame.style.headingLevel : 0;
    block.anchors.swap(state_.anchors);
    if (block.headingLevel > 0 || frame.style.role == schemas::ContainerRole::caption)
        block.anchors.push_back(anchorOf(frame.node));
    takeMarker(block);
    flow_.gap.space = flow_.gap.padding = 0;
    flow_.gap.pageBreak = false;
    flow_.out->push_back(made);
    flow_.last = made;
    markFrames();
    return block;
}

// Something was made in all that is open.
void ModelWalk::markFrames() {
    std::vector<Frame>& frames = state_.frames;
    for (std::size_t i = frames.size(); i-- > 0 && frames[i].content.empty;)
        frames[i].content.empty = false;
    std::size_t first = frames.size();
    while (first > 0 && !frames[first - 1].content.filled)
        --first;
    for (; first < frames.size(); ++first) {
        frames[first].content.filled = true;
        open(first);
    }
}

// The frame's first block is the last that was made.
void ModelWalk::open(std::size_t of) {
    const Frame& frame = state_.frames[of];
    const schemas::BlockStyle& style = frame.style.block;
    const std::size_t block = flow_.out->size() - 1;
    const schemas::ContainerRole role = frame.style.role;
    if (isContainer(role) && (frame.role == Role::block || frame.role == Role::table)) {
        opened_[of].container = flow_.containers->size();
        flow_.containers->push_back({.role = role,
                                     .level = frame.levels[static_cast<std::size_t>(role)],
                                     .element = frame.node,
                                     .first = block,
                                     .last = block});
    }
    if (!frame.content.boxed)
        return;
    opened_[of].box = model_.boxes.size();
    model_.boxes.push_back({.first = block,
                            .last = block,
                            .indentLeft = frame.indent.left - style.paddingAside(),
                            .indentRight = frame.indent.right - style.paddingAside(),
                            .padding = style.padding,
                            .background = style.background,
                            .border = style.border});
}

// The boxes that the innermost frame opened end with the last block.
void ModelWalk::close() {
    const Opened& opened = opened_.back();
    if (opened.container != none)
        (*flow_.containers)[opened.container].last = flow_.out->size() - 1;
    if (opened.box == none)
        return;
    model_.boxes[opened.box].last = flow_.out->size() - 1;
    flow_.gap.padding += state_.frames.back().style.block.padding;
}

// The innermost marker that waits for a block, up to the cell or footnote that this is in.
void ModelWalk::takeMarker(Block& block) {
    for (std::size_t i = state_.frames.size(); i-- > 0 && state_.markers > 0;) {
        Frame& frame = state_.frames[i];
        if (!frame.numbering.marker.empty()) {
            schemas::Presentation::Progress progress = frame.progress;
            const schemas::ElementStyle style =
                frame.presentation->style({.name = "MARKER"}, frame.style, progress);
            block.marker.swap(frame.numbering.marker);
            --state_.markers;
            block.markerStyle = textStyle(style.text);
            block.style.markerWidth = frame.style.block.markerWidth;
            block.style.markerAlign = frame.style.block.markerAlign;
            return;
        }
        if (frame.role == Role::cell || frame.role == Role::footnote)
            return;
    }
}

void ModelWalk::openText() {
    if (flow_.open)
        return;
    addBlock(BlockKind::text);
    flow_.open = true;
}

void ModelWalk::enterCell(const schemas::BlockStyle& style, NodeId node) {
    Row& row = flow_.rows->back();
    row.push_back({.element = node, .style = style, .blocks = {}});
    flow_.out = &row.back().blocks;
    flow_.containers = &row.back().containers;
    flow_.open = false;
    flow_.gap.space = flow_.gap.padding = 0;
}

// --- runs -----------------------------------------------------------------------------------

void ModelWalk::addRun(Run run) {
    openText();
    run.target = run.target.empty() ? state_.frames.back().target : run.target;
    if (titles_ > 0 && !state_.titled && run.kind == RunKind::text)
        model_.title += run.text;
    run.refers = run.kind == RunKind::text && run.text.empty() && run.target.starts_with('#');
    if (run.refers) {
        run.byNumber = state_.frames.back().style.refersByNumber;
        run.looks = {run.style, valueLooks(state_.frames.back()).faulty};
        markReferring();
    }
    markValued(run);
    flow_.last->runs.push_back(std::move(run));
    markFrames();
}

// All that is being made is part of the last block of the outermost flow.
void ModelWalk::mark(std::vector<std::size_t>& blocks) const {
    const std::size_t block = model_.blocks.size() - 1 - trail_.back().begin.blocksBefore;
    if (blocks.empty() || blocks.back() != block)
        blocks.push_back(block);
}

void ModelWalk::markReferring() { mark(trail_.back().referring); }

void ModelWalk::markValued(const Run& run) {
    if (run.value || (run.formula && !run.formula->read.values.empty()))
        mark(trail_.back().valued);
}

void ModelWalk::addText(std::string text, NodeId content, std::size_t offset) {
    Run run{.text = std::move(text),
            .element = state_.frames.back().node,
            .content = content,
            .offset = offset};
    run.style = textStyle(state_.frames.back().style.text);
    addRun(std::move(run));
}

bool ModelWalk::atLineStart() const { return !flow_.open || flow_.last->runs.empty(); }

void ModelWalk::addGenerated(const Frame& frame, std::string_view name, const std::string& text) {
    schemas::Presentation::Progress progress = frame.progress;
    Frame generated = frameInside(frame.node);
    generated.style = frame.presentation->style({.name = name}, frame.style, progress);
    const bool block = generated.style.display == schemas::Display::block;
    generated.role = Role::inlined;
    push(std::move(generated));
    if (block)
        beginBlock(state_.frames.back());
    if (state_.frames.back().style.show)
        addText(text);
    if (block)
        endBlock(state_.frames.back());
    pop();
}

void ModelWalk::addContent(NodeId content) {
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
void ModelWalk::addFlowing(const sgml::Unescaped& unescaped, NodeId content) {
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
void ModelWalk::addLines(const sgml::Unescaped& unescaped, NodeId content) {
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
void ModelWalk::addStray(NodeId node) {
    constexpr std::size_t most = 500;
    std::string text(tree_.text(tree_.node(node).range));
    if (text.size() > most)
        text = text.substr(0, most) + "...";
    std::replace(text.begin(), text.end(), '\n', ' ');
    Run run{.text = std::move(text), .element = node};
    schemas::TextStyle style = state_.frames.back().style.text;
    style.family = "mono";
    style.color = {176, 0, 0};
    run.style = textStyle(style);
    addRun(std::move(run));
}

// --- small things ---------------------------------------------------------------------------

std::string ModelWalk::attribute(NodeId node, std::string_view name) const {
    return std::string(tree_.attribute(node, name).value_or(""));
}

std::optional<double> ModelWalk::lengthAttribute(NodeId node, std::string_view name) const {
    return document::numberIn(tree_.attribute(node, name), 1, document::longestLength);
}

// Of its name among the children of the frame on top; to be asked once for each.
bool ModelWalk::isFirst(NodeId node) {
    std::set<std::string, std::less<>>& seen = state_.frames.back().seen;
    const std::string_view name = tree_.name(node);
    return seen.find(name) == seen.end() && seen.emplace(name).second;
}

} // namespace model
