// Blocks that come in at the caret, captions, references, and pasted text.
#include "authoring/commands.h"
#include "authoring/leaves.h"

#include "sgml/edit.h"

#include <algorithm>
#include <set>

namespace authoring {

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

namespace {

QString mayNotStand(const Grammar& grammar, std::string_view name) {
    QString what = called(grammar, name);
    what[0] = what[0].toUpper();
    return QStringLiteral("%1 may not stand here.").arg(what);
}

} // namespace

Piece* putBlock(Draft& draft, Piece& mark, std::unique_ptr<Piece> piece) {
    Piece& line = draft.blockOf(mark);
    const bool atStart = draft.isLineBlank(mark, Direction::backward);
    const bool atEnd = draft.isLineBlank(mark, Direction::forward);
    const bool isEmptyParagraph =
        draft.of(line).role == ContainerRole::paragraph && draft.isBlank(line);
    for (Piece* at = &mark; at->parent != nullptr; at = at->parent) {
        Piece& parent = *at->parent;
        draft.openBeside(*at);
        // In front of a line at whose start the mark stands, else behind it.
        const bool before = atStart && !atEnd;
        if (draft.isInlined(parent) ||
            !allows(draft, parent, at->index() + (before ? 0 : 1), piece->name))
            continue;
        if (at != &mark && !atStart && !atEnd)
            draft.split(mark, parent);
        Piece& made = Draft::put(parent, at->index() + (before ? 0 : 1), std::move(piece));
        draft.putOnLine(made, at == &mark ? parent : *at);
        if (before && !at->isMark())
            std::swap(made.gap, at->gap);
        if (isEmptyParagraph && at == &line) {
            made.gap = line.gap;
            for (Piece* moved : {&draft.second(), &draft.first()})
                Draft::moveTo(*moved, parent, made.index() + 1);
            Draft::take(line);
        }
        return &made;
    }
    return nullptr;
}

Result insertBlock(const Manuscript& manuscript, Selection selection, std::string_view name) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!draft.grammar().knows(name))
        return refused(QStringLiteral("This class of documents has no such element."));
    if (name == "DOCUMENT" || draft.grammar().of(name).kind == Kind::inlined)
        return refused(mayNotStand(draft.grammar(), name));
    Piece* made = putBlock(draft, draft.first(), Draft::made(std::string(name)));
    if (made == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    if (!draft.isUnit(*made)) {
        Draft::moveTo(draft.first(), *made, 0);
        if (!makeLine(draft, draft.first()))
            return refused(mayNotStand(draft.grammar(), name));
        draft.collapse();
    }
    return draft.result(QStringLiteral("Insert"));
}

Result insertFigure(const Manuscript& manuscript, Selection selection,
                    const EmbeddedText& embedded) {
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string figure(draft.grammar().named(ContainerRole::figure));
    std::unique_ptr<Piece> document = Draft::made("DOCUMENT");
    document->raw = "<DOCUMENT>\nDOCUMENT " + embedded.className + "\n<" + embedded.className +
                    embedded.attributes + ">\n" +
                    sgml::elementText(embedded.storage, embedded.text) + "\n</" +
                    embedded.className + ">\n</DOCUMENT>";
    Piece* made = nullptr;
    if (!figure.empty())
        made = putBlock(draft, draft.first(), Draft::made(figure));
    if (made != nullptr)
        made = &Draft::put(*made, 0, std::move(document));
    else
        made = putBlock(draft, draft.first(), std::move(document));
    if (made == nullptr)
        return refused(QStringLiteral("A figure may not stand here."));
    Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    return draft.result(QStringLiteral("Figure"));
}

