#include "formulas/plain_words.h"

#include "formulas/symbols.h"

#include <algorithm>
#include <array>

namespace formulas {

namespace {

using text::Range;

bool isLetter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }
bool isDigit(char c) { return c >= '0' && c <= '9'; }

struct Written {
    std::string_view plain, tex;
};
constexpr std::array signs{
    Written{"<=", "\\le "},         Written{">=", "\\ge "}, Written{"->", "\\to "},
    Written{"=>", "\\Rightarrow "}, Written{"+-", "\\pm "}, Written{"...", "\\dots "},
    Written{"*", "\\cdot "},
};
constexpr std::array otherWords{
    Written{"infinity", "\\infty"},
    Written{"integral", "\\int"},
    Written{"root", "\\sqrt"},
    Written{"degrees", "^\\circ"},
};
// Commands behind which words are words.
constexpr std::array<std::string_view, 14> takeWords{
    "text",   "textrm", "textbf", "textit", "mbox",  "mathrm",       "mathbf",
    "mathsf", "mathtt", "begin",  "end",    "value", "operatorname", "mathit"};

class Scan {
public:
    explicit Scan(std::string_view source) : source_(source) {}

    std::vector<PlainWord> take() {
        while (at_ < source_.size())
            step();
        return std::move(found_);
    }

private:
    [[nodiscard]] std::string_view rest() const { return source_.substr(at_); }
    [[nodiscard]] std::size_t endOf(bool (*isPart)(char), std::size_t from) const {
        while (from < source_.size() && isPart(source_[from]))
            ++from;
        return from;
    }

    void step() {
        const char c = source_[at_];
        if (c == '\\')
            passCommand();
        else if (c == '^' || c == '_')
            script();
        else if (isLetter(c))
            word();
        else if (!sign())
            ++at_;
    }

    void propose(Range range, text::Edits edits, const std::string& shown) {
        const std::string plain(source_.substr(range.from, range.size()));
        found_.push_back({range, std::move(edits), "TeX writes " + shown + " for " + plain + "."});
    }
    void propose(Range range, const std::string& tex) {
        propose(range, {{range, tex}}, tex.substr(0, tex.find_last_not_of(' ') + 1));
    }

    void passCommand() {
        const std::size_t end = endOf(isLetter, at_ + 1);
        const std::string_view name = source_.substr(at_ + 1, end - at_ - 1);
        at_ = std::max(end, std::min(at_ + 2, source_.size()));
        if (std::ranges::find(takeWords, name) == takeWords.end())
            return;
        while (at_ < source_.size() &&
               (source_[at_] == '{' || source_[at_] == '[' || source_[at_] == '*'))
            at_ = source_[at_] == '*'
                      ? at_ + 1
                      : closing(at_, source_[at_], source_[at_] == '{' ? '}' : ']') + 1;
    }

    // The place of the bracket that closes the one at `from`; the end of the source: none does.
    [[nodiscard]] std::size_t closing(std::size_t from, char open, char close) const {
        int depth = 0;
        for (std::size_t at = from; at < source_.size(); ++at) {
            if (source_[at] == '\\')
                ++at;
            else if (source_[at] == open)
                ++depth;
            else if (source_[at] == close && --depth == 0)
                return at;
        }
        return source_.size();
    }

    [[nodiscard]] static std::string commandFor(std::string_view word) {
        const auto other = std::ranges::find(otherWords, word, &Written::plain);
        if (other != otherWords.end())
            return std::string(other->tex);
        const Symbol* symbol = symbolNamed(word);
        constexpr char32_t firstGreek = 0x370, lastGreek = 0x3FF;
        const bool isGreek = symbol && symbol->code >= firstGreek && symbol->code <= lastGreek;
        const bool isKnown = isGreek || (word.size() > 2 && symbol) || functionNamed(word) ||
                             word == "sqrt" || word == "frac";
        return isKnown && word.size() > 1 ? "\\" + std::string(word) : std::string();
    }

    void word() {
        const Range range{at_, endOf(isLetter, at_)};
        const std::string command = commandFor(source_.substr(at_, range.size()));
        at_ = range.to;
        if (command.empty())
            return;
        if (command == "\\sqrt" && rest().starts_with('('))
            return inBraces(range, command, at_);
        propose(range, command);
    }

    // The parentheses that begin there hold one part.
    void inBraces(Range word, const std::string& command, std::size_t open) {
        const std::size_t close = closing(open, '(', ')');
        const bool ends = close < source_.size();
        text::Edits edits{{{word.from, open + 1}, command + "{"}};
        const std::size_t to = ends ? close + 1 : close;
        edits.push_back({{close, to}, "}"});
        at_ = open + 1;
        const std::string inside(source_.substr(open + 1, close - open - 1));
        propose({word.from, to}, std::move(edits), command + "{" + inside + "}");
    }

    // One sign alone is raised, or what stands in braces.
    void script() {
        const std::size_t part = ++at_;
        if (rest().starts_with('('))
            return inBraces({part, part}, "", part);
        const bool isSigned =
            part < source_.size() && (source_[part] == '-' || source_[part] == '+');
        const std::size_t from = part + (isSigned ? 1 : 0);
        const std::size_t letters = endOf(isLetter, from), digits = endOf(isDigit, from);
        const std::size_t to = std::max(letters, digits);
        const bool isMixed = to < source_.size() && (isLetter(source_[to]) || isDigit(source_[to]));
        const std::string plain(source_.substr(part, to - part));
        const bool isRaisedSign = to == from && part < source_.size() && source_[part] == '*';
        at_ += isRaisedSign ? 1 : 0;
        if (to == from || isMixed || plain.size() < 2)
            return;
        const std::string command = isSigned ? std::string() : commandFor(plain);
        constexpr std::size_t shortName = 2; // as in a_{ij}
        at_ = to;
        if (!command.empty())
            propose({part, to}, command);
        else if (letters > from + shortName)
            propose({part, to}, "{\\mathrm{" + plain + "}}");
        else
            propose({part, to}, "{" + plain + "}");
    }

    bool sign() {
        for (const Written& one : signs)
            if (rest().starts_with(one.plain)) {
                propose({at_, at_ + one.plain.size()}, std::string(one.tex));
                at_ += one.plain.size();
                return true;
            }
        return false;
    }

    std::string_view source_;
    std::size_t at_ = 0;
    std::vector<PlainWord> found_;
};

} // namespace

std::vector<PlainWord> plainWords(std::string_view source) { return Scan(source).take(); }

std::string withTex(std::string_view source, const std::vector<PlainWord>& words) {
    text::Edits all;
    for (const PlainWord& word : words)
        all.insert(all.end(), word.edits.begin(), word.edits.end());
    text::putInOrder(all);
    return text::applied(source, all);
}

} // namespace formulas
