#include "element_edits/deletion.h"

#include "editing/lines.h"

#include "expression/tokens.h"
#include "scene/names.h"

#include <algorithm>

namespace editing {

using script::Command;
using script::Structure;

namespace {

// Whether an expression reads a body ("b.x"), a joint, a trajectory or a parameter of that name.
bool reads(const std::string& expression, const std::string& name) {
    expression::Tokens tokens(expression);
    bool afterPoint = false;
    for (; tokens.now().kind != expression::TokenKind::end && !tokens.fault(); tokens.advance()) {
        if (tokens.now().kind == expression::TokenKind::name && !afterPoint) {
            const std::string found(tokens.now().text);
            if (found == name || found.starts_with(name + "."))
                return true;
        }
        afterPoint = tokens.now().text == ".";
    }
    return false;
}

bool names(const std::optional<scene::VectorValue>& value, const std::string& trajectory) {
    const auto* named = value ? std::get_if<std::string>(&*value) : nullptr;
    return named && *named == trajectory;
}

class Users {
public:
    Users(const scene::Scene& scene, const Element& element)
        : scene_(scene), element_(element), name_(nameOf(scene, element)) {}
    std::vector<Element> all();

private:
    void add(Kind kind, std::size_t index) {
        const Element user{kind, index};
        if (std::ranges::find(users_, user) == users_.end())
            users_.push_back(user);
    }
    void ofBody();
    void ofJoint();
    void ofTrajectory();
    void byExpression();

