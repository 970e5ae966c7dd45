// The automaton of one structure rule: reading it and walking it.
#include "schemas/structure.h"

#include <algorithm>

namespace schemas {

namespace {

bool isNamePart(char c) {
    return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' ||
           c == '_' || c == '.' || c == ':';
}

} // namespace

// Recursive descent over `a b`, `a | b`, `a*`, `(a)`; each piece is known by whether it can be
// empty and by the positions that it can begin and end with.
class ContentModelParser {
public:
    ContentModelParser(std::string_view rule, ContentModel& model, std::string& fault)
        : rule_(rule), model_(model), fault_(fault) {}

    void parse() {
        model_.symbols_.push_back({});
        skipBlanks();
        Piece whole{.empty = true, .first = {}, .last = {}};
        if (at_ < rule_.size())
            whole = alternatives(0);
        if (at_ < rule_.size())
            fail(std::string("\"") + rule_[at_] + "\" is not expected here");
        if (!fault_.empty())
            return;
        model_.symbols_[0].next = whole.first;
        model_.final_.assign(model_.symbols_.size(), false);
        model_.final_[0] = whole.empty;
        for (const std::uint16_t position : whole.last)
            model_.final_[position] = true;
    }

private:
    using Positions = std::vector<std::uint16_t>;
    struct Piece {
        bool empty = false; // may stand for nothing
        Positions first, last;
    };

    void skipBlanks() {
        while (at_ < rule_.size() && (rule_[at_] == ' ' || rule_[at_] == '\t'))
            ++at_;
    }
    bool take(char c) {
        if (at_ >= rule_.size() || rule_[at_] != c)
            return false;
        ++at_;
        skipBlanks();
        return true;
    }
    void fail(const std::string& message) {
        if (fault_.empty())
            fault_ = message;
        at_ = rule_.size();
    }
    static void add(Positions& to, const Positions& from) {
        for (const std::uint16_t position : from)
            if (std::find(to.begin(), to.end(), position) == to.end())
                to.push_back(position);
    }
    void follow(const Positions& last, const Positions& first) {
        for (const std::uint16_t position : last)
            add(model_.symbols_[position].next, first);
    }

    Piece alternatives(int depth) {
        Piece result = sequence(depth);
        while (take('|')) {
            const Piece other = sequence(depth);
            result.empty = result.empty || other.empty;
            add(result.first, other.first);
            add(result.last, other.last);
        }
        return result;
    }

    Piece sequence(int depth) {
        Piece result{.empty = true, .first = {}, .last = {}};
        bool any = false;
        while (at_ < rule_.size() && rule_[at_] != '|' && rule_[at_] != ')') {
            any = true;
            const Piece next = repeated(depth);
            follow(result.last, next.first);
            if (result.empty)
                add(result.first, next.first);
            if (!next.empty)
                result.last.clear();
            add(result.last, next.last);
            result.empty = result.empty && next.empty;
        }
        if (!any)
            fail("a name is missing");
        return result;
    }

    Piece repeated(int depth) {
        Piece result = atom(depth);
        for (;;) {
            if (take('*')) {
                follow(result.last, result.first);
                result.empty = true;
            } else if (take('+')) {
                follow(result.last, result.first);
            } else if (take('?')) {
                result.empty = true;
            } else {
                return result;
            }
        }
    }

    Piece atom(int depth) {
        if (take('(')) {
            if (depth >= ContentModel::deepest)
                fail("parentheses are nested deeper than " + std::to_string(ContentModel::deepest));
            Piece inside = alternatives(depth + 1);
            if (!take(')'))
                fail("\")\" is missing");
            return inside;
        }
        const std::size_t from = at_;
        while (at_ < rule_.size() && isNamePart(rule_[at_]))
            ++at_;
        if (at_ == from)
            fail(at_ < rule_.size() ? std::string("\"") + rule_[at_] + "\" is not expected here"
                                    : "a name is missing");
        else if (model_.symbols_.size() > ContentModel::longest)
            fail("more than " + std::to_string(ContentModel::longest) + " names");
        if (!fault_.empty())
            return {};
        const auto position = static_cast<std::uint16_t>(model_.symbols_.size());
        model_.symbols_.push_back(
            {.name = std::string(rule_.substr(from, at_ - from)), .next = {}});
        skipBlanks();
        return {.empty = false, .first = {position}, .last = {position}};
    }

