#include "element_edits/fixing.h"

namespace editing {

Answer withBounce(const Properties& properties, const scene::Scene& scene,
                  const std::vector<Element>& bodies, bool fixed, Answer answer) {
    if (!answer.possible() || answer.edits.empty())
        return answer;
    for (const Element& element : bodies) {
        if (element.kind != Kind::body)
            continue;
        const scene::Body& body = scene.bodies[element.index];
        const OptionHint& bounce = *hintOf(hintOf(scene, element), "-restitution");
        const bool isWritten = properties.valueOf(element, bounce).isWritten;
        const bool deadens = fixed && !body.fixed && isWritten && body.restitution == 0;
        const bool isToRest = !fixed && body.fixed && !isWritten && body.friction > 0;
        if (!deadens && !isToRest)
            continue;
        const Answer change = properties.set({element}, bounce, {deadens ? "" : "0"});
        text::Edits both = answer.edits;
        bool fits = change.possible();
        for (const text::Edit& edit : change.edits)
            fits = fits && text::join(both, edit);
        if (fits)
            answer.edits = std::move(both);
    }
    text::putInOrder(answer.edits);
    return answer;
}

} // namespace editing
