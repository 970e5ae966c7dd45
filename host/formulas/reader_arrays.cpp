// Parts in rows and columns: \begin{...} ... \end{...}.
#include "formulas/reader.h"

#include <algorithm>

namespace formulas {

namespace {

struct Environment {
    std::string_view name{};
    ArrayForm form;
    char32_t open = 0, close = 0;
};
constexpr Environment environments[] = {
    {"matrix", ArrayForm::matrix},
    {"pmatrix", ArrayForm::matrix, U'(', U')'},
    {"bmatrix", ArrayForm::matrix, U'[', U']'},
    {"Bmatrix", ArrayForm::matrix, U'{', U'}'},
    {"vmatrix", ArrayForm::matrix, U'|', U'|'},
    {"Vmatrix", ArrayForm::matrix, U'‖', U'‖'},
    {"smallmatrix", ArrayForm::small},
    {"array", ArrayForm::matrix},
    {"cases", ArrayForm::cases, U'{', U'.'},
    {"aligned", ArrayForm::aligned},
    {"align", ArrayForm::aligned},
    {"align*", ArrayForm::aligned},
    {"split", ArrayForm::aligned},
    {"gathered", ArrayForm::gathered},
    {"gather", ArrayForm::gathered},
    {"gather*", ArrayForm::gathered},
    {"equation", ArrayForm::gathered},
    {"equation*", ArrayForm::gathered},
};

// How the columns stand that nobody says anything about.
char usual(ArrayForm form, std::size_t column) {
    if (form == ArrayForm::cases)
        return 'l';
    if (form == ArrayForm::aligned)
        return column % 2 == 0 ? 'r' : 'l';
    return 'c';
}

} // namespace

NodeId Reader::environment(const Token& token) {
    bool there = false;
    const std::string name(raw(token, there));
    const auto* known = std::ranges::find(environments, name, &Environment::name);
    if (!there)
        fault(token, "\\begin needs a name in braces, such as \\begin{pmatrix}.");
    else if (known == std::end(environments))
        fault(token, "There is no \\begin{" + name + "}; there are matrix, pmatrix, bmatrix, " +
                         "vmatrix, cases, aligned, gathered and array.");
    const std::string columns = name == "array" ? columnsOf(token) : std::string();
    const bool isKnown = known != std::end(environments);
    ++waiting_.environments;
    const NodeId id = array(token, isKnown ? known->form : ArrayForm::matrix, columns);
    --waiting_.environments;
    if (peek().text != "\\end") {
        fault(token, "\\begin{" + name + "} has no \\end{" + name + "}.");
    } else {
        const Token end = next();
        bool named = false;
        const std::string closing(raw(end, named));
        if (closing != name)
            fault(end, "\\end{" + closing + "} stands where \\end{" + name + "} is awaited.");
    }
    finish(id);
    return isKnown && known->open != 0 ? delimited(known->open, id, known->close, token) : id;
}

std::string Reader::columnsOf(const Token& token) {
    bool there = false;
    const std::string_view given = raw(token, there);
    std::string columns;
    bool strange = !there;
    for (const char c : given) {
        if (c == 'l' || c == 'c' || c == 'r')
            columns += c;
        else
            strange = strange || c != ' ';
    }
    if (strange)
        fault(token, "The columns of an array are letters l, c and r, as in \\begin{array}{lcr}.");
    return columns;
}

// \\[3pt]: the space behind a row is the typesetter's.
void Reader::skipRowSpace() {
    if (at_ >= source_.size() || source_[at_] != '[')
        return;
    const std::size_t end = source_.find(']', at_);
    if (end == std::string_view::npos || end > at_ + 12)
        return;
    fault(at_, end + 1, "The distance of rows cannot be set; [...] is left out.");
    at_ = end + 1;
}

NodeId Reader::array(const Token& token, ArrayForm form, std::string columns) {
    const Waiting outer = waiting_;
    ++waiting_.cells;
    waiting_.bracket = false;
    std::vector<std::vector<NodeId>> rows(1);
    std::size_t width = 1;
    for (;;) {
        const NodeId cell = list();
        if (rows.back().size() < mostColumns)
            rows.back().push_back(cell);
        else if (rows.back().size() == mostColumns && width <= mostColumns) {
            fault(token, "An array has at most " + std::to_string(mostColumns) +
                             " columns; the others are left out.");
            width = mostColumns + 1;
        }
        const Token end = peek();
        if (end.text != "&" && !end.endsRow())
            break;
        (void)next();
        if (end.text == "&")
            continue;
        if (end.text == "\\\\")
            skipRowSpace();
        rows.emplace_back();
    }
    waiting_ = outer;
    if (rows.size() > 1 && rows.back().size() == 1 &&
        formula_.nodes[rows.back().front()].children.empty())
        rows.pop_back();
    width = 0;
    for (const auto& row : rows)
        width = std::max(width, row.size());
    while (columns.size() < width)
        columns += usual(form, columns.size());
    columns.resize(width);
    const NodeId id = add(Kind::array, token);
    Node& node = formula_.nodes[id];
    node.form = form;
    node.text = std::move(columns);
    for (auto& row : rows) {
        row.resize(width, none);
        node.children.insert(node.children.end(), row.begin(), row.end());
    }
    return finish(id);
}

NodeId Reader::substack(const Token& token) {
    if (peek().text != "{") {
        fault(token, "\\substack needs its lines in braces.");
        return missingPart(token);
    }
    const Token open = next();
    const Waiting outer = waiting_;
    ++waiting_.braces;
    const NodeId id = array(token, ArrayForm::stack, {});
    waiting_ = outer;
    if (peek().text == "}")
        (void)next();
    else
        fault(open, "This { has no } that ends it.");
    return id;
}

} // namespace formulas
