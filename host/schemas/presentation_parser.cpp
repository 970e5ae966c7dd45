// Reads presentation files: `SELECTOR, SELECTOR { property: words; ... }`, /* comments */.
#include "schemas/presentation.h"

#include <algorithm>

namespace schemas {

namespace {

constexpr std::size_t npos = std::string_view::npos;
constexpr std::string_view blanks = " \t\r\n";

} // namespace

// After a fault: the next `;` or `}` inside a block, the next `}` outside one.
class PresentationParser {
public:
    PresentationParser(std::string_view text, std::vector<sgml::Fault>& faults,
                       Presentation& presentation)
        : text_(text), faults_(faults), presentation_(presentation) {}

    void parse() {
        while (skipBlanks(), at_ < text_.size())
            readBlock();
        std::stable_sort(presentation_.selectors_.begin(), presentation_.selectors_.end(),
                         [](const auto& a, const auto& b) {
                             return std::pair(a.layer, a.names.size()) <
                                    std::pair(b.layer, b.names.size());
                         });
    }

private:
    void skipBlanks() {
        for (;;) {
            at_ = std::min(text_.find_first_not_of(blanks, at_), text_.size());
            if (!text_.substr(at_).starts_with("/*"))
                return;
            const std::size_t end = text_.find("*/", at_ + 2);
            if (end == npos)
                fail(at_, "a comment is not closed with \"*/\"");
            at_ = end == npos ? text_.size() : end + 2;
        }
    }

    void readBlock() {
        const std::size_t from = at_;
        const std::size_t brace = std::min(text_.find_first_of("{}", at_), text_.size());
        if (brace == text_.size() || text_[brace] == '}') {
            fail(from, brace == text_.size() ? "\"{\" is missing behind the names"
                                             : "\"}\" closes nothing");
            at_ = std::min(brace + 1, text_.size());
            return;
        }
        const std::string_view head = text_.substr(from, brace - from);
        at_ = brace + 1;
        if (head.substr(0, head.find_last_not_of(blanks) + 1) == "PAGE") {
            for (const Property& property : readProperties())
                presentation_.saysSomething_ |=
                    check(applyPageProperty(presentation_.page_, property), property);
            return;
        }
        std::vector<Presentation::Selector> selectors = readSelectors(head, from);
        std::vector<Property> block = readProperties();
        ElementStyle scratch;
        std::erase_if(block, [&](const Property& property) {
            return !check(applyProperty(scratch, property, ElementStyle{}), property);
        });
        for (Presentation::Selector& selector : selectors) {
            selector.block = presentation_.blocks_.size();
            selector.layer = presentation_.layer_;
            presentation_.saysSomething_ = true;
            presentation_.selectors_.push_back(std::move(selector));
        }
        presentation_.blocks_.push_back(std::move(block));
    }

    std::vector<Presentation::Selector> readSelectors(std::string_view head, std::size_t offset) {
        std::vector<Presentation::Selector> selectors;
        for (std::size_t at = 0; at <= head.size();) {
            const std::size_t end = std::min(head.find(',', at), head.size());
            if (auto selector = readSelector(head.substr(at, end - at)))
                selectors.push_back(std::move(*selector));
            else
                fail(offset,
                     "\"" + std::string(head.substr(at, end - at)) + "\" does not name elements");
            at = end + 1;
        }
        return selectors;
    }

    static std::optional<Presentation::Selector> readSelector(std::string_view text) {
        constexpr std::size_t most = 100;
        Presentation::Selector selector;
        for (std::size_t at = 0; (at = text.find_first_not_of(blanks, at)) != npos;) {
            const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
            const auto name = readName(text.substr(at, end - at));
            if (!name)
                return std::nullopt;
            selector.names.push_back(*name);
            at = end;
        }
        if (selector.names.empty() || selector.names.size() > most)
            return std::nullopt;
        return selector;
    }

