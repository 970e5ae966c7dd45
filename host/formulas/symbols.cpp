#include "formulas/symbols.h"

#include "text/characters.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace formulas {

namespace {

constexpr Atom ord = Atom::ordinary, bin = Atom::binary, rel = Atom::relation, op = Atom::operation;
constexpr Atom open = Atom::opening, close = Atom::closing, punct = Atom::punctuation;
constexpr Limits style = Limits::byStyle, never = Limits::never;

// clang-format off
constexpr Symbol symbols[] = {
    {"alpha", U'α'}, {"beta", U'β'}, {"gamma", U'γ'}, {"delta", U'δ'}, {"epsilon", U'ϵ'},
    {"varepsilon", U'ε', ord, "epsilon"}, {"zeta", U'ζ'}, {"eta", U'η'}, {"theta", U'θ'},
    {"vartheta", U'ϑ', ord, "theta"}, {"iota", U'ι'}, {"kappa", U'κ'}, {"lambda", U'λ'}, {"mu", U'μ'}, {"nu", U'ν'},
    {"xi", U'ξ'}, {"omicron", U'ο'}, {"pi", U'π'}, {"varpi", U'ϖ', ord, "pi"}, {"rho", U'ρ'},
    {"varrho", U'ϱ', ord, "rho"}, {"sigma", U'σ'}, {"varsigma", U'ς', ord, "sigma"}, {"tau", U'τ'},
    {"upsilon", U'υ'}, {"phi", U'ϕ'}, {"varphi", U'φ', ord, "phi"}, {"chi", U'χ'}, {"psi", U'ψ'}, {"omega", U'ω'},
    {"Alpha", U'Α', ord, "capital alpha"}, {"Beta", U'Β', ord, "capital beta"},
    {"Gamma", U'Γ', ord, "capital gamma"}, {"Delta", U'Δ', ord, "capital delta"},
    {"Epsilon", U'Ε', ord, "capital epsilon"}, {"Zeta", U'Ζ', ord, "capital zeta"},
    {"Eta", U'Η', ord, "capital eta"}, {"Theta", U'Θ', ord, "capital theta"}, {"Iota", U'Ι', ord, "capital iota"},
    {"Kappa", U'Κ', ord, "capital kappa"}, {"Lambda", U'Λ', ord, "capital lambda"}, {"Mu", U'Μ', ord, "capital mu"},
    {"Nu", U'Ν', ord, "capital nu"}, {"Xi", U'Ξ', ord, "capital xi"}, {"Omicron", U'Ο', ord, "capital omicron"},
    {"Pi", U'Π', ord, "capital pi"}, {"Rho", U'Ρ', ord, "capital rho"}, {"Sigma", U'Σ', ord, "capital sigma"},
    {"Tau", U'Τ', ord, "capital tau"}, {"Upsilon", U'Υ', ord, "capital upsilon"}, {"Phi", U'Φ', ord, "capital phi"},
    {"Chi", U'Χ', ord, "capital chi"}, {"Psi", U'Ψ', ord, "capital psi"}, {"Omega", U'Ω', ord, "capital omega"},

    {"infty", U'∞', ord, "infinity"}, {"partial", U'∂'}, {"nabla", U'∇', ord, "nabla"}, {"hbar", U'ℏ', ord, "h bar"},
    {"hslash", U'ℏ', ord, "h bar"}, {"ell", U'ℓ', ord, "l"}, {"Re", U'ℜ', ord, "the real part of"},
    {"Im", U'ℑ', ord, "the imaginary part of"}, {"aleph", U'ℵ'}, {"wp", U'℘', ord, "p"},
    {"forall", U'∀', ord, "for all"}, {"exists", U'∃', ord, "there is"}, {"nexists", U'∄', ord, "there is no"},
    {"emptyset", U'∅', ord, "the empty set"}, {"varnothing", U'∅', ord, "the empty set"}, {"neg", U'¬', ord, "not"},
    {"lnot", U'¬', ord, "not"}, {"angle", U'∠', ord, "angle"}, {"triangle", U'△'}, {"square", U'□'},
    {"Box", U'□', ord, "box"}, {"top", U'⊤'}, {"bot", U'⊥', ord, "bottom"}, {"prime", U'′'},
    {"degree", U'°', ord, "degrees"}, {"circ", U'∘', bin, "composed with"}, {"imath", U'ı', ord, "i"},
    {"jmath", U'ȷ', ord, "j"}, {"backslash", U'\\', ord}, {"clubsuit", U'♣', ord, "clubs"},
    {"diamondsuit", U'♢', ord, "diamonds"}, {"heartsuit", U'♡', ord, "hearts"}, {"spadesuit", U'♠', ord, "spades"},
    {"flat", U'♭'}, {"natural", U'♮'}, {"sharp", U'♯'}, {"surd", U'√', ord, "root"}, {"AA", U'Å', ord, "angstrom"},
    {"%", U'%', ord, "percent"}, {"$", U'$', ord, "dollar"}, {"#", U'#', ord, "number"},
    {"&", U'&', ord, "and"}, {"_", U'_', ord, "underscore"}, {"P", U'¶', ord, "paragraph"},
    {"S", U'§', ord, "section"}, {"checkmark", U'✓', ord, "check mark"},
    {"bigstar", U'★', ord, "star"}, {"blacksquare", U'■', ord, "end of proof"},

    {"+", U'+', bin, "plus"}, {"-", U'−', bin, "minus"}, {"pm", U'±', bin, "plus or minus"},
    {"mp", U'∓', bin, "minus or plus"}, {"times", U'×', bin}, {"cdot", U'⋅', bin, "times"},
    {"centerdot", U'·', bin, "times"}, {"div", U'÷', bin, "divided by"}, {"ast", U'∗', bin, "star"}, {"star", U'⋆', bin},
    {"bullet", U'∙', bin}, {"oplus", U'⊕', bin, "circled plus"}, {"ominus", U'⊖', bin, "circled minus"},
    {"otimes", U'⊗', bin, "circled times"}, {"oslash", U'⊘', bin, "circled slash"}, {"odot", U'⊙', bin, "circled dot"},
    {"cap", U'∩', bin, "intersected with"}, {"cup", U'∪', bin, "united with"}, {"wedge", U'∧', bin, "and"},
    {"land", U'∧', bin, "and"}, {"vee", U'∨', bin, "or"}, {"lor", U'∨', bin, "or"}, {"setminus", U'∖', bin, "without"},
    {"sqcap", U'⊓', bin, "meet"}, {"sqcup", U'⊔', bin, "join"}, {"uplus", U'⊎', bin, "united with"},
    {"amalg", U'⨿', bin}, {"dagger", U'†', bin}, {"ddagger", U'‡', bin, "double dagger"}, {"wr", U'≀', bin, "wreath"},
    {"diamond", U'⋄', bin}, {"bigtriangleup", U'△', bin, "triangle"}, {"triangleleft", U'◁', bin, "triangle"},
    {"triangleright", U'▷', bin, "triangle"}, {"bigcirc", U'◯', bin, "circle"}, {"ltimes", U'⋉', bin, "semidirect"},
    {"rtimes", U'⋊', bin, "semidirect"},

    {"=", U'=', rel, "equals"}, {"lt", U'<', rel, "is less than"}, {"gt", U'>', rel, "is greater than"},
    {"le", U'≤', rel, "is at most"}, {"leq", U'≤', rel, "is at most"}, {"ge", U'≥', rel, "is at least"},
    {"geq", U'≥', rel, "is at least"}, {"leqslant", U'⩽', rel, "is at most"}, {"geqslant", U'⩾', rel, "is at least"},
    {"ll", U'≪', rel, "is much less than"}, {"gg", U'≫', rel, "is much greater than"},
    {"lesssim", U'≲', rel, "is less than about"}, {"gtrsim", U'≳', rel, "is greater than about"},
    {"ne", U'≠', rel, "is not equal to"}, {"neq", U'≠', rel, "is not equal to"}, {"equiv", U'≡', rel, "is identical to"},
    {"approx", U'≈', rel, "is about"}, {"sim", U'∼', rel, "is like"}, {"simeq", U'≃', rel, "is asymptotically equal to"},
    {"cong", U'≅', rel, "is congruent to"}, {"doteq", U'≐', rel, "approaches"}, {"asymp", U'≍', rel, "is asymptotic to"},
    {"propto", U'∝', rel, "is proportional to"}, {"triangleq", U'≜', rel, "is defined as"},
    {"coloneqq", U'≔', rel, "is defined as"}, {"in", U'∈', rel, "is in"}, {"ni", U'∋', rel, "contains"},
    {"notin", U'∉', rel, "is not in"}, {"subset", U'⊂', rel, "is a subset of"}, {"supset", U'⊃', rel, "is a superset of"},
    {"subseteq", U'⊆', rel, "is a subset of"}, {"supseteq", U'⊇', rel, "is a superset of"},
    {"subsetneq", U'⊊', rel, "is a proper subset of"}, {"sqsubseteq", U'⊑', rel, "is below"},
    {"sqsupseteq", U'⊒', rel, "is above"}, {"mid", U'∣', rel, "such that"}, {"nmid", U'∤', rel, "does not divide"},
    {"parallel", U'∥', rel, "is parallel to"}, {"perp", U'⟂', rel, "is perpendicular to"}, {"prec", U'≺', rel, "precedes"},
    {"succ", U'≻', rel, "succeeds"}, {"preceq", U'⪯', rel, "precedes or equals"},
    {"succeq", U'⪰', rel, "succeeds or equals"}, {"vdash", U'⊢', rel, "proves"}, {"dashv", U'⊣', rel, "is proved by"},
    {"models", U'⊨', rel, "models"}, {"bowtie", U'⋈', rel, "joined with"}, {"smile", U'⌣', rel}, {"frown", U'⌢', rel},
    {":", U':', rel, "to"}, {"therefore", U'∴', rel}, {"because", U'∵', rel},

    {"to", U'→', rel, "to"}, {"rightarrow", U'→', rel, "to"}, {"leftarrow", U'←', rel, "from"},
    {"gets", U'←', rel, "gets"}, {"leftrightarrow", U'↔', rel, "corresponds to"}, {"Rightarrow", U'⇒', rel, "implies"},
    {"Leftarrow", U'⇐', rel, "is implied by"}, {"Leftrightarrow", U'⇔', rel, "if and only if"},
    {"implies", U'⟹', rel, "implies"}, {"impliedby", U'⟸', rel, "is implied by"}, {"iff", U'⟺', rel, "if and only if"},
    {"longrightarrow", U'⟶', rel, "to"}, {"longleftarrow", U'⟵', rel, "from"},
    {"longleftrightarrow", U'⟷', rel, "corresponds to"}, {"Longrightarrow", U'⟹', rel, "implies"},
    {"Longleftarrow", U'⟸', rel, "is implied by"}, {"Longleftrightarrow", U'⟺', rel, "if and only if"},
    {"mapsto", U'↦', rel, "maps to"}, {"longmapsto", U'⟼', rel, "maps to"}, {"hookrightarrow", U'↪', rel, "embeds in"},
    {"hookleftarrow", U'↩', rel, "is embedded from"}, {"uparrow", U'↑', rel, "up"}, {"downarrow", U'↓', rel, "down"},
    {"updownarrow", U'↕', rel, "up and down"}, {"Uparrow", U'⇑', rel, "up"}, {"Downarrow", U'⇓', rel, "down"},
    {"nearrow", U'↗', rel, "up to the right"}, {"searrow", U'↘', rel, "down to the right"},
    {"swarrow", U'↙', rel, "down to the left"}, {"nwarrow", U'↖', rel, "up to the left"},
    {"rightleftharpoons", U'⇌', rel, "is in equilibrium with"}, {"rightharpoonup", U'⇀', rel, "to"},
    {"leftharpoonup", U'↼', rel, "from"}, {"leadsto", U'⇝', rel, "leads to"},

    {"sum", U'∑', op, "sum", style}, {"prod", U'∏', op, "product", style}, {"coprod", U'∐', op, "coproduct", style},
    {"int", U'∫', op, "integral", never}, {"iint", U'∬', op, "double integral", never},
    {"iiint", U'∭', op, "triple integral", never}, {"oint", U'∮', op, "contour integral", never},
    {"oiint", U'∯', op, "surface integral", never}, {"bigcup", U'⋃', op, "union", style},
    {"bigcap", U'⋂', op, "intersection", style}, {"bigoplus", U'⨁', op, "circled sum", style},
    {"bigotimes", U'⨂', op, "circled product", style}, {"bigodot", U'⨀', op, "circled dot", style},
    {"bigvee", U'⋁', op, "or", style}, {"bigwedge", U'⋀', op, "and", style}, {"bigsqcup", U'⨆', op, "join", style},

    {"ldots", U'…', Atom::inner, "and so on"}, {"dots", U'…', Atom::inner, "and so on"},
    {"dotsc", U'…', Atom::inner, "and so on"}, {"cdots", U'⋯', Atom::inner, "and so on"},
    {"dotsb", U'⋯', Atom::inner, "and so on"}, {"vdots", U'⋮', ord, "and so on"},
    {"ddots", U'⋱', Atom::inner, "and so on"}, {"colon", U':', punct, "to"}, {"cdotp", U'·', punct, "dot"},

    {"{", U'{', open, "open brace"}, {"}", U'}', close, "close brace"}, {"lbrace", U'{', open, "open brace"},
    {"rbrace", U'}', close, "close brace"}, {"lbrack", U'[', open, "open bracket"},
    {"rbrack", U']', close, "close bracket"}, {"lparen", U'(', open, "open parenthesis"},
    {"rparen", U')', close, "close parenthesis"}, {"langle", U'⟨', open, "open angle"},
    {"rangle", U'⟩', close, "close angle"}, {"lfloor", U'⌊', open, "the floor of"}, {"rfloor", U'⌋', close, "end floor"},
    {"lceil", U'⌈', open, "the ceiling of"}, {"rceil", U'⌉', close, "end ceiling"}, {"lvert", U'|', open, "bar"},
    {"rvert", U'|', close, "bar"}, {"lVert", U'‖', open, "double bar"}, {"rVert", U'‖', close, "double bar"},
    {"vert", U'|', ord, "bar"}, {"Vert", U'‖', ord, "double bar"}, {"|", U'‖', ord, "double bar"},

    // Signs of the keyboard, which need no name.
    {"", U'(', open, "open parenthesis"}, {"", U')', close, "close parenthesis"}, {"", U'[', open, "open bracket"},
    {"", U']', close, "close bracket"}, {"", U'|', ord, "bar"}, {"", U'/', ord, "over"}, {"", U',', punct, "comma"},
    {"", U';', punct, "semicolon"}, {"", U'.', ord, "point"}, {"", U'!', close, "factorial"},
    {"", U'?', close, "question mark"}, {"", U'@', ord, "at"}, {"", U'"', ord, "quote"}, {"", U'µ', ord, "micro"},
    {"", U'‰', ord, "per mille"}, {"", U'″', ord, "double prime"}, {"", U'‴', ord, "triple prime"},
    {"", U'∆', ord, "capital delta"}, {"", U'⊥', rel, "is perpendicular to"}, {"", U'≝', rel, "is defined as"},
};

constexpr Function functions[] = {
    {"sin", "sin", "sine"}, {"cos", "cos", "cosine"}, {"tan", "tan", "tangent"}, {"cot", "cot", "cotangent"},
    {"sec", "sec", "secant"}, {"csc", "csc", "cosecant"}, {"arcsin", "arcsin", "arc sine"},
    {"arccos", "arccos", "arc cosine"}, {"arctan", "arctan", "arc tangent"}, {"sinh", "sinh", "hyperbolic sine"},
    {"cosh", "cosh", "hyperbolic cosine"}, {"tanh", "tanh", "hyperbolic tangent"},
    {"coth", "coth", "hyperbolic cotangent"}, {"exp", "exp", "exponential"}, {"ln", "ln", "natural log"},
    {"log", "log", "log"}, {"lg", "lg", "log"}, {"arg", "arg", "argument"}, {"deg", "deg", "degree"},
    {"dim", "dim", "dimension"}, {"hom", "hom", "hom"}, {"ker", "ker", "kernel"}, {"det", "det", "determinant", true},
    {"gcd", "gcd", "greatest common divisor", true}, {"lim", "lim", "limit", true},
    {"liminf", "lim inf", "limit inferior", true}, {"limsup", "lim sup", "limit superior", true},
    {"max", "max", "maximum", true}, {"min", "min", "minimum", true}, {"sup", "sup", "supremum", true},
    {"inf", "inf", "infimum", true}, {"Pr", "Pr", "probability", true}, {"bmod", "mod", "modulo"},
};

struct Accent {
    std::string_view name;
    char32_t code;
    std::string_view spoken;
};
constexpr Accent accents[] = {
    {"dot", 0x307, "dot"}, {"ddot", 0x308, "double dot"}, {"dddot", 0x20DB, "triple dot"}, {"hat", 0x302, "hat"},
    {"widehat", 0x302, "hat"}, {"vec", 0x20D7, "vector"}, {"bar", 0x304, "bar"}, {"tilde", 0x303, "tilde"},
    {"widetilde", 0x303, "tilde"}, {"acute", 0x301, "acute"}, {"grave", 0x300, "grave"}, {"check", 0x30C, "check"},
    {"breve", 0x306, "breve"}, {"mathring", 0x30A, "ring"},
};

// Those of the reader itself, for suggestions.
constexpr std::string_view structures[] = {
    "frac", "dfrac", "tfrac", "cfrac", "binom", "dbinom", "tbinom", "sqrt", "mathbf", "mathrm", "mathit", "mathbb",
    "mathcal", "mathscr", "mathfrak", "mathsf", "mathtt", "mathnormal", "boldsymbol", "bm", "text", "textrm", "textbf",
    "textit", "mbox", "operatorname", "left", "right", "middle", "big", "Big", "bigg", "Bigg", "bigl", "bigr", "Bigl",
    "Bigr", "overline", "underline", "overbrace", "underbrace", "overset", "underset", "stackrel", "begin", "end",
    "displaystyle", "textstyle", "scriptstyle", "scriptscriptstyle", "limits", "nolimits", "quad", "qquad", "not",
    "overrightarrow", "overleftarrow", "xrightarrow", "xleftarrow", "phantom", "hphantom", "vphantom", "substack",
    "pmod", "cr", "thinspace", "medspace", "thickspace", "mathop", "mathbin", "mathrel", "mathord", "mathopen",
    "mathclose", "mathpunct", "mathinner",
};

constexpr std::array<std::array<char32_t, 2>, 24> negations{{
    {U'=', U'≠'}, {U'<', U'≮'}, {U'>', U'≯'}, {U'≤', U'≰'}, {U'≥', U'≱'}, {U'∈', U'∉'}, {U'∋', U'∌'}, {U'≡', U'≢'},
    {U'≈', U'≉'}, {U'∼', U'≁'}, {U'≃', U'≄'}, {U'≅', U'≇'}, {U'⊂', U'⊄'}, {U'⊃', U'⊅'}, {U'⊆', U'⊈'}, {U'⊇', U'⊉'},
    {U'∣', U'∤'}, {U'∥', U'∦'}, {U'∃', U'∄'}, {U'→', U'↛'}, {U'←', U'↚'}, {U'⇒', U'⇏'}, {U'≺', U'⊀'}, {U'≻', U'⊁'},
}};

constexpr std::array<std::array<char32_t, 3>, 16> scripts{{ // itself, raised, lowered
    {U'0', U'⁰', U'₀'}, {U'1', U'¹', U'₁'}, {U'2', U'²', U'₂'}, {U'3', U'³', U'₃'}, {U'4', U'⁴', U'₄'},
    {U'5', U'⁵', U'₅'}, {U'6', U'⁶', U'₆'}, {U'7', U'⁷', U'₇'}, {U'8', U'⁸', U'₈'}, {U'9', U'⁹', U'₉'},
    {U'+', U'⁺', U'₊'}, {U'−', U'⁻', U'₋'}, {U'(', U'⁽', U'₍'}, {U')', U'⁾', U'₎'}, {U'n', U'ⁿ', U'ₙ'},
    {U'i', U'ⁱ', U'ᵢ'},
}};
// clang-format on

char32_t script(char32_t code, std::size_t from, std::size_t to) {
    for (const auto& row : scripts)
        if (row[from] == code)
            return row[to];
    return 0;
}

// The number of letters to change, or 3 for more.
int distance(std::string_view a, std::string_view b) {
    if (a.size() > b.size() + 2 || b.size() > a.size() + 2)
        return 3;
    std::vector<int> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = static_cast<int>(j);
    for (std::size_t i = 1; i <= a.size(); ++i) {
        int diagonal = row[0];
        row[0] = static_cast<int>(i);
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const int change = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
            diagonal = row[j];
            row[j] = std::min({change, row[j] + 1, row[j - 1] + 1});
        }
    }
    return std::min(row[b.size()], 3);
}

} // namespace