Result insertFormula(const Manuscript& manuscript, Selection selection, std::string_view source,
                     std::string_view kind) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    const std::string name(draft.grammar().named(Display::formula));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no formulas."));
    std::unique_ptr<Piece> formula = Draft::made(name, std::string(kind));
    Draft::put(*formula, 0, Draft::madeText(source));
    Piece* made = kind.empty() ? putInLine(draft, draft.first(), std::move(formula))
                               : putBlock(draft, draft.first(), std::move(formula));
    if (made == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    Draft::moveTo(draft.first(), *made->parent, made->index() + 1);
    draft.collapse();
    return draft.result(QStringLiteral("Formula"));
}

Result setText(const Manuscript& manuscript, NodeId element, std::string_view text) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(element) || !tree.isElement(element))
        return refused(QStringLiteral("What was to be changed is not there any more."));
    const NodeId content = tree.content(element);
    if (content == noNode && tree.node(element).firstChild != noNode)
        return refused(QStringLiteral("This holds more than text."));
    Step step;
    const std::size_t start = tree.node(element).startTag.to;
    if (content == noNode)
        step.edits = {{{start, start}, "{" + sgml::escaped(text) + "}"}};
    else
        step.edits =
            sgml::contentEdit(tree, content, {0, tree.unescaped(content).text().size()}, text);
    const std::size_t after =
        text::moved(tree.node(element).range.to, step.edits, text::Gravity::behind);
    step.after = {after, after};
    step.label = QStringLiteral("Formula");
    return step;
}

Result insertCaption(const Manuscript& manuscript, Selection selection) {
    Draft draft(manuscript, {selection.caret, selection.caret});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string caption(draft.grammar().named(ContainerRole::caption));
    for (Piece* at = draft.first().parent; at != nullptr; at = at->parent) {
        if (caption.empty() || !draft.grammar().mayHold(at->name, caption))
            continue;
        draft.openChildren(*at);
        const auto isCaption = [&](const auto& child) {
            return child->isElement() && child->name == caption;
        };
        const auto known = std::find_if(at->children.begin(), at->children.end(), isCaption);
        Piece* made = known == at->children.end() ? nullptr : known->get();
        for (std::size_t i = at->children.size() + 1; made == nullptr && i-- > 0;)
            if (allows(draft, *at, i, caption)) {
                made = &Draft::put(*at, i, Draft::made(caption));
                if (i > 0)
                    draft.putOnLine(*made, *at);
            }
        if (made == nullptr)
            continue;
        Draft::moveTo(draft.first(), *made, made->children.size());
        draft.collapse();
        return draft.result(QStringLiteral("Caption"));
    }
    return refused(QStringLiteral("Nothing here takes a caption."));
}

// --- references -----------------------------------------------------------------------------

namespace {

std::set<std::string, std::less<>> idsOf(const sgml::Tree& tree) {
    std::set<std::string, std::less<>> ids;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id))
        if (tree.isElement(id))
            if (const auto name = tree.attribute(id, "ID"))
                ids.emplace(*name);
    return ids;
}

// "figure-2": the first that nothing has.
std::string freeId(const sgml::Tree& tree, std::string_view element) {
    std::string stem(element);
    std::transform(stem.begin(), stem.end(), stem.begin(), [](char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
    });
    const std::set<std::string, std::less<>> taken = idsOf(tree);
    for (int number = 1;; ++number)
        if (std::string id = stem + "-" + std::to_string(number); !taken.contains(id))
            return id;
}

// Some elements have a number only with an attribute, such as a formula that stands alone.
bool isNumbered(const sgml::Tree& tree, const Grammar& grammar, NodeId element) {
    const Element& known = grammar.of(tree.name(element));
    const auto& variants = grammar.variants(tree.name(element));
    const bool isPlain = std::none_of(variants.begin(), variants.end(), [&](const auto& variant) {
        return tree.attribute(element, variant.first) == variant.second;
    });
    return known.isNumbered && (known.kind != Kind::unit || variants.empty() || !isPlain);
}

} // namespace

