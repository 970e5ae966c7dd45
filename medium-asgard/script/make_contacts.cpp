// contact.
#include "script/scene_maker.h"

#include "scene/contact_pairs.h"

namespace script {

using scene::Contact;

void SceneMaker::contact(Call& call) {
    Contact contact;
    std::size_t first = 1;
    contact.name = optionalName(call, Kind::contact, first);
    Arguments arguments(faults_, call,
                        contact.name.empty() ? "the contact" : "contact " + quoted(contact.name),
                        first,
                        {"-body1", "-body2", "-friction", "-static_friction", "-rolling_friction",
                         "-restitution", "-collide"});
    if (!arguments.attempted("-body1") || !arguments.attempted("-body2"))
        arguments.wrongElement("wants -body1 and -body2, the two bodies that touch");
    contact.body1 = reference(arguments, "-body1", Kind::body).value_or("");
    contact.body2 = reference(arguments, "-body2", Kind::body).value_or("");
    contact.friction = arguments.number("-friction", Sign::notNegative);
    contact.staticFriction = arguments.number("-static_friction", Sign::notNegative);
    contact.rollingFriction = arguments.number("-rolling_friction", Sign::notNegative);
    contact.restitution = arguments.number("-restitution", Sign::unit);
    contact.collides = arguments.flag("-collide");
    contact.source = call.source;
    checkContact(arguments, contact);
    made_.scene.contacts.push_back(std::move(contact));
}

void SceneMaker::checkContact(Arguments& arguments, const Contact& contact) {
    const scene::Body* first = scene::findBody(made_.scene, contact.body1);
    const scene::Body* second = scene::findBody(made_.scene, contact.body2);
    if (!first || !second)
        return;
    if (first == second)
        arguments.wrong("-body2", arguments.find("-body2")->range, "another body",
                        "not " + quoted(contact.body2) + " again");
    else if (first->fixed && second->fixed)
        arguments.wrongElement("is between bodies of which none moves");
    else if (const Contact* other = scene::findContact(made_.scene, contact.body1, contact.body2))
        arguments.wrongElement(
            "is one of " + quoted(contact.body1) + " and " + quoted(contact.body2) +
            ", which have one already" +
            (other->source.line > 0 ? ", at line " + std::to_string(other->source.line) : ""));
    const auto indexOf = [&](const scene::Body* body) {
        return static_cast<std::size_t>(body - made_.scene.bodies.data());
    };
    const scene::PairLaw ofBodies =
        scene::ContactPairs(made_.scene).lawOf(indexOf(first), indexOf(second));
    const double sliding = contact.friction.value_or(ofBodies.sliding);
    if (contact.staticFriction && *contact.staticFriction < sliding)
        faults_.error(arguments.optionRange("-static_friction"),
                      "-static_friction of " + arguments.subject() + " is less than " +
                          (contact.friction ? "its -friction" : "the -friction of its bodies"));
}

} // namespace script