const Symbol* symbolNamed(std::string_view name) {
    static const auto names = [] {
        std::unordered_map<std::string_view, const Symbol*> map;
        for (const Symbol& symbol : symbols)
            if (!symbol.name.empty())
                map.emplace(symbol.name, &symbol);
        return map;
    }();
    const auto found = names.find(name);
    return found == names.end() ? nullptr : found->second;
}

const Symbol* symbolOf(char32_t code) {
    static const auto codes = [] {
        std::unordered_map<char32_t, const Symbol*> map;
        for (const Symbol& symbol : symbols) // a sign of the keyboard counts before a name of it
            if (symbol.name.empty())
                map.emplace(symbol.code, &symbol);
        for (const Symbol& symbol : symbols)
            map.emplace(symbol.code, &symbol);
        return map;
    }();
    const auto found = codes.find(code);
    return found == codes.end() ? nullptr : found->second;
}

const Function* functionNamed(std::string_view name) {
    const auto* found = std::ranges::find(functions, name, &Function::name);
    return found == std::end(functions) ? nullptr : found;
}

char32_t accentNamed(std::string_view name) {
    const auto* found = std::ranges::find(accents, name, &Accent::name);
    return found == std::end(accents) ? 0 : found->code;
}

std::string_view spokenAccent(char32_t code) {
    const auto* found = std::ranges::find(accents, code, &Accent::code);
    return found == std::end(accents) ? std::string_view{} : found->spoken;
}

