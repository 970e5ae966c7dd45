// Elements that become one run or one block, and have nothing inside that is walked.
#include "model/model_walk.h"

namespace model {

using sgml::NodeId;

std::optional<schemas::Align> alignOf(document::Placement placement) {
    switch (placement) {
    case document::Placement::left:
        return schemas::Align::left;
    case document::Placement::center:
        return schemas::Align::center;
    case document::Placement::right:
        return schemas::Align::right;
    default:
        return std::nullopt;
    }
}

ValueLooks ModelWalk::valueLooks(const Frame& frame) {
    const auto generated = [&](std::string_view name) {
        schemas::Presentation::Progress progress = frame.progress;
        return textStyle(frame.presentation->style({.name = name}, frame.style, progress).text);
    };
    return {.usual = textStyle(frame.style.text),
            .outdated = generated("OUTDATED"),
            .faulty = generated("FAULTY"),
            .language = frame.style.text.language};
}

// LIMIT: a slider is shown as text.
bool ModelWalk::addLiving(const Frame& frame) {
    const bool slider = frame.style.display == schemas::Display::slider;
    Run run{.kind = slider ? RunKind::slider : RunKind::value, .element = frame.node};
    run.style = textStyle(frame.style.text);
    if (slider)
        run.text = attribute(frame.node, "NAME") + " = " + attribute(frame.node, "VALUE");
    else
        run.value = std::make_shared<const Value>(
            Value{document::valueUse(tree_, frame.node), valueLooks(frame)});
    addRun(std::move(run));
    return false;
}

bool ModelWalk::addChart(const Frame& frame) {
    const std::string values = attribute(frame.node, "VALUES"); // before frames move
    Frame& own = state_.frames.back();
    beginBlock(own);
    Block& block = addBlock(BlockKind::chart);
    block.picture = pictureOf(block.element);
    block.runs.push_back(
        {.text = "Chart of " + values, .style = textStyle(own.style.text), .element = own.node});
    return false;
}

// Its values come when the walk is over.
Run ModelWalk::formulaRun(const Frame& frame, bool isAlone) {
    auto formula = std::make_shared<Formula>();
    formula->source = tree_.contentText(frame.node);
    formula->read = formulas::read(formula->source);
    formula->isAlone = isAlone;
    Run run{.kind = RunKind::formula, .element = frame.node};
    run.style = textStyle(frame.style.text);
    if (formula->read.values.empty()) {
        formula->spoken = formulas::spoken(formula->read);
        run.text = formulas::plain(formula->read);
    } else {
        formula->looks = valueLooks(frame);
    }
    run.formula = std::move(formula);
    return run;
}

bool ModelWalk::addFormula(const Frame& frame) {
    addRun(formulaRun(frame, false));
    return false;
}

bool ModelWalk::addEquation(const Frame& frame) {
    Run run = formulaRun(frame, true); // before frames move
    if (flow_.open) // the text of the same paragraph: it is not left alone at a page's end
        flow_.last->style.keepWithNext = true;
    beginBlock(state_.frames.back());
    Block& block = addBlock(BlockKind::formula);
    markValued(run);
    block.runs.push_back(std::move(run));
    return false;
}

// Its heading is generated; what it lists is known when all has been walked over.
bool ModelWalk::addContents() {
    beginBlock(state_.frames.back());
    if (const std::string before = state_.frames.back().style.before; !before.empty())
        addGenerated(state_.frames.back(), "BEFORE", before);
    Block& block = addBlock(BlockKind::contents);
    const Frame& own = state_.frames.back();
    block.lists = own.style.lists;
    block.runs.push_back({.text = block.lists == schemas::ContainerRole::heading
                                      ? "There is no heading yet."
                                  : block.lists == schemas::ContainerRole::figure
                                      ? "There is no figure with a caption yet."
                                      : "There is no table with a caption yet.",
                          .style = textStyle(own.style.text),
                          .element = own.node});
    return false;
}

Picture ModelWalk::pictureOf(NodeId node) const {
    return {.width = lengthAttribute(node, "WIDTH"),
            .height = lengthAttribute(node, "HEIGHT"),
            .alternative = attribute(node, "ALT")};
}

// In a figure it stands for itself, elsewhere in the line.
bool ModelWalk::addImage(const Frame& frame) {
    Picture picture = pictureOf(frame.node);
    picture.source = attribute(frame.node, "FILE");
    if (picture.source.empty())
        picture.source = tree_.contentText(frame.node);
    if (blockFrame().style.role == schemas::ContainerRole::figure) {
        beginBlock(state_.frames.back());
        addBlock(BlockKind::image).picture = std::move(picture);
        return false;
    }
    Run run{.kind = RunKind::image, .element = frame.node};
    run.style = textStyle(frame.style.text);
    run.picture = std::make_shared<const Picture>(std::move(picture));
    addRun(std::move(run));
    return false;
}

bool ModelWalk::addLeaf(BlockKind kind) {
    beginBlock(state_.frames.back());
    addBlock(kind);
    return false;
}

// The author aligns a figure's subdocument, and so what stands in the figure with it: its caption
// begins or ends at the same edge.
void ModelWalk::takePlacement(Frame& frame) const {
    frame.asked.placement = placementIn(frame);
    if (const std::optional<schemas::Align> align = alignOf(frame.asked.placement))
        frame.style.block.align = *align;
    const document::Placement around = state_.frames.back().asked.placement;
    if (around == document::Placement::left)
        frame.style.block.indentLeft = 0;
    if (around == document::Placement::right)
        frame.style.block.indentRight = 0;
}

document::Placement ModelWalk::placementIn(const Frame& figure) const {
    if (figure.style.role != schemas::ContainerRole::figure)
        return document::Placement::unspecified;
    const NodeId element = tree_.childElement(figure.node, "DOCUMENT");
    const document::Subdocument* of = document_.subdocument(document_.subdocumentOf(element));
    return of == nullptr ? document::Placement::unspecified : of->placement;
}

bool ModelWalk::addSubdocument(NodeId node) {
    const document::SubdocumentId id = document_.subdocumentOf(node);
    const document::Subdocument* subdocument = document_.subdocument(id);
    Frame frame = frameInside(node);
    frame.style = frame.presentation->style({"DOCUMENT", isFirst(node), &tree_, node},
                                            state_.frames.back().style, frame.progress);
    if (subdocument != nullptr && !subdocument->name.empty())
        trail_.back().names.push_back({subdocument->name, frame.numbering.reference});
    if (!frame.style.show)
        return false;
    if (subdocument != nullptr && !subdocument->name.empty())
        state_.anchors.push_back(subdocument->name);
    if (subdocument != nullptr && subdocument->placement == document::Placement::inlined) {
        addRun({.kind = RunKind::subdocument,
                .style = textStyle(frame.style.text),
                .element = node,
                .subdocument = id});
        return false;
    }
    push(std::move(frame));
    Frame& own = state_.frames.back();
    beginBlock(own);
    Block& block = addBlock(BlockKind::subdocument);
    block.subdocument = id;
    const auto placed = subdocument == nullptr ? std::nullopt : alignOf(subdocument->placement);
    if (placed)
        block.style.align = *placed;
    else if (block.style.align == schemas::Align::justify)
        block.style.align = schemas::Align::left;
    endBlock(own);
    pop();
    return false;
}

} // namespace model