Result insertReference(const Manuscript& manuscript, Selection selection, NodeId target) {
    const sgml::Tree& tree = manuscript.document.tree();
    const std::size_t end = std::max(selection.anchor, selection.caret);
    Draft draft(manuscript, {end, end});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    const std::string name(draft.grammar().named(Display::reference));
    if (name.empty())
        return refused(QStringLiteral("This class of documents has no references."));
    if (!tree.holds(target) || !tree.isElement(target) || !draft.isInside(target))
        return refused(QStringLiteral("The target of the reference is not in this document."));
    std::string id(tree.attribute(target, "ID").value_or(""));
    if (id.empty()) {
        id = freeId(tree, tree.name(target));
        draft.opened(target).attributes += spelledAttribute("ID", id);
    }
    if (putInLine(draft, draft.first(), Draft::made(name, spelledAttribute("TO", id))) == nullptr)
        return refused(mayNotStand(draft.grammar(), name));
    draft.collapse();
    return draft.result(QStringLiteral("Reference"));
}

std::vector<NodeId> targets(const Manuscript& manuscript) {
    const sgml::Tree& tree = manuscript.document.tree();
    std::vector<NodeId> found;
    const Grammar* grammar = manuscript.grammars.of(tree.name(tree.root()));
    if (grammar == nullptr)
        return found;
    for (NodeId id = tree.following(tree.root()); id != noNode;) {
        const bool isElement = tree.isElement(id);
        if (isElement && (isNumbered(tree, *grammar, id) ||
                          (tree.attribute(id, "ID") && tree.name(id) != "DOCUMENT")))
            found.push_back(id);
        id = isElement && tree.name(id) == "DOCUMENT" ? tree.followingSkippingChildren(id)
                                                      : tree.following(id);
    }
    return found;
}

// --- pasted text ----------------------------------------------------------------------------

namespace {

// Paragraphs are apart by blank lines.
std::vector<std::string> paragraphsOf(std::string_view text) {
    std::vector<std::string> paragraphs{""};
    const std::string lines = withLineEnds(text, true);
    bool wasBlank = false;
    for (std::size_t at = 0; at <= lines.size();) {
        const std::size_t end = std::min(lines.find('\n', at), lines.size());
        const std::string_view line = std::string_view(lines).substr(at, end - at);
        const bool isBlank = line.find_first_not_of(" \t") == std::string_view::npos;
        if (isBlank && at > 0 && end < lines.size()) {
            wasBlank = true;
        } else {
            if (wasBlank && !paragraphs.back().empty())
                paragraphs.emplace_back();
            else if (!paragraphs.back().empty() && !line.empty())
                paragraphs.back() += ' ';
            paragraphs.back() += line;
            wasBlank = false;
        }
        at = end + 1;
    }
    return paragraphs;
}

void putText(Draft& draft, std::string_view text) {
    draft.settle(draft.first());
    if (!text.empty())
        Draft::put(*draft.first().parent, draft.first().index(), Draft::madeText(text));
}

} // namespace

Result pasteText(const Manuscript& manuscript, Selection selection, std::string_view text) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    if (!makeLine(draft, draft.first()))
        return refused(QStringLiteral("Text may not stand here."));
    draft.collapse();
    const bool isVerbatim = draft.of(draft.blockOf(draft.first())).display == Display::verbatim;
    if (isVerbatim) {
        putText(draft, withLineEnds(text, true));
        return draft.result(QStringLiteral("Paste"));
    }
    bool isFirst = true;
    for (const std::string& paragraph : paragraphsOf(text)) {
        // A line that is one only takes all of it.
        if (!isFirst && !breakLine(draft).isEmpty())
            putText(draft, " ");
        draft.collapse();
        putText(draft, paragraph);
        isFirst = false;
    }
    return draft.result(QStringLiteral("Paste"));
}

// --- pasted structure -----------------------------------------------------------------------

namespace {

// Elements of another tree as new pieces.
class Paster {
public:
    Paster(Draft& draft, const sgml::Tree& from) : draft_(draft), from_(from) {}

