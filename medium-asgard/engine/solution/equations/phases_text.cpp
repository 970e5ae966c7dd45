#include "equations/phases_text.h"

#include "expression/kernel.h"

#include <charconv>
#include <sstream>

namespace solution {
namespace {

using expression::Function;
using expression::Kernel;
using expression::Purpose;

std::string numberText(double value) {
    std::array<char, 32> buffer{};
    return {buffer.data(), std::to_chars(buffer.data(), buffer.data() + 32, value).ptr};
}

// Its lines, moved to the right under their heading; "" when there are none.
std::string under(const std::string& heading, const std::string& lines) {
    if (lines.empty())
        return "";
    std::string text = heading + ":\n";
    std::istringstream in(lines);
    for (std::string line; std::getline(in, line);)
        text += "    " + line + "\n";
    return text;
}

// What the letters of the model stand for here, and where a tape has them.
std::string namesText(const expression::EquationSet& set, std::span<const std::size_t> unknowns,
                      const BoundModel& bound) {
    std::string text = "t is the time, in0\n";
    std::size_t in = 0;
    const auto line = [&](const char* letter, std::size_t i, const std::string& is) {
        text += letter + std::to_string(i) + " is " + is +
                (*letter == 'h' ? "\n" : ", in" + std::to_string(++in) + "\n");
    };
    for (std::size_t i = 0; i < bound.states.size(); ++i)
        line("y", i, set.unknowns[unknowns[bound.states[i]]].name);
    for (std::size_t i = 0; i < bound.held.size(); ++i)
        line("h", i, set.unknowns[unknowns[bound.held[i]]].name);
    for (std::size_t i = 0; i < bound.inputs.size(); ++i)
        line("u", i, set.unknowns[bound.inputs[i]].name);
    for (std::size_t i = 0; i < bound.constants.size(); ++i)
        line("c", i, numberText(bound.constants[i]));
    return text;
}

std::string codeText(const std::string& what, const Function& function) {
    const auto kernel = Kernel::of(function.tape().sequence());
    const std::string lanes = std::to_string(Function::lanes());
    return under("Tape of " + what, function.tape().print()) +
           under("Machine code of " + what, kernel->listing(Purpose::values, Kernel::Width::one)) +
           (Function::lanes() > 1
                ? under("Machine code of " + what + ", " + lanes + " alike at once",
                        kernel->listing(Purpose::values, Kernel::Width::many))
                : "");
}

} // namespace

std::string phasesText(const expression::EquationSet& set, std::span<const std::size_t> unknowns,
                       const BoundModel& bound) {
    if (!bound.model)
        return "It is held by values that depend on each other in a circle.\n";
    const ComponentModel& model = *bound.model;
    std::string text = under("Names", namesText(set, unknowns, bound)) +
                       under("Equations", model.print()) +
                       under("Graph", expression::printNodes(model.graph(), model.outputs())) +
                       codeText("the equations", model.function());
    const std::string derivatives = model.printJacobian();
    if (!derivatives.empty())
        text += under("Derivatives", derivatives) +
                codeText("the derivatives", model.jacobian().entries.function);
    return text;
}

} // namespace solution
