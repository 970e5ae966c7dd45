#include "session/formula_faults.h"

#include <algorithm>

namespace session {

namespace {

sgml::Fault faultAt(text::Range range, const std::string& message, sgml::Severity severity) {
    sgml::Fault fault;
    fault.severity = severity;
    fault.range = range;
    fault.message = message;
    return fault;
}

} // namespace

const FormulaFaults::Known& FormulaFaults::known(const std::string& source) {
    if (known_.size() >= mostKnown)
        known_.clear();
    const auto [place, isNew] = known_.try_emplace(source);
    if (isNew) {
        formulas::Formula formula = formulas::read(source);
        if (const auto& font = formulas::Font::standard())
            place->second.warnings =
                formulas::typeset(formula, formulas::Style::text, 1, *font).faults;
        place->second.errors = std::move(formula.faults);
        place->second.values = std::move(formula.values);
    }
    return place->second;
}

void FormulaFaults::add(const sgml::Tree& tree, sgml::NodeId content,
                        std::vector<sgml::Fault>& to) {
    const sgml::Unescaped spelling = tree.unescaped(content);
    const auto put = [&](const formulas::Fault& fault, sgml::Severity severity) {
        const text::Range range{spelling.fileOffset(fault.offset), spelling.fileOffset(fault.end)};
        to.push_back(faultAt(range, fault.message, severity));
    };
    if (to.empty() && !formulas::Font::standard())
        put({0, 0, formulas::Font::missing().toStdString()}, sgml::Severity::warning);
    const Known& of = known(spelling.text());
    for (const formulas::Fault& fault : of.errors)
        put(fault, sgml::Severity::error);
    for (const formulas::Fault& fault : of.warnings)
        put(fault, sgml::Severity::warning);
}

} // namespace session
