// The faults in the formulas of a document. Each source is read once, however often it is asked.
#pragma once

#include "formulas/typeset.h"
#include "sgml/tree.h"

#include <map>

namespace session {

class FormulaFaults {
public:
    // Of the formula that an element's content is: an error for what cannot be read, a warning for
    // a letter that the font has not. With ranges of the document's bytes, and without positions.
    // Without any font the first formula has a warning that says so.
    void add(const sgml::Tree& tree, sgml::NodeId content, std::vector<sgml::Fault>& to);

    // The values that a source asks for.
    [[nodiscard]] const std::vector<formulas::ValueCall>& valuesIn(const std::string& source) {
        return known(source).values;
    }

private:
    struct Known {
        std::vector<formulas::Fault> errors, warnings;
        std::vector<formulas::ValueCall> values;
    };
    static constexpr std::size_t mostKnown = 10'000;
    [[nodiscard]] const Known& known(const std::string& source);

    std::map<std::string, Known, std::less<>> known_;
};

} // namespace session