    // The line of a paragraph, which goes into the line at the mark, or blocks.
    QString paste(NodeId top) {
        Pieces pieces = below(top);
        while (pieces.size() == 1 && isWrapper(*pieces.front()))
            pieces = std::move(pieces.front()->children);
        if (pieces.empty())
            return {};
        if (std::all_of(pieces.begin(), pieces.end(),
                        [this](const auto& piece) { return isOfLine(*piece); }))
            return pasteLine(std::move(pieces));
        return pasteBlocks(std::move(pieces));
    }

private:
    // An element that only stands for where the copied lines were: a line, or what holds blocks
    // and may not stand here itself.
    bool isWrapper(const Piece& piece) {
        if (!piece.isElement() || !piece.raw.empty() || piece.children.empty() ||
            draft_.isInlined(piece))
            return false;
        const ContainerRole role = draft_.of(piece).role;
        if (role == ContainerRole::list || role == ContainerRole::table ||
            role == ContainerRole::figure || role == ContainerRole::section ||
            draft_.of(piece).display == Display::verbatim)
            return false;
        return draft_.of(piece).kind == Kind::block;
    }
    [[nodiscard]] bool isOfLine(const Piece& piece) const {
        return draft_.isInlined(piece) ||
               (piece.isElement() && draft_.of(piece).kind == Kind::unit &&
                piece.name != "DOCUMENT");
    }

    Pieces below(NodeId element) {
        Pieces pieces;
        for (NodeId id = from_.node(element).firstChild; id != noNode; id = from_.node(id).next) {
            if (from_.node(id).kind == sgml::NodeKind::content) {
                pieces.push_back(Draft::madeText(from_.unescaped(id).text()));
            } else if (from_.isElement(id)) {
                // What the class does not know leaves its content.
                if (!draft_.grammar().knows(from_.name(id))) {
                    for (std::unique_ptr<Piece>& piece : below(id))
                        pieces.push_back(std::move(piece));
                } else {
                    pieces.push_back(one(id));
                }
            }
        }
        return pieces;
    }

    std::unique_ptr<Piece> one(NodeId id) {
        std::string attributes;
        for (const sgml::Attribute& attribute : from_.attributes(id))
            if (draft_.grammar().hasAttribute(from_.name(id), from_.text(attribute.name)))
                attributes += " " + std::string(from_.text(attribute.whole));
        std::unique_ptr<Piece> piece = Draft::made(std::string(from_.name(id)), attributes);
        if (piece->name == "DOCUMENT") {
            piece->raw = from_.text(from_.node(id).range);
            return piece;
        }
        for (std::unique_ptr<Piece>& child : below(id))
            Draft::put(*piece, piece->children.size(), std::move(child));
        return piece;
    }

    QString pasteLine(Pieces pieces) {
        for (std::unique_ptr<Piece>& piece : pieces) {
            if (piece->isText()) {
                draft_.settle(draft_.first());
                Draft::put(*draft_.first().parent, draft_.first().index(), std::move(piece));
                continue;
            }
            if (draft_.isPlainText(*piece) && piece->children.size() == 1 &&
                piece->children.front()->isText()) {
                draft_.settle(draft_.first());
                Draft::put(*draft_.first().parent, draft_.first().index(),
                           Draft::take(*piece->children.front()));
                continue;
            }
            const std::string name = piece->name;
            if (putInLine(draft_, draft_.first(), std::move(piece)) == nullptr)
                return mayNotStand(draft_.grammar(), name);
        }
        return {};
    }

    QString pasteBlocks(Pieces pieces) {
        const std::string paragraph(draft_.grammar().named(ContainerRole::paragraph));
        Piece* before = nullptr;
        for (std::unique_ptr<Piece>& piece : pieces) {
            if (isOfLine(*piece)) {
                std::unique_ptr<Piece> line = Draft::made(paragraph);
                Draft::put(*line, 0, std::move(piece));
                piece = std::move(line);
            }
            const std::string name = piece->name;
            if (before == nullptr)
                before = putBlock(draft_, draft_.first(), std::move(piece));
            else if (allows(draft_, *before->parent, before->index() + 1, name))
                before = &behind(*before, std::move(piece));
            else
                return mayNotStand(draft_.grammar(), name);
            if (before == nullptr)
                return mayNotStand(draft_.grammar(), name);
        }
        Draft::moveTo(draft_.first(), *before->parent, before->index() + 1);
        return {};
    }
    Piece& behind(Piece& before, std::unique_ptr<Piece> piece) {
        Piece& made = Draft::put(*before.parent, before.index() + 1, std::move(piece));
        draft_.putOnLine(made, before);
        return made;
    }