    const scene::Scene& scene_;
    Element element_;
    std::string name_;
    std::vector<Element> users_;
};

void Users::ofBody() {
    for (std::size_t i = 0; i < scene_.forces.size(); ++i)
        if (scene_.forces[i].body == name_)
            add(Kind::force, i);
    for (std::size_t i = 0; i < scene_.links.size(); ++i) {
        const auto* second = std::get_if<scene::BodyEnd>(&scene_.links[i].second);
        if (scene_.links[i].first.body == name_ || (second && second->body == name_))
            add(Kind::link, i);
    }
    for (std::size_t i = 0; i < scene_.joints.size(); ++i)
        if (scene_.joints[i].body1 == name_ || scene_.joints[i].body2 == name_)
            add(Kind::joint, i);
    for (std::size_t i = 0; i < scene_.ropes.size(); ++i)
        if (std::ranges::find(scene_.ropes[i].points, name_, &scene::Rope::Point::body) !=
            scene_.ropes[i].points.end())
            add(Kind::rope, i);
    for (std::size_t i = 0; i < scene_.contacts.size(); ++i)
        if (scene_.contacts[i].body1 == name_ || scene_.contacts[i].body2 == name_)
            add(Kind::contact, i);
    for (std::size_t i = 0; i < scene_.constraints.size(); ++i)
        if (scene_.constraints[i].body == name_)
            add(Kind::constraint, i);
}

void Users::ofJoint() {
    for (std::size_t i = 0; i < scene_.gears.size(); ++i)
        if (std::ranges::find(scene_.gears[i].terms, name_, &scene::Gear::Term::joint) !=
            scene_.gears[i].terms.end())
            add(Kind::gear, i);
}

void Users::ofTrajectory() {
    for (std::size_t i = 0; i < scene_.forces.size(); ++i)
        if (const auto* force = std::get_if<scene::TrajectoryForce>(&scene_.forces[i].kind);
            force && force->trajectory == name_)
            add(Kind::force, i);
    for (std::size_t i = 0; i < scene_.links.size(); ++i)
        if (const auto* end = std::get_if<scene::TrajectoryEnd>(&scene_.links[i].second);
            end && end->trajectory == name_)
            add(Kind::link, i);
    for (std::size_t i = 0; i < scene_.constraints.size(); ++i)
        if (scene_.constraints[i].trajectory == name_)
            add(Kind::constraint, i);
    for (std::size_t i = 0; i < scene_.views.size(); ++i) {
        const scene::View& view = scene_.views[i];
        for (const auto* value :
             {&view.position, &view.rotation, &view.center, &view.eye, &view.look, &view.up})
            if (names(*value, name_))
                add(Kind::view, i);
    }
}

void Users::byExpression() {
    for (const scene::ExpressionPlace& place : scene::expressionsOf(scene_))
        if (reads(*place.text, name_))
            for (const Kind kind : {Kind::force, Kind::link, Kind::joint, Kind::gear, Kind::rope,
                                    Kind::view, Kind::plot})
                for (std::size_t i = 0; sourceOf(scene_, {kind, i}); ++i)
                    if (sourceOf(scene_, {kind, i}) == place.source)
                        add(kind, i);
}

std::vector<Element> Users::all() {
    if (name_.empty())
        return {};
    switch (element_.kind) {
    case Kind::shapeSet:
        for (std::size_t i = 0; i < scene_.bodies.size(); ++i)
            if (scene_.bodies[i].shape == name_)
                add(Kind::body, i);
        return users_;
    case Kind::body:
        ofBody();
        break;
    case Kind::joint:
        ofJoint();
        break;
    case Kind::trajectory:
        ofTrajectory();
        break;
    case Kind::parameter:
    case Kind::link: // a spring with a name
        break;
    default:
        return users_;
    }
    byExpression();
    return users_;
}

// Where the text reads $name; none: nowhere.
const Command* readerOf(const std::string& text, const Structure& structure,
                        const std::string& name, std::size_t& offset) {
    for (const std::string& form : {"$" + name, "${" + name + "}"})
        for (std::size_t at = text.find(form); at != std::string::npos;
             at = text.find(form, at + 1)) {
            const std::size_t end = at + form.size();
            const bool goesOn = form[1] != '{' && end < text.size() &&
                                (std::isalnum(static_cast<unsigned char>(text[end])) != 0 ||
                                 text[end] == '_' || text[end] == ':' || text[end] == '(');
            if (const Command* command = goesOn ? nullptr : structure.at(at)) {
                offset = at;
                return command;
            }
        }
    return nullptr;
}

int lineOf(const std::string& text, std::size_t offset) {
    return 1 + static_cast<int>(std::count(
                   text.begin(), text.begin() + static_cast<std::ptrdiff_t>(offset), '\n'));
}

// The begin of the empty line that ends there; none: there is no such line.
std::optional<std::size_t> emptyLineBefore(std::string_view text, std::size_t end) {
    if (end == 0 || text[end - 1] != '\n')
        return std::nullopt;
    const std::size_t from = end > 1 && text[end - 2] == '\r' ? end - 2 : end - 1;
    const bool isEmpty = from == 0 || text[from - 1] == '\n';
    return isEmpty && !isContinued(text, from == 0 ? 0 : from - 1) ? std::optional(from)
                                                                   : std::nullopt;
}

// A group of lines that goes as a whole takes the empty line with it by which it was set off
// (creation.cpp); what remains between two others is one.
std::vector<scene::Range> withEmptyLines(std::string_view text, std::vector<scene::Range> ranges) {
    std::ranges::sort(ranges, {}, &scene::Range::from);
    std::vector<scene::Range> groups;
    for (const scene::Range& range : ranges)
        if (!groups.empty() && groups.back().to == range.from)
            groups.back().to = range.to;
        else
            groups.push_back(range);
    for (scene::Range& group : groups) {
        const bool isWholeLines = group.to == text.size() || text[group.to - 1] == '\n';
        const std::string_view rest = text.substr(group.to);
        const bool endsGroup = rest.empty() || rest.starts_with('\n') || rest.starts_with("\r\n");
        const auto empty = emptyLineBefore(text, group.from);
        if (isWholeLines && endsGroup && empty)
            group.from = *empty;
    }
    return groups;
}

} // namespace

std::vector<Element> dependents(const scene::Scene& scene, const Element& element) {
    return Users(scene, element).all();
}

Deletion deletionOf(const std::string& text, const scene::Scene& scene,
                    const std::vector<Element>& elements) {
    Deletion deletion;
    const Structure structure = script::structureOf(text);
    std::vector<Element> all = elements;
    std::vector<scene::Range> ranges;
    const auto refuse = [&](const Element& element, const std::string& why, scene::Range cause) {
        const bool itself = std::ranges::find(elements, element) != elements.end();
        Deletion refused;
        refused.reason =
            describe(scene, element) + " " + (itself ? "" : "would have to go too, and ") + why;
        refused.reason[0] = static_cast<char>(std::toupper(refused.reason[0]));
        refused.cause = cause;
        return refused;
    };
    for (std::size_t i = 0; i < all.size(); ++i) {
        const Element element = all[i];
        const scene::Source* source = sourceOf(scene, element);
        if (!source)
            return refuse(element, "is not in the scene.", {});
        const Command* command =
            source->command.known() ? structure.startingAt(source->command.from) : nullptr;
        if (!command)
            return refuse(element,
                          "does not stand in the text: the command of line " +
                              std::to_string(source->line) + " makes it of other text.",
                          source->command);
        if (source->runs != 1)
            return refuse(element,
                          "is one of " + std::to_string(source->runs) + " that line " +
                              std::to_string(lineOf(text, command->range.from)) + " makes.",
                          command->range);
        if (command->substituted)
            return refuse(element, "is made within another command.", command->range);
        std::size_t offset = 0;
        if (element.kind == Kind::parameter)
            if (readerOf(text, structure, nameOf(scene, element), offset))
                return refuse(element,
                              "is read as $" + nameOf(scene, element) + " in line " +
                                  std::to_string(lineOf(text, offset)) + ".",
                              {offset, offset + 1 + nameOf(scene, element).size()});
        if (const scene::Range range = wholeOf(text, structure, *command);
            std::ranges::find(ranges, range) == ranges.end())
            ranges.push_back(range);
        for (const Element& user : dependents(scene, element))
            if (std::ranges::find(all, user) == all.end()) {
                all.push_back(user);
                deletion.along.push_back(user);
            }
    }
    for (const scene::Range& range : withEmptyLines(text, std::move(ranges)))
        deletion.edits.push_back({{range.from, range.to}, ""});
    return deletion;
}

} // namespace editing
