// Every expression of a scene, parsed, its names known: what is wrong is shown at its own bytes.
#include "script/scene_maker.h"

#include "expression/chained_comparison.h"
#include "expression/parse.h"
#include "scene/names.h"

namespace script {

void SceneMaker::checkExpressions() {
    const scene::Names names(made_.scene);
    for (const PendingExpression& pending : expressions_) {
        const expression::Names meaning = [&](expression::Graph& graph, std::string_view name,
                                              std::span<const expression::Node> arguments,
                                              bool isCall) {
            const scene::Named found = names.find(
                name, isCall ? std::optional(arguments.size()) : std::nullopt, pending.reading);
            expression::Meaning answer;
            if (const auto* fault = std::get_if<scene::NameFault>(&found)) {
                answer.message = fault->message;
                answer.suggestion = fault->suggestion;
            } else {
                if (const auto* body = std::get_if<scene::BodyName>(&found))
                    if (scene::isTurn(body->quantity))
                        made_.scene.bodies[body->body].countsTurns = true;
                answer.node = graph.symbol(name);
            }
            return answer;
        };
        expression::Graph graph; // of its own: one bad expression must not fill the others' memory
        const auto parsed = expression::parse(graph, pending.value.text, meaning);
        if (const auto* error = std::get_if<expression::SyntaxError>(&parsed))
            faults_.error(pending.value.piece(error->from, error->to).range,
                          pending.subject + ": " + error->message, error->suggestion);
        else if (const auto doubt = expression::chainedComparison(pending.value.text))
            faults_.warning(pending.value.piece(doubt->from, doubt->to).range,
                            pending.subject + ": " + doubt->message, doubt->suggestion);
    }
}

} // namespace script
