// Pasted text: plain, and with its structure.
#include "authoring/commands.h"
#include "authoring/ids.h"
#include "manuscript/leaves.h"

#include "sgml/edit.h"

#include <algorithm>

namespace authoring {

using schemas::ContainerRole;
using schemas::Display;
using sgml::NodeId;
using sgml::noNode;

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

// Puts the caret in a line of text in the place of the selection; or says why it cannot.
QString prepare(Draft& draft, Selection selection) {
    if (QString why = draft.obstacle(); !why.isEmpty())
        return why;
    makeCaret(draft, selection);
    if (!makeLine(draft, draft.first()))
        return QStringLiteral("Text may not stand here.");
    draft.collapse();
    return {};
}

void putText(Draft& draft, std::string_view text) {
    draft.settle(draft.first());
    if (!text.empty())
        Draft::put(*draft.first().parent, draft.first().index(), Draft::madeText(text));
}

} // namespace

Result pasteText(const Manuscript& manuscript, Selection selection, std::string_view text) {
    Draft draft(manuscript, selection);
    if (const QString why = prepare(draft, selection); !why.isEmpty())
        return refused(why);
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
                // An element that the class does not know leaves its content.
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
        putOnLines(*piece);
        return piece;
    }
    // Blocks in a block stand on lines of their own, as what is written does.
    void putOnLines(Piece& piece) const {
        if (draft_.isInlined(piece) || draft_.holdsText(piece))
            return;
        bool holdsBlocks = false;
        for (const std::unique_ptr<Piece>& child : piece.children)
            if (child->isElement() && !isOfLine(*child) && !isCell(*child)) {
                child->gap.fresh = "\n";
                holdsBlocks = true;
            }
        if (holdsBlocks)
            piece.tail.fresh = "\n";
    }
    // The cells of a row stand beside each other.
    [[nodiscard]] bool isCell(const Piece& piece) const {
        return draft_.of(piece).display == Display::cell;
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
        for (std::unique_ptr<Piece>& piece : pieces)
            if (QString why = pasteBlock(std::move(piece)); !why.isEmpty())
                return why;
        Draft::moveTo(draft_.first(), *last_->parent, last_->index() + 1);
        if (draft_.holdsText(*last_->parent))
            leaveNoEmptyLines(*last_->parent);
        return {};
    }
    // A cell holds text and blocks side by side: a text without letters would be an empty line
    // there.
    void leaveNoEmptyLines(Piece& holder) {
        Piece* line = draft_.isLineBlank(draft_.first(), Direction::forward) ? lastLine() : nullptr;
        if (line != nullptr)
            Draft::moveTo(draft_.first(), *line, line->children.size());
        draft_.collapse();
        const auto isEmpty = [](const auto& piece) { return piece->isEmptyText(); };
        for (std::size_t i = holder.children.size(); i-- > 0;) {
            Piece& child = *holder.children[i];
            if (child.isEmptyText() ||
                (draft_.isPlainText(child) && std::ranges::all_of(child.children, isEmpty)))
                Draft::take(child);
        }
    }
    // The last line of the pasted pieces; null: they end with a block.
    Piece* lastLine() const {
        Piece* line = last_;
        while (line != nullptr && !draft_.holdsText(*line)) {
            Piece* inside = line->children.empty() ? nullptr : line->children.back().get();
            line = inside != nullptr && inside->isElement() ? inside : nullptr;
        }
        return line;
    }
    // The copy may begin within an element, whose beginning is not in it then: a section without
    // its heading. Such an element leaves its content in its place, and so does one that may not
    // stand here; a line that may not stand here becomes a paragraph.
    QString pasteBlock(std::unique_ptr<Piece> piece) {
        if (isOfLine(*piece)) {
            std::unique_ptr<Piece> line = paragraph();
            Draft::put(*line, 0, std::move(piece));
            piece = std::move(line);
        }
        const bool isLine = draft_.holdsText(*piece);
        const bool isWhole = !piece->raw.empty() || isLine || draft_.faultOf(*piece).isEmpty();
        if (isWhole && putNext(piece))
            return {};
        const std::string name = piece->name;
        if (isLine && draft_.of(*piece).role != ContainerRole::paragraph) {
            std::unique_ptr<Piece> line = paragraph();
            line->children = std::move(piece->children);
            for (std::unique_ptr<Piece>& child : line->children)
                child->parent = line.get();
            if (putNext(line))
                return {};
        }
        if (isLine || piece->children.empty())
            return mayNotStand(draft_.grammar(), name);
        for (std::unique_ptr<Piece>& child : piece->children)
            if (QString why = pasteBlock(std::move(child)); !why.isEmpty())
                return why;
        return {};
    }
    // False: it may not stand here, and is as it was.
    bool putNext(std::unique_ptr<Piece>& piece) {
        if (last_ == nullptr)
            last_ = putBlock(draft_, draft_.first(), std::move(piece));
        else if (allows(draft_, *last_->parent, last_->index() + 1, piece->name))
            last_ = &behind(*last_, std::move(piece));
        else
            return false;
        return last_ != nullptr;
    }
    std::unique_ptr<Piece> paragraph() const {
        return Draft::made(std::string(draft_.grammar().named(ContainerRole::paragraph)));
    }
    Piece& behind(Piece& before, std::unique_ptr<Piece> piece) {
        Piece& made = Draft::put(*before.parent, before.index() + 1, std::move(piece));
        draft_.putOnLine(made, before);
        return made;
    }

    Draft& draft_;
    const sgml::Tree& from_;
    Piece* last_ = nullptr; // the block that came in last
};

} // namespace

Result paste(const Manuscript& manuscript, Selection selection, std::string_view fragment) {
    const std::string whole = "DOCUMENT PASTED\n<PASTED>" + std::string(fragment) + "</PASTED>";
    const sgml::Tree tree = sgml::Tree::parse(withFreeIds(manuscript.document.tree(), whole));
    if (tree.isBroken())
        return refused(QStringLiteral("The clipboard holds nothing that can be read."));
    Draft draft(manuscript, selection);
    if (const QString why = prepare(draft, selection); !why.isEmpty())
        return refused(why);
    if (const QString why = Paster(draft, tree).paste(tree.classElement(tree.root()));
        !why.isEmpty())
        return refused(why);
    draft.collapse();
    return draft.result(QStringLiteral("Paste"));
}

} // namespace authoring
