// The effects of an edit on a tree besides reading: places move, faults go, numbers become free.
#include "sgml/reparser.h"

#include "text/characters.h"

#include <algorithm>

namespace sgml {

namespace {

void move(text::Range& range, std::size_t distance) {
    range.from += distance;
    range.to += distance;
}

bool isOfBytes(const Fault& fault) {
    return fault.kind == FaultKind::invalidUtf8 || fault.kind == FaultKind::nulByte;
}

bool isAscii(char c) { return static_cast<unsigned char>(c) < 0x80; }

} // namespace

// --- places ---------------------------------------------------------------------------------

// LIMIT: moves the bytes behind an edit: 4 MB take 0.1 ms.
void Reparser::replaceBytes() {
    constexpr std::size_t few = 4;
    if (edits_.size() > few)
        tree_.bytes_ = text::applied(tree_.bytes_, edits_);
    else
        for (auto edit = edits_.rbegin(); edit != edits_.rend(); ++edit)
            tree_.bytes_.replace(edit->range.from, edit->range.size(), edit->text);
    tree_.lines_.follow(edits_, tree_.bytes_);
}

// The loop is over the array, since all nodes behind the edits move.
void Reparser::shiftNodes(const Shift& shift, text::Range hull) {
    const std::size_t all = shift.distance({nowhere, nowhere});
    for (NodeId id = 0; id < tree_.nodes_.size(); ++id) {
        Node& node = tree_.nodes_[id];
        if (node.range.to < hull.from)
            continue;
        const bool isBehind = node.range.from > hull.to;
        if (!isBehind && shift.touches(node.range)) {
            shiftNode(id, shift);
            continue;
        }
        const std::size_t distance = isBehind ? all : shift.distance(node.range);
        move(node.range, distance);
        move(node.name, distance);
        move(node.startTag, distance);
        move(node.endTag, distance);
    }
}

void Reparser::shiftNode(NodeId id, const Shift& shift) {
    Node& node = tree_.nodes_[id];
    if (node.kind == NodeKind::content && shift.changes(node.range))
        editedTexts_.push_back(id);
    const bool isElement = node.kind == NodeKind::element;
    if (shift.changes(isElement ? node.startTag : node.name))
        editedTags_.push_back(id);
    const std::size_t from = shift.ofStart(node.range.from), end = shift.ofEnd(node.endTag.to);
    const auto moved = [&](text::Range range) {
        const std::size_t at = shift.ofStart(range.from);
        return range.empty() ? text::Range{at, at} : shift.of(range);
    };
    const bool renamed = isElement && shift.changes(node.name);
    node.name = renamed ? text::Range{nowhere, nowhere} : moved(node.name);
    node.startTag = moved(node.startTag);
    node.endTag = node.endTag.empty() ? text::Range{end, end} : shift.of(node.endTag);
    node.range = {from, shift.ofEnd(node.range.to)};
}

void Reparser::shiftAttributes(const Shift& shift, text::Range hull) {
    for (Attribute& attribute : tree_.attributes_) {
        if (attribute.whole.to < hull.from)
            continue;
        if (shift.touches(attribute.whole)) {
            attribute = {shift.of(attribute.name), shift.of(attribute.value),
                         shift.of(attribute.whole)};
            continue;
        }
        const std::size_t distance = shift.distance(attribute.whole);
        for (text::Range* range : {&attribute.name, &attribute.value, &attribute.whole})
            move(*range, distance);
    }
}

// --- faults ---------------------------------------------------------------------------------

void Reparser::shiftFaults(const Shift& shift) {
    faults_ = std::move(tree_.faults_);
    tree_.faults_.clear();
    for (Fault& fault : faults_) {
        const bool empty = fault.range.empty();
        fault.range = shift.of(fault.range);
        if (empty)
            fault.range.to = fault.range.from;
    }
    std::erase_if(faults_, [](const Fault& fault) { return fault.range.from == nowhere; });
}

void Reparser::forgetFaults(text::Range read) {
    std::erase_if(faults_, [&](const Fault& fault) {
        return !isOfBytes(fault) && read.contains(fault.range.from);
    });
}

// A document is checked when all of it is read, and its faults stand at its start.
void Reparser::forgetFaultsOf(NodeId document) {
    if (faults_.empty())
        return;
    const Node& node = tree_.nodes_[document];
    const NodeId element = tree_.classElement(document);
    const std::size_t atLine = std::max(node.range.from, node.name.to);
    const std::size_t atElement = element == noNode ? nowhere : tree_.nodes_[element].startTag.from;
    std::erase_if(faults_, [&](const Fault& fault) {
        return (fault.kind == FaultKind::emptyDocument && fault.range.from == atLine) ||
               (fault.kind == FaultKind::classMismatch && fault.range.from == atElement);
    });
}

// Whether bytes are UTF-8 depends on their neighbours up to the next ASCII character.
void Reparser::checkEditedBytes() {
    const std::string& bytes = tree_.bytes_;
    std::size_t distance = 0, checked = 0;
    for (const text::Edit& edit : edits_) {
        text::Range around{edit.range.from + distance,
                           edit.range.from + distance + edit.text.size()};
        distance += edit.text.size() - edit.range.size();
        while (around.from > checked && !isAscii(bytes[around.from - 1]))
            --around.from;
        around.from = std::max(around.from, checked);
        while (around.to < bytes.size() && !isAscii(bytes[around.to]))
            ++around.to;
        if (around.to <= around.from)
            continue;
        std::erase_if(faults_, [&](const Fault& fault) {
            return isOfBytes(fault) && around.contains(fault.range.from);
        });
        parser_->checkBytes(around);
        checked = around.to;
    }
}

void Reparser::checkDocuments() {
    for (const Change::Children& children : change_.children)
        for (const NodeId top : children.added)
            for (NodeId id = top; id != noNode; id = tree_.following(id, top))
                if (tree_.nodes_[id].kind == NodeKind::document)
                    documents_.push_back(id);
    std::sort(documents_.begin(), documents_.end());
    documents_.erase(std::unique(documents_.begin(), documents_.end()), documents_.end());
    for (const NodeId id : documents_)
        parser_->checkDocument(id);
}

// --- numbers --------------------------------------------------------------------------------

// The content of an element stays, whatever text it holds now.
void Reparser::keepContent(std::vector<NodeId>& removed, std::vector<NodeId>& added,
                           std::vector<NodeId>& all) {
    const auto isContent = [&](NodeId id) { return tree_.nodes_[id].kind == NodeKind::content; };
    const auto old = std::find_if(removed.begin(), removed.end(), isContent);
    const auto read = std::find_if(added.begin(), added.end(), isContent);
    if (old == removed.end() || read == added.end())
        return;
    const NodeId id = *old;
    const Node& now = tree_.nodes_[*read];
    if (tree_.nodes_[id].range != now.range ||
        std::binary_search(editedTexts_.begin(), editedTexts_.end(), id))
        change_.texts.push_back(id);
    tree_.nodes_[id] = now;
    spare_.push_back(*read);
    all[static_cast<std::size_t>(read - added.begin())] = id;
    removed.erase(old);
    added.erase(read);
}

void Reparser::freeNodes() {
    for (const Change::Children& children : change_.children)
        for (const NodeId top : children.removed)
            for (NodeId id = top; id != noNode; id = tree_.following(id, top))
                change_.gone.push_back(id);
    const auto free = [&](NodeId id) {
        tree_.unusedAttributes_ += tree_.nodes_[id].attributeCount;
        tree_.nodes_[id] = {};
        tree_.free_.push_back(id);
    };
    std::for_each(change_.gone.begin(), change_.gone.end(), free);
    std::for_each(spare_.begin(), spare_.end(), free);
}

// Attributes of nodes that are gone are thrown away when they are the most.
void Reparser::packAttributes() {
    constexpr std::size_t few = 1000;
    if (tree_.unusedAttributes_ < few || tree_.unusedAttributes_ < tree_.attributes_.size() / 2)
        return;
    std::vector<Attribute> used;
    for (Node& node : tree_.nodes_) {
        const auto first = tree_.attributes_.begin() + node.firstAttribute;
        node.firstAttribute = static_cast<std::uint32_t>(used.size());
        used.insert(used.end(), first, first + node.attributeCount);
    }
    tree_.attributes_ = std::move(used);
    tree_.unusedAttributes_ = 0;
}

} // namespace sgml
