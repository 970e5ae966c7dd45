// Sections and their headings, lists and their items.
#include "authoring/commands.h"

#include "sgml/edit.h"

#include <algorithm>
#include <set>

namespace authoring {

using schemas::ContainerRole;
using schemas::Display;

namespace {

class Restructurer {
public:
    explicit Restructurer(Draft& draft) : draft_(draft), grammar_(draft.grammar()) {}

    // The elements whose lines are between the marks, in order.
    std::vector<Piece*> lines() {
        std::vector<Piece*> found;
        collect(draft_.root(), found);
        // A mark between two blocks of a section names the section: its lines stand for it.
        std::set<const Piece*> around;
        for (const Piece* line : found)
            for (const Piece* at = line->parent; at != nullptr; at = at->parent)
                if (!around.insert(at).second)
                    break;
        std::erase_if(found, [&](const Piece* line) { return around.contains(line); });
        return found;
    }

    // --- headings

    QString makeHeading(Piece& line, int level) {
        const std::string heading = named(ContainerRole::heading);
        const std::string section = named(ContainerRole::section);
        if (heading.empty())
            return QStringLiteral("This class of documents has no headings.");
        if (draft_.of(line).role == ContainerRole::heading)
            return changeLevel(line, level);
        if (draft_.of(line).role != ContainerRole::paragraph)
            return QStringLiteral("Only a paragraph becomes a heading.");
        if (section.empty()) {
            rename(line, heading);
            return {};
        }
        const int depth = depthOf(line);
        if (level > depth + 1)
            return tooDeep();
        Piece* stop = line.parent;
        for (int d = depth; d >= level; stop = stop->parent)
            d -= draft_.of(*stop).role == ContainerRole::section ? 1 : 0;
        if (depth < level) {
            wrapInSection(line, section);
        } else {
            Piece& right = draft_.split(line, *stop);
            flatten(line, right);
        }
        rename(line, heading);
        return {};
    }

    // The heading's section is dissolved; what it holds goes on in the section before it.
    QString makeParagraph(Piece& line) {
        const std::string paragraph = named(ContainerRole::paragraph);
        const ContainerRole role = draft_.of(line).role;
        if (paragraph.empty())
            return QStringLiteral("This class of documents has no paragraphs.");
        if (role == ContainerRole::paragraph)
            return {};
        if (draft_.of(line).display == Display::verbatim) {
            rename(line, paragraph);
            return {};
        }
        if (role != ContainerRole::heading)
            return QStringLiteral("This line cannot become a paragraph.");
        rename(line, paragraph);
        Piece* section = line.parent;
        if (section == nullptr || draft_.of(*section).role != ContainerRole::section)
            return {};
        draft_.openBeside(*section);
        Piece* before = section->previous();
        if (before == nullptr || !before->isElement() ||
            draft_.of(*before).role != ContainerRole::section) {
            Draft::dissolve(*section);
            return {};
        }
        appendChildren(*section, *before);
        Draft::take(*section);
        return {};
    }

    QString makeVerbatim(const std::vector<Piece*>& lines) {
        const std::string name(grammar_.named(Display::verbatim));
        if (name.empty())
            return QStringLiteral("This class of documents has no preformatted text.");
        for (Piece* line : lines) {
            if (draft_.of(*line).role != ContainerRole::paragraph)
                return QStringLiteral("Only paragraphs become preformatted text.");
            draft_.openChildren(*line);
            for (std::size_t i = 0; i < line->children.size();)
                if (Piece& child = *line->children[i]; child.isElement()) {
                    if (!draft_.isInlined(child))
                        return QStringLiteral("Preformatted text holds nothing but text.");
                    draft_.openChildren(child);
                    Draft::dissolve(child);
                } else {
                    ++i;
                }
        }
        Piece& first = *lines.front();
        rename(first, name);
        for (std::size_t i = 1; i < lines.size(); ++i) {
            if (first.next() != lines[i])
                return QStringLiteral("These paragraphs do not follow each other.");
            Draft::put(first, first.children.size(), Draft::madeText("\n"));
            appendChildren(*lines[i], first);
            Draft::take(*lines[i]);
        }
        return {};
    }

