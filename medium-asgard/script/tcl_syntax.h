// Tcl's twelve rules as a walk over text; structure.h is what others use.
#pragma once

#include "script/structure.h"

namespace script {

class SyntaxWalker {
public:
    explicit SyntaxWalker(std::string_view text) : text_(text), end_(text.size()) {}
    Structure run();

private:
    // Each returns the position after what it read; `failed_` stops the walk of a script.
    std::size_t script(std::size_t from, std::size_t end, bool bracketed, int parent);
    std::size_t command(std::size_t from, bool bracketed, int parent);
    std::size_t comment(std::size_t from);
    std::size_t word(std::size_t from, bool bracketed, int owner, Word& word);
    void append(Command& command, const Word& word) const;
    std::size_t braces(std::size_t from, Word& word);
    std::size_t character(std::size_t at, int owner, Word& word);
    std::size_t quotes(std::size_t from, int owner, Word& word);
    std::size_t bare(std::size_t from, bool bracketed, int owner, Word& word);
    std::size_t substitution(std::size_t from, int owner); // at $, [ or backslash
    std::size_t variable(std::size_t from, int owner);
    void nested(int owner); // the scripts among a command's words
    void nestedScript(const Word& word, int owner);
    void nestedExpression(const Word& word, int owner);
    void nestedByPlace(const Command& command, int owner);
    void nestedIf(const std::vector<Word>& words, int owner);
    void nestedTry(const std::vector<Word>& words, int owner);
    void nestedSwitch(const std::vector<Word>& words, int owner);
    [[nodiscard]] std::string_view contentOf(const Word& word) const;
    void fail(std::size_t from, std::size_t to, std::string message);

    [[nodiscard]] bool ends(std::size_t at, bool bracketed) const; // a command ends here
    [[nodiscard]] bool blankAt(std::size_t at) const; // blanks between words, \newline among them
    [[nodiscard]] std::size_t skipBlanks(std::size_t at) const;

    std::string_view text_;
    std::size_t end_; // of the script that is read now
    int depth_ = 0;
    bool failed_ = false;
    Structure structure_;
};

} // namespace script
