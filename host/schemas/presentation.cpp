#include "schemas/presentation.h"

#include <algorithm>
#include <map>

namespace schemas {

namespace {

bool matches(const Presentation::Selector::Name& pattern, const Presentation::Subject& subject) {
    if (pattern.name != "*" && pattern.name != subject.name)
        return false;
    if (pattern.first && !subject.first)
        return false;
    return pattern.attribute.empty() ||
           (subject.tree != nullptr &&
            subject.tree->attribute(subject.element, pattern.attribute) == pattern.value);
}

// The nearest element of a name says of which kind it is: a list in a numbered list is another one.
bool isOfAnotherKind(const Presentation::Selector::Name& outer,
                     const Presentation::Subject& subject) {
    return !outer.attribute.empty() && outer.name == subject.name && !matches(outer, subject);
}

} // namespace

std::set<std::string, std::less<>> Presentation::namesShownAs(std::string_view display) const {
    std::set<std::string, std::less<>> names;
    for (const Selector& selector : selectors_)
        for (const Property& property : blocks_[selector.block])
            if (property.name == "display" && !property.words.empty() &&
                property.words.front().text == display)
                names.insert(selector.names.back().name);
    return names;
}

ElementStyle Presentation::styleNamed(std::string_view name) const {
    const ElementStyle root = rootStyle();
    ElementStyle style;
    const auto apply = [&](const Selector& selector) {
        if (selector.names.back().name == name || selector.names.back().name == "*")
            for (const Property& property : blocks_[selector.block])
                (void)applyProperty(style, property, root);
    };
    const auto isPlain = [](const Selector& selector) {
        return selector.names.size() == 1 && selector.names[0].attribute.empty() &&
               !selector.names[0].first;
    };
    for (const Selector& selector : selectors_)
        if (!isPlain(selector))
            apply(selector);
    for (const Selector& selector : selectors_)
        if (isPlain(selector))
            apply(selector);
    return style;
}

std::vector<Presentation::Variant> Presentation::variantsOf(std::string_view name) const {
    std::map<std::pair<std::string, std::string>, ElementStyle> found;
    const ElementStyle root = rootStyle();
    for (const Selector& selector : selectors_)
        for (const Selector::Name& part : selector.names) {
            if (part.name != name || part.attribute.empty())
                continue;
            ElementStyle& style = found[{part.attribute, part.value}];
            if (selector.names.size() == 1)
                for (const Property& property : blocks_[selector.block])
                    (void)applyProperty(style, property, root);
        }
    std::vector<Variant> variants;
    variants.reserve(found.size());
    for (const auto& [asked, style] : found)
        variants.push_back({.attribute = asked.first,
                            .value = asked.second,
                            .isNumbered = !style.number.empty(),
                            .lists = style.lists,
                            .reference = style.reference,
                            .refersByNumber = style.refersByNumber});
    return variants;
}

ElementStyle Presentation::rootStyle() const {
    ElementStyle root;
    root.display = Display::block;
    root.text.language = "en";
    return root;
}

ElementStyle Presentation::style(const Subject& subject, const ElementStyle& outer,
                                 Progress& progress) const {
    ElementStyle style;
    style.text = outer.text;
    style.block.align = outer.block.align;
    style.block.lineHeight = outer.block.lineHeight;
    style.block.mayFloat = outer.block.mayFloat;
    for (std::size_t i = 0; i < selectors_.size(); ++i) {
        const std::vector<Selector::Name>& names = selectors_[i].names;
        const std::size_t last = names.size() - 1;
        if (progress[i] == last && matches(names[last], subject))
            for (const Property& property : blocks_[selectors_[i].block])
                (void)applyProperty(style, property,
                                    outer); // its faults were found when it was read
        if (progress[i] < last && matches(names[progress[i]], subject))
            ++progress[i];
        else if (progress[i] > 0 && isOfAnotherKind(names[progress[i] - 1], subject))
            --progress[i];
    }
    return style;
}

} // namespace schemas
