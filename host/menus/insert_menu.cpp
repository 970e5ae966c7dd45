#include "menus/insert_menu.h"

#include "menus/formula_dialog.h"
#include "menus/link_dialog.h"
#include "menus/medium_menu.h"
#include "menus/reference_dialog.h"
#include "sgml/edit.h"
#include "view/document_view.h"

namespace menus {

using authoring::Manuscript, authoring::Selection;
using schemas::Display;
using Place = FormulaDialog::Place;

namespace {

// A formula's kind as it is spelled in a tag; "" in a line. The presentation of a class tells those
// that stand alone apart by an attribute.
std::string kindOf(const Manuscript& in, Place place) {
    const authoring::Grammar* grammar = in.grammars.of(in.document.className());
    if (grammar != nullptr && place != Place::inLine)
        for (const auto& kind : grammar->variants(grammar->named(Display::formula)))
            if (kind.isNumbered == (place == Place::numbered))
                return " " + sgml::attributeText(kind.attribute, kind.value);
    return {};
}

Place placeOf(const Manuscript& in, sgml::NodeId formula) {
    const sgml::Tree& tree = in.document.tree();
    const authoring::Grammar* grammar = in.grammars.of(in.document.className());
    if (grammar != nullptr)
        for (const auto& kind : grammar->variants(tree.name(formula)))
            if (tree.attribute(formula, kind.attribute) == kind.value)
                return kind.isNumbered ? Place::numbered : Place::alone;
    return Place::inLine;
}

// Of an element that presentations show as this, such as a page break.
CommandMenu::Command block(Display display) {
    return [display](const Manuscript& in, Selection at) -> authoring::Result {
        const authoring::Grammar* grammar = in.grammars.of(in.document.className());
        const std::string name(grammar ? grammar->named(display) : std::string_view());
        if (name.empty())
            return authoring::Refusal{
                InsertMenu::tr("This class of documents has no such element.")};
        return authoring::insertBlock(in, at, name);
    };
}

// Contents of that kind. The presentation of a class tells the kinds apart by an attribute.
CommandMenu::Command contents(schemas::ContainerRole of) {
    return [of](const Manuscript& in, Selection at) -> authoring::Result {
        const authoring::Grammar* grammar = in.grammars.of(in.document.className());
        const std::string name(grammar ? grammar->named(Display::contents) : std::string_view());
        if (!name.empty() && of == schemas::ContainerRole::heading)
            return authoring::insertBlock(in, at, name);
        if (!name.empty())
            for (const auto& kind : grammar->variants(name))
                if (kind.lists == of)
                    return authoring::insertBlock(
                        in, at, name, " " + sgml::attributeText(kind.attribute, kind.value));
        return authoring::Refusal{InsertMenu::tr("This class of documents has no such element.")};
    };
}

} // namespace

InsertMenu::InsertMenu(view::DocumentView& view, QWidget* parent)
    : CommandMenu(tr("&Insert"), view, parent) {
    setObjectName("insert");
    addAsking(
        "link", tr("&Link..."), QKeySequence("Ctrl+K"),
        [](const Manuscript& in, Selection at) { return authoring::link(in, at, "#"); },
        [this] { askForLink(); });
    addAsking(
        "reference", tr("Cross-&Reference..."), QKeySequence("Ctrl+Shift+R"),
        [](const Manuscript& in, Selection at) -> authoring::Result {
            const std::vector<sgml::NodeId> all = authoring::targets(in);
            if (all.empty())
                return authoring::Refusal{
                    tr("There is nothing to refer to: no heading, figure, table or formula "
                       "with a number.")};
            return authoring::insertReference(in, at, all.front());
        },
        [this] { askForReference(); });
    add("footnote", tr("&Footnote"), QKeySequence("Ctrl+Alt+F"), authoring::insertFootnote);
    addSeparator();
    addAsking(
        "formula", tr("For&mula..."), QKeySequence("Ctrl+Shift+F"),
        [](const Manuscript& in, Selection at) { return authoring::insertFormula(in, at, "x"); },
        [this] { askForFormula(selectedFormula()); });
    for (const media::Manifest& manifest : view.document().media().registry().media()) {
        QMenu* ofMedium = new MediumMenu(manifest, view, parent);
        addMenu(ofMedium);
    }
    add("caption", tr("&Caption"), QKeySequence("Ctrl+Alt+C"), authoring::insertCaption);
    addSeparator();
    add("pageBreak", tr("&Page Break"), QKeySequence("Ctrl+Return"), block(Display::pageBreak));
    add("rule", tr("R&ule"), {}, block(Display::rule));
    addSeparator();
    using schemas::ContainerRole;
    add("contents", tr("&Table of Contents"), {}, contents(ContainerRole::heading));
    add("listOfFigures", tr("List of Fi&gures"), {}, contents(ContainerRole::figure));
    add("listOfTables", tr("List of Ta&bles"), {}, contents(ContainerRole::table));
    connect(&this->view(), &view::DocumentView::formulaActivated, this,
            [this](sgml::NodeId element) { askForFormula(element); });
}

// A link that one is in is changed as a whole.
void InsertMenu::askForLink() {
    const auto around = [](const Manuscript& in, Selection at) {
        return authoring::linkAround(in, at);
    };
    const auto old = around(view().writing().manuscript(), *view().writing().selection());
    const std::optional<QString> wanted =
        menus::askForLink(old ? QString::fromStdString(old->target) : QString(), parentWidget());
    if (!wanted)
        return;
    perform([&](const Manuscript& in, Selection at) {
        const auto link = around(in, at); // the document may have changed since
        return authoring::link(in, link ? link->text : at, wanted->toStdString());
    });
}

void InsertMenu::askForReference() {
    view().settle();
    if (!view().model())
        return;
    ReferenceDialog dialog(
        described(authoring::targets(view().writing().manuscript()), *view().model()),
        parentWidget());
    if (dialog.exec() != QDialog::Accepted || dialog.chosen() == sgml::noNode)
        return;
    perform([&](const Manuscript& in, Selection at) {
        return authoring::insertReference(in, at, dialog.chosen());
    });
}

// A formula that is selected alone is changed.
sgml::NodeId InsertMenu::selectedFormula() const {
    const Manuscript in = view().writing().manuscript();
    const Selection at = *view().writing().selection();
    const sgml::Tree& tree = in.document.tree();
    const authoring::Grammar* grammar = in.grammars.of(in.document.className());
    const std::size_t first = std::min(at.anchor, at.caret), last = std::max(at.anchor, at.caret);
    const sgml::NodeId node = tree.innermostAt(first);
    const bool isFormula = grammar != nullptr && node != sgml::noNode && tree.isElement(node) &&
                           grammar->of(tree.name(node)).display == Display::formula;
    return isFormula && tree.node(node).range == text::Range{first, last} ? node : sgml::noNode;
}

void InsertMenu::askForFormula(sgml::NodeId element) {
    QString source;
    Place place = Place::inLine;
    const Manuscript now = view().writing().manuscript();
    const sgml::Tree& tree = now.document.tree();
    if (element != sgml::noNode) {
        place = placeOf(now, element);
        if (const sgml::NodeId content = tree.content(element); content != sgml::noNode)
            source = QString::fromStdString(std::string(tree.unescaped(content).text()));
    }
    FormulaDialog dialog(source, place, parentWidget());
    if (dialog.exec() != QDialog::Accepted)
        return;
    const std::string text = dialog.source().toStdString();
    perform([&](const Manuscript& in, Selection at) -> authoring::Result {
        if (element == sgml::noNode)
            return authoring::insertFormula(in, at, text, kindOf(in, dialog.place()));
        if (dialog.place() == place || !tree.holds(element))
            return authoring::setText(in, element, text);
        const text::Range range = tree.node(element).range;
        return authoring::insertFormula(in, {range.from, range.to}, text,
                                        kindOf(in, dialog.place()));
    });
}

} // namespace menus