char32_t delimiterNamed(std::string_view token) {
    if (token == "." || token == "(" || token == ")" || token == "[" || token == "]" ||
        token == "|" || token == "/")
        return static_cast<unsigned char>(token.front());
    if (token == "<")
        return U'⟨';
    if (token == ">")
        return U'⟩';
    const Symbol* symbol = nullptr;
    if (token.size() > 1 && token.front() == '\\')
        symbol = symbolNamed(token.substr(1));
    else if (token.size() > 1)
        symbol = symbolOf(text::codePoint(token));
    if (symbol == nullptr)
        return 0;
    constexpr std::u32string_view known = U"{}[]()|‖⟨⟩⌊⌋⌈⌉↑↓↕⇑⇓\\";
    return known.find(symbol->code) != std::u32string_view::npos ? symbol->code : 0;
}

char32_t negated(char32_t code) {
    for (const auto& row : negations)
        if (row[0] == code)
            return row[1];
    return 0;
}

std::string_view alike(std::string_view name) {
    std::string_view best;
    int least = name.size() < 4 ? 2 : 3; // two letters may be wrong, of a short name one
    const auto look = [&](std::string_view other) {
        const int far = other.empty() || other.size() < 2 ? 3 : distance(name, other);
        if (far < least) {
            least = far;
            best = other;
        }
    };
    std::ranges::for_each(structures, look);
    std::ranges::for_each(functions, look, &Function::name);
    std::ranges::for_each(accents, look, &Accent::name);
    std::ranges::for_each(symbols, look, &Symbol::name);
    return best;
}

char32_t raisedBy(char32_t code) { return code < 0x80 ? 0 : script(code, 1, 0); }
char32_t loweredBy(char32_t code) { return code < 0x80 ? 0 : script(code, 2, 0); }
char32_t raised(char32_t code) { return script(code, 0, 1); }
char32_t lowered(char32_t code) { return script(code, 0, 2); }

void append(std::string& text, char32_t code) {
    const auto put = [&text](char32_t byte) { text += static_cast<char>(byte); };
    if (code < 0x80) {
        put(code);
    } else if (code < 0x800) {
        put(0xC0 | code >> 6);
        put(0x80 | (code & 0x3F));
    } else if (code < 0x10000) {
        put(0xE0 | code >> 12);
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    } else {
        put(0xF0 | code >> 18);
        put(0x80 | (code >> 12 & 0x3F));
        put(0x80 | (code >> 6 & 0x3F));
        put(0x80 | (code & 0x3F));
    }
}

} // namespace formulas
