#include "sgml/parser.h"

#include "sgml/braces.h"
#include "sgml/work.h"
#include "text/characters.h"

#include <algorithm>

namespace sgml {

namespace {

bool isBlank(char c) {
    return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f' || c == '\v';
}
bool isNameStart(char c) { return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z'); }
bool isNamePart(char c) {
    return isNameStart(c) || (c >= '0' && c <= '9') || c == '-' || c == '_' || c == '.' || c == ':';
}

std::string quoted(std::string_view text) {
    constexpr std::size_t longest = 40;
    return '"' + std::string(text.substr(0, longest)) + (text.size() > longest ? "...\"" : "\"");
}

std::string startTagOf(std::string_view name) { return "<" + std::string(name) + ">"; }
std::string endTagOf(std::string_view name) { return "</" + std::string(name) + ">"; }

} // namespace

Parser::Parser(Tree& tree) : tree_(tree), text_(tree.bytes_), limits_(tree.limits_) {}

void Parser::parse() {
    tree_.nodes_.push_back({.kind = NodeKind::document, .range = {0, text_.size()}});
    open_ = {tree_.root()};
    if (checkEncoding()) {
        checkBytes({0, text_.size()});
        resume(0, {tree_.root()});
        while (readNext()) {
        }
        for (NodeId id = 0; id < tree_.nodes_.size(); ++id)
            if (tree_.nodes_[id].kind == NodeKind::document)
                checkDocument(id);
    }
    countUnlisted();
    tree_.sortFaults();
}

void Parser::resume(std::size_t at, std::vector<NodeId> open) {
    open_ = std::move(open);
    at_ = at;
    elementDepth_ = 0;
    openNames_.clear();
    complete_.clear();
    for (const NodeId id : open_) {
        if (tree_.isElement(id)) {
            ++elementDepth_;
            ++openNames_[tree_.name(id)];
        } else if (tree_.classElement(id) != noNode) {
            complete_.insert(id);
        }
    }
    if (at == 0)
        begin();
}

void Parser::begin() {
    if (text_.starts_with(text::byteOrderMark))
        at_ = text::byteOrderMark.size();
    skipBlanks();
    if (!atEnd())
        readDocumentLine();
}

bool Parser::readNext() {
    const std::size_t from = at_;
    skipBlanks();
    const bool more = !atEnd();
    if (more)
        readItem();
    else
        closeAllAtEnd();
    work().bytesRead += at_ - from;
    return more;
}

// --- characters -----------------------------------------------------------------------------

bool Parser::startsHere(std::string_view token) const {
    return text_.substr(at_).starts_with(token);
}

void Parser::skipBlanks() {
    while (!atEnd() && isBlank(here()))
        ++at_;
}

text::Range Parser::readName() {
    const std::size_t from = at_;
    if (!atEnd() && isNameStart(here()))
        while (!atEnd() && isNamePart(here()))
            ++at_;
    return {from, at_};
}

// --- items ----------------------------------------------------------------------------------

void Parser::readItem() {
    if (nodes_ >= limits_.nodes) {
        stop("more than " + std::to_string(limits_.nodes) +
             " elements and contents; reading stops here");
        return;
    }
    const char next = at_ + 1 < text_.size() ? text_[at_ + 1] : '\0';
    if (here() == '{')
        readContent();
    else if (here() != '<')
        readStray(FaultKind::strayText, "text outside braces");
    else if (next == '/')
        readEndTag();
    else if (next == '!' || next == '?')
        readMarkup();
    else if (isNameStart(next))
        readStartTag();
    else
        readStray(FaultKind::badTag, "\"<\" is not followed by a name, which begins with a letter");
}

// The `DOCUMENT CLASS` of the document node on top. Without it, reading goes on where it should be.
void Parser::readDocumentLine() {
    constexpr std::string_view keyword = "DOCUMENT";
    const NodeId document = top();
    const std::size_t start = at_;
    const std::size_t after = at_ + keyword.size();
    if (!startsHere(keyword) || after >= text_.size() || !isBlank(text_[after])) {
        const bool bare = startsHere(keyword) && (after >= text_.size() || text_[after] == '<');
        fault(FaultKind::badDocumentLine, {at_, at_},
              bare ? "DOCUMENT is not followed by a class"
                   : "a document begins with DOCUMENT and its class");
        if (bare)
            at_ = after;
        return;
    }
    at_ = after;
    skipBlanks();
    Node& node = tree_.nodes_[document];
    node.name = readName();
    if (document != tree_.root())
        node.range.from = start;
    if (node.name.empty())
        fault(FaultKind::badDocumentLine, {start, after}, "DOCUMENT is not followed by a class");
}

void Parser::readStartTag() {
    const std::size_t from = at_;
    if (elementDepth_ >= limits_.depth) {
        stop("elements are nested deeper than " + std::to_string(limits_.depth) +
             "; reading stops here");
        return;
    }
    ++at_;
    const text::Range name = readName();
    checkPlace(NodeKind::element, from);
    const NodeId element = addNode(NodeKind::element, {from, at_});
    tree_.nodes_[element].name = name;
    tree_.nodes_[element].firstAttribute = static_cast<std::uint32_t>(tree_.attributes_.size());
    readAttributes(element);
    finishStartTag(element);
}

void Parser::finishStartTag(NodeId element) {
    const std::size_t from = tree_.nodes_[element].range.from;
    bool selfClosed = false;
    if (!atEnd() && here() == '>') {
        selfClosed = text_[at_ - 1] == '/';
        ++at_;
    } else {
        fault(FaultKind::badTag, {from, at_},
              "the tag " + quoted(text_.substr(from, at_ - from)) + " is not closed with \">\"");
    }
    tree_.nodes_[element].startTag = {from, at_};
    open(element);
    if (selfClosed) {
        fault(FaultKind::notOfFormat, {from, at_},
              "a tag that closes itself; write " + endTagOf(tree_.name(element)) + " after it");
        close(at_, {at_, at_});
    } else if (tree_.name(element) == "DOCUMENT") {
        skipBlanks();
        if (startsHere("</"))
            return;
        open(addNode(NodeKind::document, {at_, at_}));
        readDocumentLine();
    }
}

void Parser::readEndTag() {
    const std::size_t from = at_;
    at_ += 2;
    const std::string_view name = tree_.text(readName());
    skipBlanks();
    const bool closed = !atEnd() && here() == '>';
    if (closed)
        ++at_;
    const text::Range tag{from, at_};
    if (!closed)
        fault(FaultKind::badTag, tag,
              "the end tag " + endTagOf(name) + " is not closed with \">\"");
    const auto known = openNames_.find(name);
    if (known == openNames_.end() || known->second == 0) {
        fault(FaultKind::unmatchedEndTag, tag,
              endTagOf(name) + " closes nothing: no " + startTagOf(name) + " is open here");
        addNode(NodeKind::stray, tag);
        return;
    }
    while (tree_.nodes_[top()].kind == NodeKind::document || tree_.name(top()) != name)
        closeMissing(tag);
    close(at_, tag);
}

void Parser::readContent() {
    const std::size_t from = at_;
    checkPlace(NodeKind::content, from);
    Node& node = tree_.nodes_[addNode(NodeKind::content, {from, from + 1})];
    node.startTag = {from, from + 1};
    const std::size_t closing = closingBraceOf(from);
    if (closing == std::string_view::npos) {
        at_ = endOfUnclosedContent();
        node.endTag = {at_, at_};
        fault(FaultKind::unterminatedContent, {from, from + 1},
              "this \"{\" is never closed with \"}\"");
    } else {
        at_ = closing + 1;
        node.endTag = {closing, at_};
    }
    node.range.to = at_;
}

// All that are never closed are found at once, when the first one is.
std::size_t Parser::closingBraceOf(std::size_t open) {
    if (unclosedKnown_ && std::binary_search(unclosed_.begin(), unclosed_.end(), open))
        return std::string_view::npos;
    const std::size_t closing = closingBrace(text_, open);
    if (closing == std::string_view::npos && !unclosedKnown_) {
        unclosed_ = unclosedBraces(text_.substr(open));
        for (std::size_t& brace : unclosed_)
            brace += open;
        unclosedKnown_ = true;
    }
    return closing;
}

// Before the next end tag of an element that is open, else the text's end.
std::size_t Parser::endOfUnclosedContent() const {
    for (std::size_t at = at_; (at = text_.find("</", at)) != std::string_view::npos; at += 2) {
        std::size_t end = at + 2;
        while (end < text_.size() && isNamePart(text_[end]))
            ++end;
        const auto known = openNames_.find(text_.substr(at + 2, end - at - 2));
        if (known != openNames_.end() && known->second > 0)
            return at;
    }
    return text_.size();
}

// Comments, declarations and processing instructions are kept and not understood.
void Parser::readMarkup() {
    const std::string_view end = startsHere("<!--") ? "-->" : ">";
    const std::size_t found = text_.find(end, at_ + 2);
    const std::size_t from = at_;
    at_ = found == std::string_view::npos ? text_.size() : found + end.size();
    fault(FaultKind::notOfFormat, {from, at_},
          end.size() > 1 ? "comments do not belong to the format"
                         : "declarations and processing instructions do not belong to the format");
    addNode(NodeKind::stray, {from, at_});
}

// Up to the next tag or content; a brace behind a backslash begins none.
void Parser::readStray(FaultKind kind, std::string message) {
    const std::size_t from = at_;
    if (here() != '\\')
        ++at_;
    while ((at_ = text_.find_first_of("<{\\", at_)) != std::string_view::npos && here() == '\\')
        at_ += 2;
    at_ = std::min(at_, text_.size());
    std::size_t to = at_;
    while (to > from + 1 && isBlank(text_[to - 1]))
        --to;
    if (tree_.nodes_[top()].kind == NodeKind::document && isComplete(top()))
        checkPlace(NodeKind::stray, from);
    else
        fault(kind, {from, to}, message + ": " + quoted(text_.substr(from, to - from)));
    addNode(NodeKind::stray, {from, to});
}

// --- nodes ----------------------------------------------------------------------------------

NodeId Parser::addNode(NodeKind kind, text::Range range) {
    ++nodes_;
    ++work().nodesMade;
    const NodeId id = tree_.newNode();
    Node& node = tree_.nodes_[id];
    node.kind = kind;
    node.parent = top();
    node.range = range;
    // Places that the node does not have stand where they move along with it.
    node.name = node.startTag = {range.from, range.from};
    node.endTag = {range.to, range.to};
    Node& parent = tree_.nodes_[top()];
    if (parent.lastChild == noNode)
        parent.firstChild = id;
    else
        tree_.nodes_[parent.lastChild].next = id;
    parent.lastChild = id;
    if (kind == NodeKind::element && parent.kind == NodeKind::document)
        complete_.insert(top());
    return id;
}

// Is another child allowed here? It is read in any case.
void Parser::checkPlace(NodeKind kind, std::size_t at) {
    const NodeId parent = top();
    if (tree_.nodes_[parent].kind == NodeKind::document) {
        checkPlaceInDocument(parent, kind, at);
        return;
    }
    for (NodeId child = tree_.nodes_[parent].lastChild; child != noNode; child = noNode) {
        const NodeKind before = tree_.nodes_[child].kind;
        if (before == NodeKind::content && kind == NodeKind::content)
            fault(FaultKind::mixedContent, {at, at + 1},
                  startTagOf(tree_.name(parent)) + " has two contents in braces");
        else if ((before == NodeKind::content || before == NodeKind::element) && before != kind)
            fault(FaultKind::mixedContent, {at, at + 1},
                  startTagOf(tree_.name(parent)) + " holds both elements and content in braces");
    }
}

void Parser::checkPlaceInDocument(NodeId document, NodeKind kind, std::size_t at) {
    const bool complete = isComplete(document);
    if (complete && document == tree_.root()) {
        if (!trailingReported_)
            fault(FaultKind::trailingText, {at, at + 1}, "the document has ended before this");
        trailingReported_ = true;
    } else if (complete) {
        fault(FaultKind::trailingText, {at, at + 1}, "the nested document has ended before this");
    } else if (kind == NodeKind::content) {
        fault(FaultKind::strayText, {at, at + 1},
              "content in braces stands where a document's element begins");
    }
}

void Parser::open(NodeId id) {
    open_.push_back(id);
    if (tree_.isElement(id)) {
        ++elementDepth_;
        ++openNames_[tree_.name(id)];
    }
}

void Parser::close(std::size_t end, text::Range endTag) {
    const NodeId id = top();
    Node& node = tree_.nodes_[id];
    node.range.to = end;
    node.endTag = endTag;
    open_.pop_back();
    if (node.kind == NodeKind::element) {
        --elementDepth_;
        --openNames_[tree_.name(id)];
    }
}

// The end of the top when nothing closes it: behind its last child.
std::size_t Parser::endOfTop() const {
    const Node& node = tree_.nodes_[top()];
    if (node.lastChild != noNode)
        return tree_.nodes_[node.lastChild].range.to;
    return std::max({node.range.from, node.startTag.to, node.name.to});
}

void Parser::closeMissing(text::Range endTag) {
    const std::size_t end = endOfTop();
    if (tree_.isElement(top()))
        fault(FaultKind::missingEndTag, {endTag.from, endTag.from},
              endTagOf(tree_.name(top())) + " is missing before " + quoted(tree_.text(endTag)));
    close(end, {end, end});
}

void Parser::closeAllAtEnd() {
    std::size_t count = 0;
    NodeId innermost = noNode;
    for (const NodeId id : open_)
        if (tree_.isElement(id)) {
            ++count;
            innermost = id;
        }
    if (count > 0)
        fault(FaultKind::missingEndTag, {text_.size(), text_.size()},
              "the text ends inside " + startTagOf(tree_.name(innermost)) +
                  (count > 1 ? " and " + std::to_string(count - 1) + " more open elements" : ""));
    while (open_.size() > 1) {
        const std::size_t end = tree_.isElement(top()) ? text_.size() : endOfTop();
        close(end, {end, end});
    }
}

void Parser::checkDocument(NodeId id) {
    const Node& document = tree_.nodes_[id];
    const NodeId element = tree_.classElement(id);
    const std::size_t at = std::max(document.range.from, document.name.to);
    if (element == noNode) {
        fault(FaultKind::emptyDocument, {at, at}, "the document holds no element");
    } else if (!document.name.empty() && tree_.name(element) != tree_.text(document.name)) {
        fault(FaultKind::classMismatch, tree_.nodes_[element].startTag,
              "the document's class is " + std::string(tree_.text(document.name)) +
                  ", but its element is " + startTagOf(tree_.name(element)));
    }
}

void Parser::stop(std::string message) {
    fault(FaultKind::limit, {at_, at_}, std::move(message));
    addNode(NodeKind::stray, {at_, text_.size()});
    at_ = text_.size();
    stopped_ = true;
    while (open_.size() > 1)
        close(text_.size(), {text_.size(), text_.size()});
}

} // namespace sgml