    Draft& draft_;
    const sgml::Tree& from_;
};

// Without the IDs that the document has, or that come twice.
std::string withFreeIds(const sgml::Tree& document, std::string bytes) {
    std::set<std::string, std::less<>> taken = idsOf(document);
    const sgml::Tree tree = sgml::Tree::parse(bytes);
    text::Edits edits;
    for (NodeId id = tree.root(); id != noNode; id = tree.following(id)) {
        const auto name = tree.isElement(id) ? tree.attribute(id, "ID") : std::nullopt;
        if (!name || taken.emplace(*name).second)
            continue;
        const text::Edits removal = sgml::attributeRemoval(tree, id, "ID");
        edits.insert(edits.end(), removal.begin(), removal.end());
    }
    return text::applied(bytes, edits);
}

} // namespace

Result paste(const Manuscript& manuscript, Selection selection, std::string_view fragment) {
    const std::string whole = "DOCUMENT PASTED\n<PASTED>" + std::string(fragment) + "</PASTED>";
    const sgml::Tree tree = sgml::Tree::parse(withFreeIds(manuscript.document.tree(), whole));
    if (tree.isBroken())
        return refused(QStringLiteral("The clipboard holds nothing that can be read."));
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    makeCaret(draft, selection);
    if (!makeLine(draft, draft.first()))
        return refused(QStringLiteral("Text may not stand here."));
    draft.collapse();
    if (const QString why = Paster(draft, tree).paste(tree.classElement(tree.root()));
        !why.isEmpty())
        return refused(why);
    draft.collapse();
    return draft.result(QStringLiteral("Paste"));
}

// --- moving ---------------------------------------------------------------------------------

Result moveElement(const Manuscript& manuscript, NodeId element, NodeId beside, Direction side) {
    const sgml::Tree& tree = manuscript.document.tree();
    if (!tree.holds(element) || !tree.holds(beside) || !tree.isElement(element) ||
        !tree.isElement(beside))
        return refused(QStringLiteral("What was to be moved is not there any more."));
    for (NodeId id = beside; id != noNode; id = tree.node(id).parent)
        if (id == element)
            return refused(QStringLiteral("An element cannot be moved into itself."));
    const std::size_t at = tree.node(element).startTag.to;
    const std::size_t place = authoring::place(manuscript, at, Direction::forward).value_or(at);
    Draft draft(manuscript, {place, place});
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    if (!draft.isInside(element) || !draft.isInside(beside))
        return refused(QStringLiteral("What was to be moved is in another document."));
    Piece& moved = draft.opened(element);
    Piece& other = draft.opened(beside);
    moved.isCopied = true;
    Draft::moveTo(moved, *other.parent, other.index() + (side == Direction::forward ? 1 : 0));
    return draft.result(QStringLiteral("Move"));
}

// --- what is allowed ------------------------------------------------------------------------

std::vector<std::string> allowedAt(const Manuscript& manuscript, std::size_t place) {
    Draft draft(manuscript, {place, place});
    if (!draft.obstacle().isEmpty())
        return {};
    std::vector<std::string> names;
    for (Piece* at = &draft.first(); at->parent != nullptr; at = at->parent)
        for (const std::string& name : allowedAt(draft, *at->parent, at->index() + 1))
            if (name != "TEXT" && std::find(names.begin(), names.end(), name) == names.end())
                names.push_back(name);
    return names;
}

} // namespace authoring
