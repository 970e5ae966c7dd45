#include "manuscript/grammar.h"

#include "schemas/number_pattern.h"

#include <algorithm>

namespace manuscript {

using schemas::ContainerRole;
using schemas::Display;

namespace {

Kind kindOf(const Element& element) {
    switch (element.display) {
    case Display::unknown:
        return Kind::unknown;
    case Display::inlined:
    case Display::link:
        return Kind::inlined;
    case Display::block:
    case Display::verbatim:
    case Display::table:
    case Display::row:
    case Display::cell:
        return Kind::block;
    case Display::pageBreak:
    case Display::rule:
    case Display::equation:
    case Display::contents:
        return Kind::blockUnit;
    case Display::image:
    case Display::footnote:
    case Display::reference:
    case Display::slider:
    case Display::value:
    case Display::chart:
    case Display::formula:
        return Kind::unit;
    }
    return Kind::unknown;
}

} // namespace

Grammar::Grammar(const schemas::StructureSchema* structure,
                 const schemas::Presentation& presentation)
    : structure_(structure) {
    const Element document{.kind = Kind::unit,
                           .display = Display::block,
                           .role = ContainerRole::none,
                           .holdsText = false};
    elements_.emplace("DOCUMENT", document);
    if (structure == nullptr)
        return;
    for (const std::string& name : structure->names()) {
        const schemas::ElementStyle style = presentation.styleNamed(name);
        Element element{.display = style.display,
                        .role = style.role,
                        .holdsText = allowsText(name),
                        .referredAs = std::string(schemas::wordsBefore(style.reference))};
        element.kind = kindOf(element);
        schemas::Presentation::Progress progress = presentation.start();
        element.isHeaderFirst =
            presentation.style({.name = name, .first = true}, presentation.rootStyle(), progress)
                .repeat;
        element.isNumbered = !style.counter.empty() && style.role != ContainerRole::item;
        elements_.emplace(name, element);
        variants_.emplace(name, presentation.variantsOf(name));
    }
}

const std::vector<Grammar::Variant>& Grammar::variants(std::string_view element) const {
    static const std::vector<Variant> none;
    const auto found = variants_.find(element);
    return found == variants_.end() ? none : found->second;
}

const Element& Grammar::of(std::string_view name) const {
    static const Element unknown{};
    const auto found = elements_.find(name);
    return found == elements_.end() ? unknown : found->second;
}

bool Grammar::allowsText(std::string_view name) const {
    const std::vector<std::string> first = allowedAt(name, {}, 0);
    return std::find(first.begin(), first.end(), "TEXT") != first.end();
}

std::string_view Grammar::named(ContainerRole role) const {
    for (const auto& [name, element] : elements_)
        if (element.role == role)
            return name;
    return {};
}

std::string_view Grammar::named(Display display) const {
    for (const auto& [name, element] : elements_)
        if (element.display == display && name != "DOCUMENT")
            return name;
    return {};
}

QString Grammar::whyNot(std::string_view element, const Children& children) const {
    const schemas::ContentModel* model =
        structure_ == nullptr ? nullptr : structure_->model(element);
    if (model == nullptr)
        return {};
    const schemas::ContentModel::Verdict verdict = model->check(children);
    const auto sentence = [](QString text) {
        text[0] = text[0].toUpper();
        return text;
    };
    if (verdict.wrong < children.size())
        return sentence(QStringLiteral("%1 may not stand here in %2.")
                            .arg(called(*this, children[verdict.wrong]), called(*this, element)));
    return verdict.incomplete ? sentence(QStringLiteral("%1 would lack what it must have: %2.")
                                             .arg(called(*this, element),
                                                  QString::fromStdString(verdict.expected)))
                              : QString{};
}

std::vector<std::string> Grammar::allowedAt(std::string_view element, const Children& children,
                                            std::size_t index) const {
    const schemas::ContentModel* model =
        structure_ == nullptr ? nullptr : structure_->model(element);
    if (model == nullptr)
        return {};
    std::vector<std::string> allowed = model->allowedAt(children, index);
    if (std::find(allowed.begin(), allowed.end(), "ANY") == allowed.end())
        return allowed;
    allowed = {"TEXT"};
    for (const auto& [name, known] : elements_)
        if (name != "TEXT")
            allowed.push_back(name);
    return allowed;
}

bool Grammar::mayHold(std::string_view element, std::string_view child) const {
    const schemas::ContentModel* model =
        structure_ == nullptr ? nullptr : structure_->model(element);
    return model != nullptr && std::any_of(model->symbols().begin(), model->symbols().end(),
                                           [&](const schemas::ContentModel::Symbol& symbol) {
                                               return symbol.name == child || symbol.name == "ANY";
                                           });
}

bool Grammar::hasAttribute(std::string_view element, std::string_view attribute) const {
    return attribute == "ID" || attribute == "LANG" || structure_ == nullptr ||
           structure_->hasAttribute(element, attribute);
}

const Grammar* Grammars::of(std::string_view className) const {
    if (!schemas_.isText(className))
        return nullptr;
    auto found = grammars_.find(className);
    if (found == grammars_.end())
        found = grammars_
                    .emplace(className, Grammar(schemas_.structure(className),
                                                schemas_.presentation(className)))
                    .first;
    return &found->second;
}

QString called(const Grammar& grammar, std::string_view name) {
    static const std::map<ContainerRole, QString> byRole = {
        {ContainerRole::section, QStringLiteral("a section")},
        {ContainerRole::list, QStringLiteral("a list")},
        {ContainerRole::item, QStringLiteral("an item of a list")},
        {ContainerRole::figure, QStringLiteral("a figure")},
        {ContainerRole::table, QStringLiteral("a table")},
        {ContainerRole::caption, QStringLiteral("a caption")},
        {ContainerRole::quote, QStringLiteral("a quotation")},
        {ContainerRole::paragraph, QStringLiteral("a paragraph")},
        {ContainerRole::heading, QStringLiteral("a heading")},
        {ContainerRole::emphasis, QStringLiteral("emphasis")},
        {ContainerRole::strong, QStringLiteral("strong emphasis")},
        {ContainerRole::code, QStringLiteral("code")}};
    static const std::map<Display, QString> byDisplay = {
        {Display::verbatim, QStringLiteral("preformatted text")},
        {Display::cell, QStringLiteral("a cell")},
        {Display::footnote, QStringLiteral("a footnote")},
        {Display::link, QStringLiteral("a link")},
        {Display::reference, QStringLiteral("a reference")},
        {Display::image, QStringLiteral("an image")},
        {Display::pageBreak, QStringLiteral("a page break")},
        {Display::rule, QStringLiteral("a rule")},
        {Display::contents, QStringLiteral("a table of contents")}};
    if (name.empty() || name == "TEXT")
        return QStringLiteral("text");
    if (name == "DOCUMENT")
        return QStringLiteral("an embedded document");
    const Element& element = grammar.of(name);
    if (const auto role = byRole.find(element.role); role != byRole.end())
        return role->second;
    if (const auto display = byDisplay.find(element.display); display != byDisplay.end())
        return display->second;
    return QStringLiteral("a ") +
           QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()));
}

} // namespace manuscript
