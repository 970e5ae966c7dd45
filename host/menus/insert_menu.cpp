#include "menus/insert_menu.h"
#include "menus/actions.h"

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
        if (grammar && !name.empty())
            for (const auto& kind : grammar->variants(name))
                if (kind.lists == of)
                    return authoring::insertBlock(
                        in, at, name, " " + sgml::attributeText(kind.attribute, kind.value));
        return authoring::Refusal{InsertMenu::tr("This class of documents has no such element.")};
    };
}

QString noFigure() {
    return InsertMenu::tr("No figure here has values to show: insert one first.");
}

sgml::NodeId firstFigure(const Manuscript& in) {
    for (const document::SubdocumentId id : in.document.subdocuments())
        if (const document::Subdocument* of = in.document.subdocument(id); of->hasText)
            return of->element;
    return sgml::noNode;
}

// Of any figure: whether one may stand at the caret.
authoring::Result valueOfFirst(const Manuscript& in, Selection at) {
    const sgml::NodeId figure = firstFigure(in);
    if (figure == sgml::noNode)
        return authoring::Refusal{noFigure()};
    return authoring::insertValue(in, at, figure, {.of = {}, .expression = "t"});
}

} // namespace

InsertMenu::InsertMenu(view::DocumentView& view, const CommandMenu& tables, QMenu& images,
                       QWidget* parent)
    : CommandMenu(tr("&Insert"), view, parent) {
    setObjectName("insert");
    addBeginning();
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
        [this] { askForReference(this->view().writing().selectedAlone(Display::reference)); });
    add("footnote", tr("&Footnote"), QKeySequence("Ctrl+Alt+F"), authoring::insertFootnote);
    addSeparator();
    addAsking(
        "formula", tr("For&mula..."), QKeySequence("Ctrl+Shift+F"),
        [](const Manuscript& in, Selection at) { return authoring::insertFormula(in, at, "x"); },
        [this] { askForFormula(this->view().writing().selectedAlone(Display::formula)); });
    addAsking("value", tr("&Value of a Figure..."), QKeySequence("Ctrl+Alt+V"), valueOfFirst,
              [this] { askForValue(this->view().writing().selectedAlone(Display::value)); });
    for (const media::Manifest& manifest : view.document().media().registry().media()) {
        QMenu* ofMedium = new MediumMenu(manifest, view, parent);
        addMenu(ofMedium);
    }
    addEntryOf(tables, "insertTable");
    addMenu(&images);
    addCaption();
    addSeparator();
    add("pageBreak", tr("&Page Break"), QKeySequence("Ctrl+Return"), block(Display::pageBreak));
    add("rule", tr("R&ule"), {}, block(Display::rule));
    addSeparator();
    using schemas::ContainerRole;
    add("contents", tr("&Table of Contents"), {}, contents(ContainerRole::heading));
    add("listOfFigures", tr("List of Fi&gures"), {}, contents(ContainerRole::figure));
    add("listOfTables", tr("List of Ta&bles"), {}, contents(ContainerRole::table));
    connect(&this->view(), &view::DocumentView::elementActivated, this, &InsertMenu::ask);
}

void InsertMenu::ask(sgml::NodeId element, schemas::Display as) {
    if (as == Display::formula)
        askForFormula(element);
    else if (as == Display::value)
        askForValue(element);
    else
        askForReference(element);
}

// A reference that is there, also one whose target is gone, may lead elsewhere.
void InsertMenu::addTo(QMenu& menu, const QPoint& at) {
    const QPointF point = view().viewport()->mapFromGlobal(at);
    const model::Run* run = view().isWriting() ? view().runAt(point) : nullptr;
    if (!run || !run->refers)
        return;
    menus::addTo(menu, "changeReference", tr("&Refer to Something Else..."), {},
                 [this, element = run->element] { askForReference(element); });
    menu.addSeparator();
}

// Of the figure that is chosen, or of the figure or table around the caret. One that is there gets
// the caret.
void InsertMenu::addCaption() {
    const Command caption = [this](const Manuscript& in, Selection at) {
        const std::optional<std::size_t> figure = chosenFigureEnd();
        return authoring::insertCaption(in, figure ? Selection{*figure, *figure} : at);
    };
    QAction* entry = add("caption", tr("&Caption"), QKeySequence("Ctrl+Alt+C"), caption);
    // Behind what the menu offers.
    connect(this, &QMenu::aboutToShow, this, [entry] {
        entry->setText(entry->isEnabled() ? tr("&Caption") : tr("&Caption, in a Figure or Table"));
    });
}

std::optional<std::size_t> InsertMenu::chosenFigureEnd() const {
    const document::Document& document = view().document().document();
    const document::Subdocument* figure = document.subdocument(view().chosen());
    return figure ? std::optional(document.tree().node(figure->element).range.to) : std::nullopt;
}

// A link that one is in is changed as a whole.
void InsertMenu::askForLink() {
    const auto around = [](const Manuscript& in, Selection at) {
        return authoring::linkAround(in, at);
    };
    const auto old = around(view().writing().manuscript(), *view().writing().place());
    const std::optional<QString> wanted =
        menus::askForLink(old ? QString::fromStdString(old->target) : QString(), parentWidget());
    if (!wanted)
        return;
    view().writing().perform([&](const Manuscript& in, Selection at) {
        const auto link = around(in, at); // the document may have changed since
        return authoring::link(in, link ? link->text : at, wanted->toStdString());
    });
}

