// The walk over the tree, and what its elements become. Blocks and runs: model_blocks.cpp.
#include "document/model_builder.h"

#include <algorithm>

namespace document {

using sgml::NodeId;
using sgml::NodeKind;
using sgml::noNode;

ModelBuilder::ModelBuilder(const Document& document, const Presentation& presentation,
                           const Schemas& schemas)
    : document_(document), tree_(document.tree()), presentation_(presentation), schemas_(schemas) {
    for (const SubdocumentId id : document.subdocuments())
        subdocuments_[document.subdocument(id)->element] = id;
    styles_ = std::make_shared<TextStyles>();
    model_.textStyles = styles_;
    model_.page = presentation_.page();
    flow_.out = &model_.blocks;
    Frame root;
    root.node = tree_.root();
    root.style = presentation_.rootStyle();
    root.presentation = &presentation_;
    root.progress = presentation_.start();
    frames_.push_back(std::move(root));
    at_ = tree_.node(tree_.root()).firstChild;
}

Model ModelBuilder::take() {
    resolveReferences();
    // Inner ones ended before those around them.
    std::reverse(model_.boxes.begin(), model_.boxes.end());
    std::stable_sort(model_.boxes.begin(), model_.boxes.end(), [](const Box& a, const Box& b) {
        return a.first != b.first ? a.first < b.first : a.last > b.last;
    });
    return std::move(model_);
}

// --- the walk -------------------------------------------------------------------------------

bool ModelBuilder::step(int nodes) {
    for (; nodes > 0 && at_ != noNode; --nodes)
        walkOne();
    return at_ != noNode;
}

// frames_ holds the document and the elements from there down to the one that is being walked.
void ModelBuilder::walkOne() {
    NodeId id = at_;
    if (enter(id) && tree_.node(id).firstChild != noNode) {
        at_ = tree_.node(id).firstChild;
        return;
    }
    const auto leaveIfOpen = [&](NodeId node) {
        if (frames_.back().node == node && frames_.size() > 1)
            leave();
    };
    while (id != noNode && tree_.node(id).next == noNode) {
        leaveIfOpen(id);
        id = tree_.node(id).parent;
        if (id == tree_.root())
            id = noNode;
    }
    if (id != noNode) {
        leaveIfOpen(id);
        id = tree_.node(id).next;
    }
    at_ = id;
}

// True: its children come next. Elements that are entered have a frame.
bool ModelBuilder::enter(NodeId node) {
    switch (tree_.node(node).kind) {
    case NodeKind::content:
        addContent(node);
        return false;
    case NodeKind::stray:
        addStray(node);
        return false;
    case NodeKind::document:
        return true; // of a nested document of text: its class element follows
    case NodeKind::element:
        break;
    }
    return tree_.name(node) == "DOCUMENT" ? enterNested(node) : enterElement(node);
}

ModelBuilder::Frame ModelBuilder::frameInside(NodeId node) const {
    const Frame& outer = frames_.back();
    Frame frame;
    frame.node = node;
    frame.presentation = outer.presentation;
    frame.progress = outer.progress;
    frame.indentLeft = outer.indentLeft;
    frame.indentRight = outer.indentRight;
    frame.together = outer.together;
    frame.target = outer.target;
    frame.path = outer.path;
    frame.reference = outer.reference;
    frame.blockFrame = outer.role == Role::inlined ? outer.blockFrame : frames_.size() - 1;
    return frame;
}

bool ModelBuilder::enterElement(NodeId node) {
    Frame frame = frameInside(node);
    const Presentation::Subject subject{
        .name = tree_.name(node), .first = isFirst(node), .tree = &tree_, .element = node};
    frame.style = frame.presentation->style(subject, frames_.back().style, frame.progress);
    return begin(std::move(frame));
}

// A nested document of text goes on in the flow, as its own class's presentation says.
bool ModelBuilder::enterNested(NodeId node) {
    const auto known = subdocuments_.find(node);
    const Subdocument* nested =
        known == subdocuments_.end() ? nullptr : document_.subdocument(known->second);
    if (nested == nullptr || nested->classElement == noNode || !schemas_.isText(nested->className))
        return addSubdocument(node);
    Frame frame = frameInside(node);
    frame.presentation = &schemas_.presentation(nested->className);
    frame.progress = frame.presentation->start();
    frame.style = frame.presentation->rootStyle();
    return begin(std::move(frame));
}

bool ModelBuilder::begin(Frame frame) {
    beginNumbering(frame);
    if (!frame.style.show) {
        endNumbering(frame);
        return false;
    }
    frame.emitted = emitted_;
    markers_ += frame.marker.empty() ? 0 : 1;
    if (frame.style.title)
        ++titles_;
    frames_.push_back(std::move(frame));
    const bool inside = beginDisplay(frames_.back());
    if (inside && !frames_.back().style.before.empty())
        addGenerated(frames_.back(), "BEFORE", std::string(frames_.back().style.before));
    if (!inside || tree_.node(frames_.back().node).firstChild == noNode)
        leave();
    return inside;
}

void ModelBuilder::leave() {
    Frame& frame = frames_.back();
    if (!frame.style.after.empty())
        addGenerated(frame, "AFTER", std::string(frame.style.after));
    if (frame.style.display == Display::verbatim)
        endVerbatim();
    if (frame.style.display == Display::unknown && frame.role == Role::inlined)
        addText("</" + std::string(tree_.name(frame.node)) + ">");
    if (frame.role != Role::inlined)
        endBlock(frame);
    dropMarker(frame); // an inline element's has no place
    if (frame.role == Role::row || frame.role == Role::cell || frame.role == Role::footnote)
        flow_ = frame.outer;
    tables_ -= frame.role == Role::table ? 1 : 0;
    notes_ -= frame.role == Role::footnote ? 1 : 0;
    if (frame.style.title)
        titled_ = --titles_ == 0 && !model_.title.empty();
    endNumbering(frame);
    frames_.pop_back();
}

// --- numbers and names ----------------------------------------------------------------------

void ModelBuilder::beginNumbering(Frame& frame) {
    const ElementStyle& style = frame.style;
    if (!style.counter.empty()) {
        frame.path = counters_.step(style.counter);
        const std::string& pattern = style.reference.empty() ? style.number : style.reference;
        frame.reference = withoutPunctuation(numbered(pattern, frame.path));
    }
    for (const std::string& counter : style.restart)
        counters_.restart(counter);
    frame.marker = style.number.empty() ? style.marker : numbered(style.number, frame.path);
    const std::string id =
        tree_.isElement(frame.node) ? attribute(frame.node, "ID") : std::string{};
    if (id.empty())
        return;
    references_.try_emplace(id, frame.reference);
    if (style.show)
        anchors_.push_back(id);
}

void ModelBuilder::endNumbering(const Frame& frame) {
    for (const std::string& counter : frame.style.restart)
        counters_.leaveRestart(counter);
    if (!frame.style.counter.empty())
        counters_.leaveStep(frame.style.counter);
}

namespace {

// "Figure 1" is not broken between its words.
void keepTogether(std::string& text) {
    for (std::size_t at = text.find(' '); at != std::string::npos; at = text.find(' ', at))
        text.replace(at, 1, "\u00A0");
}

} // namespace

// Runs that refer are empty until all is numbered, since they may refer to what comes later.
void ModelBuilder::resolveReferences() {
    for (const std::shared_ptr<Block>& block : referring_)
        for (Run& run : block->runs) {
            if (!run.text.empty() || !run.target.starts_with('#'))
                continue;
            const auto reference = references_.find(run.target.substr(1));
            run.text = reference == references_.end() || reference->second.empty()
                           ? run.target.substr(1)
                           : reference->second;
            keepTogether(run.text);
        }
    referring_.clear();
}

// --- what elements become -------------------------------------------------------------------

bool ModelBuilder::beginDisplay(Frame& frame) {
    frame.role = Role::inlined;
    switch (frame.style.display) {
    case Display::unknown:
        return beginUnknown(frame);
    case Display::block:
        return beginBlock(frame);
    case Display::inlined:
        return true;
    case Display::verbatim:
        return beginVerbatim(frame);
    case Display::table:
        return beginTable(frame);
    case Display::row:
        return beginRow(frame);
    case Display::cell:
        return beginCell(frame);
    case Display::image:
        return addImage(frame);
    case Display::pageBreak:
        return addLeaf(frame, BlockKind::pageBreak);
    case Display::rule:
        return addLeaf(frame, BlockKind::rule);
    case Display::footnote:
        return beginFootnote(frame);
    case Display::link:
        frame.target = attribute(frame.node, "TO");
        return true;
    case Display::reference:
        return beginReference(frame);
    case Display::slider:
    case Display::value:
        return addLiving(frame);
    case Display::chart:
        return addChart(frame);
    }
    return false;
}

bool ModelBuilder::beginBlock(Frame& frame) {
    if (!frame.marker.empty() && markers_ > 1) {
        // An item in an item: the outer one's marker stands on a line of its own.
        std::string marker;
        marker.swap(frame.marker);
        openText();
        marker.swap(frame.marker);
    }
    const BlockStyle& style = frame.style.block;
    frame.role = Role::block;
    closeText();
    flow_.space = std::max(flow_.space, style.spaceBefore);
    flow_.pageBreak = flow_.pageBreak || style.pageBreakBefore;
    frame.indentLeft += style.indentLeft;
    frame.indentRight += style.indentRight;
    frame.firstBlock = flow_.out != nullptr ? flow_.out->size() : 0;
    if (style.keepTogether)
        frame.together = std::min(frame.together, frame.firstBlock);
    if ((style.background || style.border.width > 0) && flow_.out == &model_.blocks) {
        flow_.padding += style.padding;
        frame.indentLeft += style.padding;
        frame.indentRight += style.padding;
    }
    return true;
}

void ModelBuilder::dropMarker(Frame& frame) {
    markers_ -= frame.marker.empty() ? 0 : 1;
    frame.marker.clear();
}

void ModelBuilder::endBlock(Frame& frame) {
    const bool nothing = emitted_ == frame.emitted && tree_.isElement(frame.node);
    if (nothing && frame.role == Role::block &&
        (!frame.marker.empty() || tree_.childElement(frame.node) == noNode))
        openText();
    closeText();
    dropMarker(frame);
    if (frame.role != Role::block && frame.role != Role::table)
        return;
    const BlockStyle& style = frame.style.block;
    flow_.space = std::max(flow_.space, style.spaceAfter);
    if (flow_.out == nullptr || flow_.out->size() <= frame.firstBlock)
        return;
    if ((!style.background && style.border.width <= 0) || flow_.out != &model_.blocks ||
        frame.role != Role::block)
        return;
    flow_.padding += style.padding;
    model_.boxes.push_back({.first = frame.firstBlock,
                            .last = flow_.out->size() - 1,
                            .indentLeft = frame.indentLeft - style.padding,
                            .indentRight = frame.indentRight - style.padding,
                            .padding = style.padding,
                            .background = style.background,
                            .border = style.border});
}

bool ModelBuilder::beginVerbatim(Frame& frame) {
    beginBlock(frame);
    addBlock(BlockKind::verbatim);
    flow_.open = true;
    return true;
}

// The line end before the closing brace is the brace's, not the text's.
void ModelBuilder::endVerbatim() {
    if (!flow_.open || flow_.last->runs.empty())
        return;
    std::string& last = flow_.last->runs.back().text;
    if (last.ends_with('\n'))
        last.pop_back();
    if (last.empty())
        flow_.last->runs.pop_back();
}

// Blocks in a table that are no rows, such as its caption, stand before or behind it.
bool ModelBuilder::beginTable(Frame& frame) {
    beginBlock(frame);
    if (tables_ >= deepestTable)
        return true;
    ++tables_;
    frame.role = Role::table;
    return true;
}

bool ModelBuilder::beginRow(Frame& frame) {
    Frame& table = frames_[frames_.size() - 2];
    if (table.role != Role::table)
        return beginBlock(frame);
    if (table.table == noBlock || table.table + 1 != flow_.out->size()) {
        closeText();
        addBlock(BlockKind::table);
        table.table = flow_.out->size() - 1;
    }
    frame.role = Role::row;
    frame.outer = flow_;
    std::vector<Row>& rows = flow_.last->rows; // of the table's block
    rows.emplace_back();
    flow_ = {};
    flow_.rows = &rows;
    frame.indentLeft = frame.indentRight = 0;
    frame.together = noBlock;
    return true;
}

bool ModelBuilder::beginCell(Frame& frame) {
    if (frames_[frames_.size() - 2].role != Role::row)
        return beginBlock(frame);
    frame.role = Role::cell;
    flow_.out = nullptr; // a cell that began by itself ends here
    flow_.open = false;
    frame.outer = flow_;
    enterCell(frame.style.block, frame.node);
    frame.indentLeft = frame.indentRight = 0;
    return true;
}

bool ModelBuilder::beginFootnote(Frame& frame) {
    if (notes_ >= deepestFootnote)
        return true;
    const std::string number = std::to_string(model_.footnotes.size() + 1);
    const auto footnote = std::make_shared<Footnote>();
    footnote->number = number;
    footnote->element = frame.node;
    model_.footnotes.push_back(footnote);
    Run mark{
        .kind = RunKind::footnote, .text = number, .element = frame.node, .footnote = footnote};
    TextStyle style = frames_[frames_.size() - 2].style.text;
    style.raised = true;
    mark.style = textStyle(style);
    addRun(std::move(mark));
    frame.role = Role::footnote;
    frame.outer = flow_;
    dropMarker(frame);
    frame.marker = number;
    ++markers_;
    ++notes_;
    flow_ = {};
    flow_.out = &footnote->blocks;
    frame.together = noBlock;
    frame.indentLeft = frame.style.block.indentLeft;
    frame.indentRight = frame.style.block.indentRight;
    return true;
}

// LIMIT: of a long start tag the first 120 bytes are shown.
bool ModelBuilder::beginUnknown(Frame& frame) {
    const bool holdsElements = tree_.childElement(frame.node) != noNode;
    std::string tag(tree_.text(tree_.node(frame.node).startTag).substr(0, 120));
    std::replace(tag.begin(), tag.end(), '\n', ' ');
    frame.style.text.family = "mono";
    if (holdsElements)
        beginBlock(frame);
    addText(tag);
    if (holdsElements)
        closeText();
    return true;
}

bool ModelBuilder::beginReference(Frame& frame) {
    frame.target = "#" + attribute(frame.node, "TO");
    if (tree_.node(frame.node).firstChild == noNode)
        addText({});
    return true;
}

Model buildModel(const Document& document, const Presentation& presentation,
                 const Schemas& schemas) {
    ModelBuilder builder(document, presentation, schemas);
    while (builder.step(1000))
        continue;
    return builder.take();
}

} // namespace document