    // --- lists

    QString makeItems(const std::vector<Piece*>& lines, const std::string& attributes) {
        const std::string list = named(ContainerRole::list), item = named(ContainerRole::item);
        if (list.empty() || item.empty())
            return QStringLiteral("This class of documents has no lists.");
        for (const Piece* line : lines)
            if (draft_.of(*line).role != ContainerRole::paragraph)
                return QStringLiteral("Only paragraphs become items of a list.");
        Piece* made = nullptr;
        for (Piece* line : lines) {
            if (made == nullptr || line->previous() != made) {
                made = &Draft::put(*line->parent, line->index(), Draft::made(list, attributes));
                std::swap(made->gap, line->gap);
                made->tail.fresh = "\n";
            }
            Draft::moveTo(*line, *made, made->children.size());
            draft_.putOnLine(*line, *made);
            rename(*line, item);
        }
        return {};
    }

    // Out of the innermost list: an item of the list around it, or paragraphs.
    QString lift(Piece& item) {
        Piece& list = *item.parent;
        if (list.parent == nullptr || draft_.of(list).role != ContainerRole::list)
            return QStringLiteral("This item is in no list.");
        Piece* outer = draft_.of(*list.parent).role == ContainerRole::item ? list.parent : nullptr;
        Piece& stop = outer == nullptr ? *list.parent : *outer->parent;
        draft_.openBeside(item);
        const bool hadItems = hasElement(list, item);
        Piece& behind = draft_.split(item, stop);
        Draft::moveTo(item, stop, behind.index());
        draft_.putOnLine(item, behind);
        if (outer != nullptr) {
            // The half of the list behind the item begins what is behind.
            Piece& half = *behind.children.front();
            if (half.isElement() && !hasElement(half, item))
                Draft::take(half);
            appendChildren(behind, item);
            Draft::take(behind);
        } else if (!hasElement(behind, item)) {
            Draft::take(behind);
        }
        if (!hadItems || !hasElement(list, item))
            Draft::take(list);
        return outer == nullptr ? unfold(item) : QString{};
    }

    // Into a list at the end of the item before it.
    QString nest(Piece& item) {
        Piece& list = *item.parent;
        draft_.openBeside(item);
        Piece* before = item.previous();
        while (before != nullptr && !before->isElement())
            before = before->previous();
        if (before == nullptr)
            return QStringLiteral("The first item of a list cannot go into the one before it.");
        draft_.openChildren(*before);
        Piece* inner = before->children.empty() ? nullptr : before->children.back().get();
        if (inner == nullptr || !inner->isElement() ||
            draft_.of(*inner).role != ContainerRole::list)
            inner = &Draft::put(*before, before->children.size(),
                                Draft::made(list.name, draft_.attributesWithoutId(list)));
        Draft::moveTo(item, *inner, inner->children.size());
        return {};
    }

    void rename(Piece& element, const std::string& name) {
        element.name = name;
        element.end = sgml::noNode;
    }

private:
    void collect(Piece& piece, std::vector<Piece*>& found) {
        if (piece.isMark()) {
            ++marks_;
            Piece& block = draft_.blockOf(piece);
            if (found.empty() || found.back() != &block)
                found.push_back(&block);
            return;
        }
        const bool isLine = piece.isElement() && draft_.holdsText(piece) &&
                            !draft_.isInlined(piece) && !draft_.isUnit(piece);
        if (marks_ == 1 && isLine && hasLine(piece))
            found.push_back(&piece);
        for (std::size_t i = 0; i < piece.children.size() && marks_ < 2; ++i) {
            if (marks_ == 1 && piece.children[i]->kind == Piece::Kind::rest)
                draft_.openRestAll(*piece.children[i]);
            collect(*piece.children[i], found);
        }
    }
    bool hasLine(Piece& piece) {
        draft_.openChildren(piece);
        return piece.children.empty() || draft_.isInLine(*piece.children.front());
    }