    // `NAME`, `NAME:first`, `NAME[KIND=number]`
    static std::optional<Presentation::Selector::Name> readName(std::string_view text) {
        constexpr std::string_view firstMark = ":first";
        Presentation::Selector::Name result;
        result.first = text.ends_with(firstMark);
        if (result.first)
            text.remove_suffix(firstMark.size());
        const std::size_t bracket = text.find('[');
        if (bracket != npos) {
            const std::size_t equals = text.find('=', bracket);
            if (equals == npos || text.back() != ']')
                return std::nullopt;
            result.attribute = text.substr(bracket + 1, equals - bracket - 1);
            result.value = text.substr(equals + 1, text.size() - equals - 2);
            text = text.substr(0, bracket);
        }
        const auto isLetter = [](char c) {
            return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z');
        };
        if (text.empty() || (text != "*" && !isLetter(text[0])) ||
            text.find_first_of("<>;\"/[]") != npos)
            return std::nullopt;
        result.name = text;
        return result;
    }

    std::vector<Property> readProperties() {
        std::vector<Property> properties;
        const std::size_t open = at_ - 1;
        while (skipBlanks(), at_ < text_.size() && text_[at_] != '}') {
            if (text_[at_] == ';')
                ++at_;
            else if (auto property = readProperty())
                properties.push_back(std::move(*property));
        }
        if (at_ >= text_.size())
            fail(open, "this \"{\" is not closed with \"}\"");
        else
            ++at_;
        return properties;
    }

    std::optional<Property> readProperty() {
        Property property{.name = {}, .words = {}, .offset = at_};
        const std::size_t end = std::min(text_.find_first_of(":;{}\"", at_), text_.size());
        if (end == text_.size() || text_[end] != ':') {
            fail(at_, "a property is NAME: value;");
            at_ = std::min(text_.find_first_of(";}", at_ + 1), text_.size());
            return std::nullopt;
        }
        const std::string_view name = text_.substr(at_, end - at_);
        property.name = name.substr(0, name.find_last_not_of(blanks) + 1);
        at_ = end + 1;
        while (skipBlanks(), at_ < text_.size() && text_[at_] != ';' && text_[at_] != '}')
            if (!readWord(property))
                return std::nullopt;
        return property;
    }

    bool readWord(Property& property) {
        if (text_[at_] == '{') {
            fail(at_, "\"{\" inside a block");
            ++at_;
            return false;
        }
        const bool quoted = text_[at_] == '"';
        const std::size_t from = quoted ? at_ + 1 : at_;
        std::size_t end = text_.find_first_of(quoted ? "\"\n" : " \t\r\n;{}\"", from);
        end = std::min(end, text_.size());
        if (quoted && (end == text_.size() || text_[end] == '\n')) {
            fail(at_, "a string is not closed with a quote");
            at_ = end;
            return false;
        }
        property.words.push_back({std::string(text_.substr(from, end - from)), quoted});
        at_ = quoted ? end + 1 : end;
        return true;
    }

    bool check(const std::string& problem, const Property& property) {
        if (!problem.empty())
            fail(property.offset, property.name + ": " + problem);
        return problem.empty();
    }

    void fail(std::size_t offset, std::string message) {
        sgml::Fault fault;
        fault.range = {offset, offset};
        fault.position = text::Places(text_).at(offset);
        fault.message = std::move(message);
        faults_.push_back(std::move(fault));
    }

    std::string_view text_;
    std::vector<sgml::Fault>& faults_;
    Presentation& presentation_;
    std::size_t at_ = 0;
};

Presentation Presentation::parse(std::string_view text, std::vector<sgml::Fault>& faults,
                                 const Presentation* base) {
    Presentation presentation;
    if (base != nullptr)
        presentation = *base;
    ++presentation.layer_;
    presentation.saysSomething_ = false;
    PresentationParser(text, faults, presentation).parse();
    return presentation;
}

} // namespace schemas