    std::string_view rule_;
    ContentModel& model_;
    std::string& fault_;
    std::size_t at_ = 0;
};

ContentModel ContentModel::parse(std::string_view rule, std::string& fault) {
    ContentModel model;
    ContentModelParser(rule, model, fault).parse();
    return model;
}

namespace {

bool matches(const ContentModel::Symbol& symbol, std::string_view child) {
    return symbol.name == child || symbol.name == "ANY" || (symbol.name == "TEXT" && child.empty());
}

// The positions where one may be, and those behind one child more.
struct Walk {
    std::vector<std::uint16_t> here{0}, next{};
    std::vector<bool> seen{};

    void look(const std::vector<ContentModel::Symbol>& symbols, std::string_view child) {
        next.clear();
        seen.assign(symbols.size(), false);
        for (const std::uint16_t position : here)
            for (const std::uint16_t candidate : symbols[position].next)
                if (!seen[candidate] && matches(symbols[candidate], child)) {
                    seen[candidate] = true;
                    next.push_back(candidate);
                }
    }
};

} // namespace

ContentModel::Verdict ContentModel::check(const std::vector<std::string_view>& children) const {
    Walk walk;
    const auto mayEnd = [&] {
        return std::any_of(walk.here.begin(), walk.here.end(),
                           [&](std::uint16_t position) { return final_[position]; });
    };
    for (std::size_t i = 0; i < children.size(); ++i) {
        walk.look(symbols_, children[i]);
        if (walk.next.empty())
            return {
                .wrong = i, .incomplete = false, .expected = expectedAfter(walk.here, mayEnd())};
        walk.here.swap(walk.next);
    }
    const bool complete = mayEnd();
    return {.wrong = children.size(),
            .incomplete = !complete,
            .expected = expectedAfter(walk.here, complete)};
}

std::vector<std::uint16_t> ContentModel::reached(const std::vector<std::string_view>& children,
                                                 std::size_t count) const {
    Walk walk;
    for (std::size_t i = 0; i < count; ++i) {
        walk.look(symbols_, children[i]);
        walk.here.swap(walk.next);
    }
    return walk.here;
}

std::vector<bool> ContentModel::goesOn(const std::vector<std::string_view>& children,
                                       std::size_t index) const {
    std::vector<bool> after = final_, before(symbols_.size());
    for (std::size_t i = children.size(); i-- > index;) {
        for (std::size_t position = 0; position < symbols_.size(); ++position)
            before[position] =
                std::any_of(symbols_[position].next.begin(), symbols_[position].next.end(),
                            [&](std::uint16_t next) {
                                return after[next] && matches(symbols_[next], children[i]);
                            });
        after.swap(before);
    }
    return after;
}

std::vector<std::string> ContentModel::allowedAt(const std::vector<std::string_view>& children,
                                                 std::size_t index) const {
    const std::vector<bool> after = goesOn(children, index);
    std::vector<bool> allowed(symbols_.size());
    for (const std::uint16_t position : reached(children, index))
        for (const std::uint16_t next : symbols_[position].next)
            allowed[next] = after[next];
    std::vector<std::string> names;
    for (std::size_t next = 1; next < symbols_.size(); ++next)
        if (allowed[next] &&
            std::find(names.begin(), names.end(), symbols_[next].name) == names.end())
            names.push_back(symbols_[next].name);
    return names;
}

// LIMIT: the first eight names; a longer list helps nobody.
std::string ContentModel::expectedAfter(const std::vector<std::uint16_t>& positions,
                                        bool mayEnd) const {
    constexpr std::size_t most = 8;
    std::vector<std::string> names;
    for (const std::uint16_t position : positions)
        for (const std::uint16_t next : symbols_[position].next) {
            const std::string& name = symbols_[next].name;
            const std::string word = name == "TEXT" ? "text" : name;
            if (std::find(names.begin(), names.end(), word) == names.end())
                names.push_back(word);
        }
    const bool cut = names.size() > most;
    names.resize(std::min(names.size(), most));
    if (mayEnd)
        names.push_back("the end");
    std::string list;
    for (std::size_t i = 0; i < names.size(); ++i)
        list += (i == 0                  ? ""
                 : i + 1 == names.size() ? (cut ? ", ... or " : " or ")
                                         : ", ") +
                names[i];
    return list;
}

} // namespace schemas