    [[nodiscard]] std::string named(ContainerRole role) const {
        return std::string(grammar_.named(role));
    }
    static QString tooDeep() {
        return QStringLiteral("A heading of this level needs one of the level above before it.");
    }

    [[nodiscard]] int depthOf(const Piece& piece) const {
        int depth = 0;
        for (const Piece* at = piece.parent; at != nullptr; at = at->parent)
            depth += draft_.of(*at).role == ContainerRole::section ? 1 : 0;
        return depth;
    }

    Piece* nextOpened(Piece& piece) {
        draft_.openBeside(piece);
        return piece.next();
    }

    // The paragraph and what follows it up to the next section.
    void wrapInSection(Piece& line, const std::string& name) {
        Piece& parent = *line.parent;
        Piece& section = Draft::put(parent, line.index(), Draft::made(name));
        std::swap(section.gap, line.gap);
        line.gap.fresh = "\n";
        section.tail.fresh = "\n";
        while (Piece* next = nextOpened(section)) {
            if (next->isElement() && draft_.of(*next).role == ContainerRole::section)
                break;
            Draft::moveTo(*next, section, section.children.size());
        }
    }

    // The line is the first in elements in elements; it becomes the first child of `section`.
    static void flatten(Piece& line, Piece& section) {
        while (line.parent != &section && &line != &section)
            Draft::dissolve(*line.parent);
    }

    QString changeLevel(Piece& heading, int level) {
        if (heading.parent == nullptr || draft_.of(*heading.parent).role != ContainerRole::section)
            return QStringLiteral("This heading has no section.");
        Piece& section = *heading.parent;
        for (int depth = depthOf(heading); depth != level; depth = depthOf(heading))
            if (QString why = depth > level ? raise(section) : lower(section); !why.isEmpty())
                return why;
        return {};
    }

    // The text that follows it in the section around it becomes its own.
    QString raise(Piece& section) {
        Piece& around = *section.parent;
        if (around.parent == nullptr || draft_.of(around).role != ContainerRole::section)
            return QStringLiteral("This heading stands as high as it can.");
        Piece& right = draft_.split(section, *around.parent);
        Draft::moveTo(section, *right.parent, right.index());
        std::swap(section.gap, right.gap);
        appendChildren(right, section);
        Draft::take(right);
        return {};
    }

    QString lower(Piece& section) {
        draft_.openBeside(section);
        Piece* before = section.previous();
        if (before == nullptr || !before->isElement() ||
            draft_.of(*before).role != ContainerRole::section)
            return tooDeep();
        Draft::moveTo(section, *before, before->children.size());
        return {};
    }

    void appendChildren(Piece& from, Piece& to) {
        while (!from.children.empty())
            Draft::moveTo(*from.children.front(), to, to.children.size());
    }

    // Is there an element in the list besides the item?
    static bool hasElement(const Piece& list, const Piece& item) {
        return std::any_of(list.children.begin(), list.children.end(), [&](const auto& piece) {
            return piece.get() != &item && (piece->isElement() || piece->kind == Piece::Kind::rest);
        });
    }

    // The item's line becomes a paragraph, its blocks stand beside it.
    QString unfold(Piece& item) {
        const std::string paragraph = named(ContainerRole::paragraph);
        draft_.openChildren(item);
        Piece* made = nullptr;
        for (std::size_t i = 0; i < item.children.size(); ++i) {
            Piece& child = *item.children[i];
            if (!draft_.isInLine(child)) {
                draft_.putOnLine(child, item);
                made = nullptr;
                continue;
            }
            if (made == nullptr) {
                made = &Draft::put(item, i, Draft::made(paragraph));
                draft_.putOnLine(*made, item);
            }
            Draft::moveTo(child, *made, made->children.size());
            i = made->index();
        }
        if (item.children.empty())
            Draft::put(item, 0, Draft::made(paragraph));
        item.children.front()->gap = item.gap;
        Draft::dissolve(item);
        return {};
    }