void InsertMenu::askForReference(sgml::NodeId element) {
    view().settle();
    if (!view().model())
        return;
    const Manuscript now = view().writing().manuscript();
    std::vector<Target> targets = described(authoring::targets(now), *view().model());
    const auto at = view().writing().place();
    const bool isNew = element == sgml::noNode;
    for (Target& one : targets)
        if (one.isNumbered && at) {
            const std::size_t place = isNew ? std::max(at->anchor, at->caret)
                                            : now.document.tree().node(element).range.from;
            one.kind = QString::fromStdString(authoring::referredAs(now, one.element));
            one.isNumberFitting =
                authoring::fittingAt(now, place, one.element) == authoring::ReferBy::number;
        }
    std::optional<bool> isByNumber;
    if (!isNew)
        isByNumber = authoring::refersBy(now, element) == authoring::ReferBy::number;
    ReferenceDialog dialog(std::move(targets), isByNumber, parentWidget());
    if (dialog.exec() != QDialog::Accepted || dialog.chosen() == sgml::noNode)
        return;
    view().writing().perform([&](const Manuscript& in, Selection where) {
        const auto by =
            dialog.isByNumber() ? authoring::ReferBy::number : authoring::ReferBy::kindAndNumber;
        return isNew ? authoring::insertReference(in, where, dialog.chosen(), by)
                     : authoring::changeReference(in, where, element, dialog.chosen(), by);
    });
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
    sgml::NodeId figure = sgml::noNode; // whose value came in, and that may need an ID
    FormulaDialog dialog(source, place, parentWidget());
    const auto valueChosen = [&](QWidget* parent) -> QString {
        std::vector<ValuedFigure> figures = this->figures();
        if (figure != sgml::noNode) // LIMIT: a formula gives an ID to one figure
            std::erase_if(figures, [&](const ValuedFigure& one) {
                return one.element != figure &&
                       view().document().document().subdocument(one.id)->name.empty();
            });
        const auto wanted = chosenValue(std::move(figures), {}, parent);
        if (!wanted)
            return {};
        const Manuscript in = view().writing().manuscript();
        const std::string id = authoring::idOf(in, wanted->figure);
        figure = wanted->figure;
        const std::string options = document::spelledOptions(wanted->use);
        return QString::fromStdString("\\value" + (options.empty() ? "" : "[" + options + "]") +
                                      "{" + id + "}{" + wanted->use.expression + "}");
    };
    dialog.offerValues(valueChosen, firstFigure(now) == sgml::noNode ? noFigure() : QString());
    if (const std::optional<QRectF> at =
            element == sgml::noNode ? view().text().caretRect() : view().placeOfFormula(element))
        dialog.standBy(
            {view().viewport()->mapToGlobal(at->topLeft().toPoint()), at->size().toSize()});
    if (dialog.exec() != QDialog::Accepted)
        return;
    const std::string text = dialog.source().toStdString();
    const auto withId = [&](const Manuscript& in, authoring::Result result) {
        const bool isUsed = figure != sgml::noNode &&
                            text.find("{" + authoring::idOf(in, figure) + "}") != std::string::npos;
        return isUsed ? authoring::withIdOf(in, figure, std::move(result)) : result;
    };
    view().writing().perform([&](const Manuscript& in, Selection at) -> authoring::Result {
        if (element == sgml::noNode)
            return withId(in, authoring::insertFormula(in, at, text, kindOf(in, dialog.place())));
        if (dialog.place() == place || !tree.holds(element))
            return withId(in, authoring::setText(in, element, text));
        const text::Range range = tree.node(element).range;
        return withId(in, authoring::insertFormula(in, {range.from, range.to}, text,
                                                   kindOf(in, dialog.place())));
    });
}

// --- values ------------------------------------------------------------------------------------

std::vector<ValuedFigure> InsertMenu::figures() {
    view().settle();
    return view().model()
               ? valuedFigures(view().document(), view().writing().manuscript(), *view().model())
               : std::vector<ValuedFigure>();
}

std::optional<InsertMenu::ChosenValue> InsertMenu::chosenValue(std::vector<ValuedFigure> figures,
                                                               const document::ValueUse& now,
                                                               QWidget* parent) {
    if (figures.empty()) {
        Q_EMIT view().writing().refused(noFigure());
        return std::nullopt;
    }
    const Manuscript in = view().writing().manuscript();
    const auto at = view().writing().place();
    ValueDialog dialog(view().document(), std::move(figures), now,
                       at ? authoring::languageAt(in, at->caret) : std::string(), parent);
    if (dialog.exec() != QDialog::Accepted)
        return std::nullopt;
    return ChosenValue{dialog.figure(), dialog.use()};
}

void InsertMenu::askForValue(sgml::NodeId element) {
    const sgml::Tree& tree = view().writing().manuscript().document.tree();
    const document::ValueUse now =
        element == sgml::noNode ? document::ValueUse() : document::valueUse(tree, element);
    const auto wanted = chosenValue(figures(), now, parentWidget());
    if (!wanted)
        return;
    view().writing().perform([&](const Manuscript& in, Selection at) {
        return element == sgml::noNode
                   ? authoring::insertValue(in, at, wanted->figure, wanted->use)
                   : authoring::changeValue(in, at, element, wanted->figure, wanted->use);
    });
}

} // namespace menus
