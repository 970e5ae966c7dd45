// The walk over the tree, and what its elements become. Numbers: model_numbers.cpp; blocks and
// runs: model_blocks.cpp.
#include "model/model_walk.h"

#include <algorithm>

namespace model {

using sgml::NodeId;
using sgml::NodeKind;
using sgml::noNode;

ModelWalk::ModelWalk(const document::Document& document, const schemas::Presentation& presentation,
                     const schemas::Schemas& schemas, std::shared_ptr<schemas::TextStyles> styles,
                     int spacing)
    : document_(document), tree_(document.tree()), presentation_(presentation), schemas_(schemas),
      styles_(std::move(styles)), spacing_(spacing) {
    model_.textStyles = styles_;
    model_.page = presentation_.page();
    flow_.out = &model_.blocks;
    flow_.containers = &model_.containers;
    Frame root;
    root.node = tree_.root();
    root.style = presentation_.rootStyle();
    root.presentation = &presentation_;
    root.progress = presentation_.start();
    push(std::move(root));
    state_.at = tree_.node(tree_.root()).firstChild;
    trail_.push_back({checkpoint(), {}, {}, {}});
}

// --- rests ----------------------------------------------------------------------------------

void ModelWalk::resume(const Checkpoint& from, Model model) {
    model_ = std::move(model);
    state_ = from.state;
    opened_ = from.opened;
    flow_ = {};
    flow_.out = &model_.blocks;
    flow_.containers = &model_.containers;
    flow_.gap = state_.gap;
    trail_.clear();
    trail_.push_back({from, {}, {}, {}});
}

bool ModelWalk::stillHolds(const Checkpoint& checkpoint) const {
    const auto holds = [this](const Frame& frame) {
        if (frame.asked.nested)
            return presentationOf(frame.node) == frame.presentation;
        if (frame.asked.placement != placementIn(frame) ||
            frame.asked.isUncounted != waitsForHeading(frame) ||
            frame.asked.heading != referringHeading(frame))
            return false;
        return frame.style.display != schemas::Display::unknown || !tree_.isElement(frame.node) ||
               frame.asked.holdsElements == (tree_.childElement(frame.node) != noNode);
    };
    const std::vector<Frame>& frames = checkpoint.state.frames;
    return std::all_of(frames.begin() + 1, frames.end(), holds);
}

bool ModelWalk::mayRest() const {
    const std::vector<Frame>& frames = state_.frames;
    return !flow_.open && flow_.out == &model_.blocks && tables_ == 0 && notes_ == 0 &&
           titles_ == 0 && frames.size() <= deepestRest && frames.back().content.together == none;
}

ModelWalk::Checkpoint ModelWalk::checkpoint() const {
    Checkpoint result{.state = state_,
                      .opened = opened_,
                      .offset = state_.at == noNode ? 0 : tree_.node(state_.at).range.from,
                      .blocksBefore = model_.blocks.size(),
                      .boxesBefore = model_.boxes.size(),
                      .containersBefore = model_.containers.size()};
    result.state.gap = flow_.gap;
    return result;
}

bool ModelWalk::isAt(const Checkpoint& checkpoint) const {
    const State& other = checkpoint.state;
    return state_.at == other.at && mayRest() && flow_.gap == other.gap &&
           state_.frames == other.frames && state_.counters == other.counters &&
           state_.anchors == other.anchors && state_.markers == other.markers &&
           state_.footnotes == other.footnotes && state_.titled == other.titled;
}

// --- the walk -------------------------------------------------------------------------------

void ModelWalk::next() {
    if (++sinceRest_ > spacing_ && mayRest()) {
        trail_.push_back({checkpoint(), {}, {}, {}});
        sinceRest_ = 1;
    }
    NodeId id = state_.at;
    if (enter(id) && tree_.node(id).firstChild != noNode) {
        state_.at = tree_.node(id).firstChild;
        return;
    }
    const auto leaveIfOpen = [&](NodeId node) {
        if (state_.frames.back().node == node && state_.frames.size() > 1)
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
    state_.at = id;
}

// True: its children come next. Elements that are entered have a frame.
bool ModelWalk::enter(NodeId node) {
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

ModelWalk::Frame ModelWalk::frameInside(NodeId node) const {
    const Frame& outer = state_.frames.back();
    Frame frame;
    frame.node = node;
    frame.presentation = outer.presentation;
    frame.progress = outer.progress;
    frame.indent = outer.indent;
    frame.content.together = outer.content.together;
    frame.levels = outer.levels;
    frame.target = outer.target;
    frame.numbering.path = outer.numbering.path;
    frame.numbering.reference = outer.numbering.reference;
    frame.blockFrame = outer.role == Role::inlined ? outer.blockFrame : state_.frames.size() - 1;
    return frame;
}

bool ModelWalk::enterElement(NodeId node) {
    Frame frame = frameInside(node);
    const schemas::Presentation::Subject subject{
        .name = tree_.name(node), .first = isFirst(node), .tree = &tree_, .element = node};
    frame.style = frame.presentation->style(subject, state_.frames.back().style, frame.progress);
    takeLanguage(frame, state_.frames.back());
    takePlacement(frame);
    return begin(std::move(frame));
}

// The language of the element, or of the one that it stands in.
void ModelWalk::takeLanguage(Frame& frame, const Frame& outer) const {
    const std::string own = attribute(frame.node, "LANG");
    frame.style.text.language = own.empty() ? outer.style.text.language : own;
}

// A nested document of text goes on in the flow, as its own class's presentation says.
bool ModelWalk::enterNested(NodeId node) {
    const schemas::Presentation* presentation = presentationOf(node);
    if (presentation == nullptr)
        return addSubdocument(node);
    Frame frame = frameInside(node);
    frame.asked.nested = true;
    frame.presentation = presentation;
    frame.progress = frame.presentation->start();
    frame.style = frame.presentation->rootStyle();
    takeLanguage(frame, state_.frames.back());
    return begin(std::move(frame));
}

// That of its class, or null when it is not a document of text.
const schemas::Presentation* ModelWalk::presentationOf(NodeId nested) const {
    const document::Subdocument* known = document_.subdocument(document_.subdocumentOf(nested));
    const bool isText =
        known != nullptr && known->classElement != noNode && schemas_.isText(known->className);
    return isText ? &schemas_.presentation(known->className) : nullptr;
}

void ModelWalk::push(Frame frame) {
    state_.frames.push_back(std::move(frame));
    opened_.emplace_back();
}

void ModelWalk::pop() {
    state_.frames.pop_back();
    opened_.pop_back();
}

bool ModelWalk::begin(Frame frame) {
    beginNumbering(frame);
    if (!frame.style.show) {
        endNumbering(frame);
        return false;
    }
    state_.markers += frame.numbering.marker.empty() ? 0 : 1;
    if (frame.style.title)
        ++titles_;
    push(std::move(frame));
    const bool inside = beginDisplay(state_.frames.back());
    if (inside && !state_.frames.back().style.before.empty())
        addGenerated(state_.frames.back(), "BEFORE",
                     std::string(state_.frames.back().style.before));
    if (!inside || tree_.node(state_.frames.back().node).firstChild == noNode)
        leave();
    return inside;
}

void ModelWalk::leave() {
    Frame& frame = state_.frames.back();
    if (!frame.style.after.empty())
        addGenerated(frame, "AFTER", std::string(frame.style.after));
    if (frame.style.display == schemas::Display::verbatim)
        endVerbatim();
    if (frame.style.display == schemas::Display::unknown && frame.role == Role::inlined)
        addText("</" + std::string(tree_.name(frame.node)) + ">");
    if (frame.role != Role::inlined)
        endBlock(frame);
    dropMarker(frame); // an inline element's has no place
    if (frame.role == Role::row || frame.role == Role::cell || frame.role == Role::footnote)
        flow_ = frame.outer;
    tables_ -= frame.role == Role::table ? 1 : 0;
    notes_ -= frame.role == Role::footnote ? 1 : 0;
    if (frame.style.title)
        state_.titled = --titles_ == 0 && !model_.title.empty();
    endNumbering(frame);
    pop();
}

// --- what elements become -------------------------------------------------------------------

bool ModelWalk::beginDisplay(Frame& frame) {
    frame.role = Role::inlined;
    switch (frame.style.display) {
    case schemas::Display::unknown:
        return beginUnknown(frame);
    case schemas::Display::block:
        return beginBlock(frame);
    case schemas::Display::inlined:
        return true;
    case schemas::Display::verbatim:
        return beginVerbatim(frame);
    case schemas::Display::table:
        return beginTable(frame);
    case schemas::Display::row:
        return beginRow(frame);
    case schemas::Display::cell:
        return beginCell(frame);
    case schemas::Display::image:
        return addImage(frame);
    case schemas::Display::pageBreak:
        return addLeaf(BlockKind::pageBreak);
    case schemas::Display::rule:
        return addLeaf(BlockKind::rule);
    case schemas::Display::footnote:
        return beginFootnote(frame);
    case schemas::Display::link:
        frame.target = attribute(frame.node, "TO");
        return true;
    case schemas::Display::reference:
        return beginReference(frame);
    case schemas::Display::slider:
    case schemas::Display::value:
        return addLiving(frame);
    case schemas::Display::chart:
        return addChart(frame);
    case schemas::Display::contents:
        return addContents();
    case schemas::Display::formula:
        return addFormula(frame);
    case schemas::Display::equation:
        return addEquation(frame);
    }
    return false;
}

bool ModelWalk::beginBlock(Frame& frame) {
    if (!frame.numbering.marker.empty() && state_.markers > 1) {
        // An item in an item: the outer one's marker stands on a line of its own.
        std::string marker;
        marker.swap(frame.numbering.marker);
        openText();
        marker.swap(frame.numbering.marker);
        frame.content.empty = true;
        frame.content.filled = false;
    }
    const schemas::BlockStyle& style = frame.style.block;
    frame.role = Role::block;
    if (isContainer(frame.style.role))
        ++frame.levels[static_cast<std::size_t>(frame.style.role)];
    closeText();
    flow_.gap.space = std::max(flow_.gap.space, style.spaceBefore);
    flow_.gap.pageBreak = flow_.gap.pageBreak || style.pageBreakBefore;
    frame.indent.left += style.indentLeft;
    frame.indent.right += style.indentRight;
    if (style.keepTogether && flow_.out != nullptr)
        frame.content.together = std::min(frame.content.together, flow_.out->size());
    if ((style.background || style.border.width > 0) && flow_.out == &model_.blocks) {
        flow_.gap.padding += style.padding;
        frame.indent.left += style.paddingAside();
        frame.indent.right += style.paddingAside();
        frame.content.boxed = true;
    }
    return true;
}

void ModelWalk::dropMarker(Frame& frame) {
    state_.markers -= frame.numbering.marker.empty() ? 0 : 1;
    frame.numbering.marker.clear();
}

void ModelWalk::endBlock(Frame& frame) {
    if (frame.content.empty && frame.role == Role::block && tree_.isElement(frame.node) &&
        (!frame.numbering.marker.empty() || tree_.childElement(frame.node) == noNode))
        openText();
    closeText();
    dropMarker(frame);
    if (frame.role != Role::block && frame.role != Role::table)
        return;
    const schemas::BlockStyle& style = frame.style.block;
    flow_.gap.space = std::max(flow_.gap.space, style.spaceAfter);
    close();
}

bool ModelWalk::beginVerbatim(Frame& frame) {
    beginBlock(frame);
    addBlock(BlockKind::verbatim);
    flow_.open = true;
    return true;
}

// The line end before the closing brace is the brace's, not the text's.
void ModelWalk::endVerbatim() {
    if (!flow_.open || flow_.last->runs.empty())
        return;
    std::string& last = flow_.last->runs.back().text;
    if (last.ends_with('\n'))
        last.pop_back();
    if (last.empty())
        flow_.last->runs.pop_back();
}

// Blocks in a table that are no rows, such as its caption, stand before or behind it.
document::TableGrid gridOf(const Block& table) {
    std::vector<std::vector<document::Span>> spans;
    spans.reserve(table.rows.size());
    for (const Row& row : table.rows) {
        std::vector<document::Span>& of = spans.emplace_back();
        of.reserve(row.size());
        for (const Cell& cell : row)
            of.push_back(cell.span);
    }
    return document::TableGrid(spans);
}

bool ModelWalk::beginTable(Frame& frame) {
    beginBlock(frame);
    if (tables_ >= deepestTable)
        return true;
    ++tables_;
    frame.role = Role::table;
    frame.table.widths = columnWidths(frame.node);
    frame.content.boxed = false;
    return true;
}

// `WIDTHS="30mm auto"`: what is no length is automatic.
std::vector<double> ModelWalk::columnWidths(NodeId table) const {
    std::vector<double> widths;
    std::string_view rest = tree_.attribute(table, "WIDTHS").value_or("");
    while (!rest.empty() && widths.size() < mostWidths) {
        const std::size_t end = std::min(rest.find(' '), rest.size());
        if (end > 0)
            widths.push_back(std::max(0.0, schemas::lengthOf(rest.substr(0, end)).value_or(0)));
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return widths;
}

bool ModelWalk::beginRow(Frame& frame) {
    Frame& table = state_.frames[state_.frames.size() - 2];
    if (table.role != Role::table)
        return beginBlock(frame);
    if (table.table.block == none || table.table.block + 1 != flow_.out->size()) {
        closeText();
        addBlock(BlockKind::table).columnWidths = table.table.widths;
        table.table.block = flow_.out->size() - 1;
    }
    frame.role = Role::row;
    frame.outer = flow_;
    std::vector<Row>& rows = flow_.last->rows; // of the table's block
    if (frame.style.repeat && flow_.last->headerRows == rows.size())
        ++flow_.last->headerRows;
    rows.emplace_back();
    flow_ = {};
    flow_.rows = &rows;
    frame.indent.left = frame.indent.right = 0;
    frame.content.together = none;
    return true;
}

bool ModelWalk::beginCell(Frame& frame) {
    if (state_.frames[state_.frames.size() - 2].role != Role::row)
        return beginBlock(frame);
    frame.role = Role::cell;
    flow_.out = nullptr; // a cell that began by itself ends here
    flow_.open = false;
    frame.outer = flow_;
    enterCell(frame.style.block, frame.node);
    flow_.rows->back().back().span = {document::spannedBy(tree_.attribute(frame.node, "COLUMNS")),
                                      document::spannedBy(tree_.attribute(frame.node, "ROWS"))};
    frame.indent.left = frame.indent.right = 0;
    return true;
}

bool ModelWalk::beginFootnote(Frame& frame) {
    if (notes_ >= deepestFootnote)
        return true;
    const std::string number = std::to_string(++state_.footnotes);
    const auto footnote = std::make_shared<Footnote>();
    footnote->number = number;
    footnote->element = frame.node;
    model_.footnotes.push_back(footnote);
    Run mark{
        .kind = RunKind::footnote, .text = number, .element = frame.node, .footnote = footnote};
    schemas::TextStyle style = state_.frames[state_.frames.size() - 2].style.text;
    style.raised = true;
    mark.style = textStyle(style);
    addRun(std::move(mark));
    frame.role = Role::footnote;
    frame.outer = flow_;
    dropMarker(frame);
    frame.numbering.marker = number;
    ++state_.markers;
    ++notes_;
    flow_ = {};
    flow_.out = &footnote->blocks;
    flow_.containers = &footnote->containers;
    frame.content.together = none;
    frame.indent.left = frame.style.block.indentLeft;
    frame.indent.right = frame.style.block.indentRight;
    return true;
}

// LIMIT: of a long start tag the first 120 bytes are shown.
bool ModelWalk::beginUnknown(Frame& frame) {
    frame.asked.holdsElements = tree_.childElement(frame.node) != noNode;
    std::string tag(tree_.text(tree_.node(frame.node).startTag).substr(0, 120));
    std::replace(tag.begin(), tag.end(), '\n', ' ');
    frame.style.text.family = "mono";
    if (frame.asked.holdsElements)
        beginBlock(frame);
    addText(tag);
    if (frame.asked.holdsElements)
        closeText();
    return true;
}

bool ModelWalk::beginReference(Frame& frame) {
    frame.target = "#" + attribute(frame.node, "TO");
    if (tree_.node(frame.node).firstChild == noNode)
        addText({});
    return true;
}

} // namespace model