    Draft& draft_;
    const Grammar& grammar_;
    std::size_t marks_ = 0; // passed
};

// The lines of the selection, each given to the change, in one step.
Result
changeLines(const Manuscript& manuscript, Selection selection, const QString& label,
            const std::function<QString(Restructurer&, const std::vector<Piece*>&)>& change) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    Restructurer restructurer(draft);
    const std::vector<Piece*> lines = restructurer.lines();
    if (const QString why = change(restructurer, lines); !why.isEmpty())
        return refused(why);
    return draft.result(label);
}

// The items that the lines are in, each once, without those inside of others.
std::vector<Piece*> itemsOf(const Draft& draft, const std::vector<Piece*>& lines) {
    std::vector<Piece*> items;
    for (Piece* line : lines) {
        Piece* item = line;
        while (item != nullptr && draft.of(*item).role != ContainerRole::item)
            item = item->parent;
        const auto isAround = [&](const Piece* one) {
            for (const Piece* at = item; at != nullptr; at = at->parent)
                if (at == one)
                    return true;
            return false;
        };
        if (item != nullptr && std::none_of(items.begin(), items.end(), isAround))
            items.push_back(item);
    }
    return items;
}

Result changeItems(const Manuscript& manuscript, Selection selection, const QString& label,
                   QString (Restructurer::*change)(Piece&)) {
    Draft draft(manuscript, selection);
    if (const QString why = draft.obstacle(); !why.isEmpty())
        return refused(why);
    Restructurer restructurer(draft);
    const std::vector<Piece*> items = itemsOf(draft, restructurer.lines());
    if (items.empty())
        return refused(QStringLiteral("The selection is in no list."));
    for (Piece* item : items)
        if (const QString why = (restructurer.*change)(*item); !why.isEmpty())
            return refused(why);
    return draft.result(label);
}

} // namespace

Result makeHeading(const Manuscript& manuscript, Selection selection, int level) {
    return changeLines(manuscript, selection, QStringLiteral("Heading"),
                       [level](Restructurer& by, const std::vector<Piece*>& lines) {
                           for (Piece* line : lines)
                               if (QString why = by.makeHeading(*line, level); !why.isEmpty())
                                   return why;
                           return QString{};
                       });
}

Result makeParagraph(const Manuscript& manuscript, Selection selection) {
    return changeLines(manuscript, selection, QStringLiteral("Paragraph"),
                       [](Restructurer& by, const std::vector<Piece*>& lines) {
                           for (Piece* line : lines)
                               if (QString why = by.makeParagraph(*line); !why.isEmpty())
                                   return why;
                           return QString{};
                       });
}

Result makeVerbatim(const Manuscript& manuscript, Selection selection) {
    return changeLines(
        manuscript, selection, QStringLiteral("Preformatted Text"),
        [](Restructurer& by, const std::vector<Piece*>& lines) { return by.makeVerbatim(lines); });
}

Result makeList(const Manuscript& manuscript, Selection selection, std::string_view attribute,
                std::string_view value) {
    const std::string attributes =
        attribute.empty() ? std::string{} : " " + sgml::attributeText(attribute, value);
    return changeLines(manuscript, selection, QStringLiteral("List"),
                       [&](Restructurer& by, const std::vector<Piece*>& lines) {
                           return by.makeItems(lines, attributes);
                       });
}

Result indentItems(const Manuscript& manuscript, Selection selection) {
    return changeItems(manuscript, selection, QStringLiteral("Indent"), &Restructurer::nest);
}

Result outdentItems(const Manuscript& manuscript, Selection selection) {
    return changeItems(manuscript, selection, QStringLiteral("Outdent"), &Restructurer::lift);
}

} // namespace authoring
