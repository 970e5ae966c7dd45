// From source to tree, by recursive descent of bounded depth.
//
// A token that ends a list other than the one being read (`}`, `&`, `\\`, `\right`, `\end`) ends
// all lists up to the one that waits for it; where none waits, it is a fault and is left out. So
// each byte is read once, whatever is missing.
#pragma once

#include "formulas/symbols.h"

#include <unordered_map>

namespace formulas {

struct Token {
    std::string_view text; // empty: the end; a command has its backslash
    std::size_t offset = 0;
    [[nodiscard]] std::size_t end() const { return offset + text.size(); }
    [[nodiscard]] bool isCommand() const { return text.size() > 1 && text.front() == '\\'; }
    [[nodiscard]] std::string_view name() const { return text.substr(isCommand() ? 1 : 0); }
    [[nodiscard]] bool endsRow() const { return text == "\\\\" || text == "\\cr"; }
};

class Reader {
public:
    explicit Reader(std::string_view source, const ValueSupply& supply = {});
    Formula take();

private:
    using Handler = NodeId (Reader::*)(const Token&);
    struct Waiting { // how many wait for what ends a list
        int braces = 0, fences = 0, cells = 0, environments = 0;
        bool bracket = false;
    };
    struct Script { // what the scripts that are read now belong to
        NodeId node = none;
        bool primes = false; // the superscript has only primes so far
    };

    [[nodiscard]] Token peek();
    Token next();
    void fault(std::size_t offset, std::size_t end, std::string message);
    void fault(const Token& token, std::string message);
    NodeId add(Kind kind, const Token& from);
    NodeId finish(NodeId id); // ends where reading is
    NodeId symbol(const Token& from, char32_t letter, Atom atom);
    NodeId space(const Token& from, double amount);
    NodeId missingPart(const Token& from);

    [[nodiscard]] bool stopped();
    NodeId list();
    void readInto(NodeId list);
    void readList(NodeId list);
    NodeId unwrapped(NodeId list) const;
    NodeId item();
    NodeId group(const Token& open);
    NodeId character(const Token& token);
    NodeId command(const Token& token);
    NodeId unknown(const Token& token);
    NodeId argument(const Token& command, int index, int count);
    std::string_view raw(const Token& command, bool& there); // what is in braces, as written
    NodeId delimited(char32_t open, NodeId part, char32_t close, const Token& from);
    char32_t delimiter(const Token& command);

    [[nodiscard]] bool isScript(const Token& token) const;
    void script(NodeId list, Script& current);
    void attach(NodeId list, Script& current, bool above, NodeId part, const Token& at);
    void raisedSigns(NodeId list, Script& current);
    NodeId scriptsFor(NodeId list, Script& current, const Token& at);
    void setLimits(NodeId list, const Token& token);

    static const std::unordered_map<std::string_view, Handler>& handlers();
    NodeId fraction(const Token& token);
    NodeId root(const Token& token);
    NodeId alphabet(const Token& token);
    NodeId switchAlphabet(const Token& token);
    NodeId words(const Token& token);
    NodeId operatorName(const Token& token);
    NodeId fence(const Token& token);
    NodeId bigDelimiter(const Token& token);
    NodeId bar(const Token& token);
    NodeId stretch(const Token& token);
    NodeId arrow(const Token& token);
    NodeId stacked(const Token& token);
    NodeId styleSwitch(const Token& token);
    NodeId namedSpace(const Token& token);
    NodeId phantom(const Token& token);
    NodeId substack(const Token& token);
    NodeId negation(const Token& token);
    NodeId classed(const Token& token);
    NodeId modulo(const Token& token);
    NodeId function(const Token& token);
    NodeId accent(const Token& token);
    NodeId value(const Token& token);
    NodeId grafted(const SuppliedValue& supplied, const Token& from);
    NodeId grafted(const std::string& source, bool isFaulty, const Token& from);
    NodeId environment(const Token& token);
    NodeId array(const Token& token, ArrayForm form, std::string columns);
    void skipRowSpace();
    std::string columnsOf(const Token& token);

    ValueSupply supply_;
    Formula formula_;
    std::string repaired_; // the source, where it had to be made UTF-8
    std::string_view source_;
    std::size_t at_ = 0;
    int depth_ = 0;
    bool cut_ = false; // the rest is left out: a part missing there is no fault
    Waiting waiting_;
    Alphabet alphabet_ = Alphabet::normal;
};

} // namespace formulas
