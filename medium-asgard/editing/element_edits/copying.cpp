#include "element_edits/copying.h"

#include "editing/number_text.h"
#include "element_edits/creation.h"
#include "element_edits/deletion.h"
#include "element_edits/options.h"
#include "element_edits/renaming.h"
#include "element_edits/words.h"
#include "script/numbers.h"
#include "script/structure.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <optional>
#include <set>

namespace editing {

using geometry::Vector;
using script::Command;
using script::Structure;
using script::Word;

namespace {

// --- copying ----------------------------------------------------------------------------------

// The elements and what goes with them.
class Company {
public:
    Company(const scene::Scene& scene, const std::vector<Element>& elements)
        : scene_(scene), all_(elements.begin(), elements.end()) {
        for (const Element& element : elements)
            if (element.kind == Kind::body)
                bodies_.insert(scene.bodies[element.index].name);
    }
    std::set<Element> all() {
        for (const Element& element : std::vector(all_.begin(), all_.end()))
            if (element.kind == Kind::body)
                for (const Element& user : dependents(scene_, element))
                    if (staysAmong(user))
                        all_.insert(user);
        for (const Element& element : std::vector(all_.begin(), all_.end()))
            addNamed(element);
        return all_;
    }

private:
    [[nodiscard]] bool has(const std::string& body) const { return bodies_.contains(body); }
    // It acts on these bodies only, or between two of them.
    [[nodiscard]] bool staysAmong(const Element& user) const {
        const std::size_t i = user.index;
        switch (user.kind) {
        case Kind::force:
            return has(scene_.forces[i].body);
        case Kind::joint:
            return has(scene_.joints[i].body1) && scene_.joints[i].body2 &&
                   has(*scene_.joints[i].body2);
        case Kind::link: {
            const auto* second = std::get_if<scene::BodyEnd>(&scene_.links[i].second);
            return has(scene_.links[i].first.body) && second && has(second->body);
        }
        case Kind::contact:
            return has(scene_.contacts[i].body1) && has(scene_.contacts[i].body2);
        default:
            return false;
        }
    }
    void addShape(const std::string& name) {
        for (std::size_t i = 0; i < scene_.shapeSets.size(); ++i)
            if (scene_.shapeSets[i].name == name)
                all_.insert({Kind::shapeSet, i});
    }
    void addTrajectory(const std::string& name) {
        for (std::size_t i = 0; i < scene_.trajectories.size(); ++i)
            if (scene_.trajectories[i].name == name)
                all_.insert({Kind::trajectory, i});
    }
    void addNamed(const Element& element) {
        if (element.kind == Kind::body)
            addShape(scene_.bodies[element.index].shape);
        if (element.kind == Kind::constraint)
            addTrajectory(scene_.constraints[element.index].trajectory);
        if (element.kind == Kind::force)
            if (const auto* by =
                    std::get_if<scene::TrajectoryForce>(&scene_.forces[element.index].kind))
                addTrajectory(by->trajectory);
        if (element.kind == Kind::link)
            if (const auto* by =
                    std::get_if<scene::TrajectoryEnd>(&scene_.links[element.index].second))
                addTrajectory(by->trajectory);
    }

    const scene::Scene& scene_;
    std::set<Element> all_;
    std::set<std::string> bodies_;
};

} // namespace

Copied copied(const std::string& text, const scene::Scene& scene,
              const std::vector<Element>& elements) {
    const Structure structure = script::structureOf(text);
    std::set<std::size_t> starts;
    for (const Element& element : Company(scene, elements).all()) {
        const Command* command = nullptr;
        if (const std::string why = whyNotAlone(text, structure, scene, element, command);
            !why.empty())
            return {"", "No copy: " + describe(scene, element) + " " + why};
        starts.insert(command->range.from);
    }
    Copied copy;
    for (const std::size_t start : starts)
        copy.commands += slice(text, structure.startingAt(start)->range) + "\n";
    return copy;
}

// --- pasting ----------------------------------------------------------------------------------

namespace {

constexpr Kind kinds[] = {Kind::simulator, Kind::shapeSet,   Kind::body,       Kind::force,
                          Kind::link,      Kind::joint,      Kind::gear,       Kind::rope,
                          Kind::contact,   Kind::trajectory, Kind::constraint, Kind::light,
                          Kind::view,      Kind::parameter,  Kind::plot};

std::optional<Kind> kindOf(std::string_view command) {
    if (command == "instance")
        return Kind::body;
    if (command == "spring")
        return Kind::link;
    for (const Kind kind : kinds)
        if (commandOf(kind) == command)
            return kind;
    return std::nullopt;
}

} // namespace

std::set<std::string> bodiesOf(const std::string& commands) {
    std::set<std::string> names;
    const Structure structure = script::structureOf(commands);
    for (const Command& command : structure.commands)
        if (command.parent < 0 && command.words.size() > 1 &&
            kindOf(command.name(commands)) == Kind::body)
            names.insert(slice(commands, command.words[1].content));
    return names;
}

namespace {

class Pasting {
public:
    Pasting(const std::string& text, const scene::Scene& scene, const std::string& commands,
            const Vector& beside, const Meets& meets)
        : text_(text), scene_(scene), clip_(commands), beside_(beside), meets_(meets) {}

    Pasted pasted();

private:
    struct Item {
        const Command* command;
        Kind kind;
        std::string name; // "": none
    };
    [[nodiscard]] std::string readItems();
    [[nodiscard]] bool isThere(const Item& item) const;
    [[nodiscard]] std::string hasWeight(const Item& item) const;
    void nameAnew();
    void findWay();
    [[nodiscard]] std::vector<CopiedBody> bodies() const;
    [[nodiscard]] Vector freeWay(const std::vector<CopiedBody>& bodies) const;
    [[nodiscard]] const Word* valueOf(const Item& item, std::string_view option) const;
    [[nodiscard]] std::optional<Vector> placeOf(const Item& item, std::string_view option) const;
    static void move(NewElement& element, const char* option, const Vector& now, const Vector& way);
    void moveBody(const Item& item, NewElement& element) const;
    void moveHold(const Item& item, NewElement& element) const;
    [[nodiscard]] NewElement elementOf(const Item& item) const;

    const std::string& text_;
    const scene::Scene& scene_;
    std::string clip_;
    Vector beside_, way_ = Vector::Zero();
    const Meets& meets_;
    Structure structure_;
    std::vector<Item> items_;
};

// "" or why not.
std::string Pasting::readItems() {
    structure_ = script::structureOf(clip_);
    items_.clear();
    for (const Command& command : structure_.commands) {
        if (command.parent >= 0)
            continue;
        const std::string word(command.name(clip_));
        const auto kind = kindOf(word);
        if (!kind || !structure_.faults.empty())
            return "The clipboard holds no commands of a scene.";
        if (*kind == Kind::simulator)
            continue; // the scene has its own
        Item item{&command, *kind, ""};
        if (hintOf(word)->named && command.words.size() > 1) {
            const std::string name = slice(clip_, command.words[1].content);
            if (!name.starts_with('-') && !command.words[1].literal)
                return "The name of a " + wordOf(*kind) + " on the clipboard is computed.";
            item.name = name.starts_with('-') ? "" : name;
        }
        items_.push_back(item);
    }
    return items_.empty() ? "The clipboard holds no commands of a scene." : "";
}

// Word for word the same: bodies may go on sharing it.
bool Pasting::isThere(const Item& item) const {
    if (item.kind != Kind::shapeSet && item.kind != Kind::trajectory &&
        item.kind != Kind::parameter)
        return false;
    for (std::size_t i = 0; const scene::Source* source = sourceOf(scene_, {item.kind, i}); ++i)
        if (nameOf(scene_, {item.kind, i}) == item.name && source->command.known() &&
            slice(text_, source->command) == slice(clip_, item.command->range))
            return true;
    return false;
}

// The body of the scene whose second weight it would be; "": of none.
std::string Pasting::hasWeight(const Item& item) const {
    const Word* body = valueOf(item, "-body");
    if (item.kind != Kind::force || body == nullptr || valueOf(item, "-gravitational") == nullptr)
        return {};
    const std::string name = slice(clip_, body->content);
    const bool hasOne = std::ranges::any_of(scene_.forces, [&](const scene::Force& force) {
        return force.body == name && std::holds_alternative<scene::GravitationalForce>(force.kind);
    });
    return hasOne ? name : std::string();
}

void Pasting::nameAnew() {
    std::vector<std::string> taken;
    for (const Item& item : items_)
        taken.push_back(item.name);
    text::Edits edits;
    for (const Item& item : items_) {
        if (item.name.empty() || isThere(item) || isFreeName(scene_, item.name))
            continue;
        taken.push_back(numberedName(text_, scene_, item.name, taken));
        for (const text::Edit& edit :
             mentionsRenamed(clip_, structure_, item.kind, item.name, taken.back()))
            (void)text::join(edits, edit);
    }
    text::putInOrder(edits);
    clip_ = text::applied(clip_, edits);
}

const Word* Pasting::valueOf(const Item& item, std::string_view option) const {
    const auto& words = item.command->words;
    for (std::size_t i = 1; i + 1 < words.size(); ++i)
        if (slice(clip_, words[i].range) == option)
            return &words[i + 1];
    return nullptr;
}

// LIMIT: a place that is computed stays as it is.
std::optional<Vector> Pasting::placeOf(const Item& item, std::string_view option) const {
    const Word* word = valueOf(item, option);
    if (word == nullptr)
        return std::nullopt;
    const script::ElementList list = script::elementsOf(slice(clip_, word->content));
    if (!word->literal || list.elements.size() != 3)
        return std::nullopt;
    Vector place;
    for (int i = 0; i < 3; ++i) {
        const auto number = script::decimalNumber(list.elements[static_cast<std::size_t>(i)].value);
        if (!number)
            return std::nullopt;
        place[i] = *number;
    }
    return place;
}

// LIMIT: a quaternion, or an attitude that is computed, counts as none.
std::vector<CopiedBody> Pasting::bodies() const {
    std::vector<CopiedBody> bodies;
    for (const Item& item : items_) {
        const bool isGiven = valueOf(item, "-init_pos") != nullptr;
        const auto place = placeOf(item, "-init_pos");
        if (item.kind != Kind::body || (isGiven && !place))
            continue;
        const Vector turn = placeOf(item, "-init_rot").value_or(Vector::Zero());
        const auto& words = item.command->words;
        const Word* shape = words.size() > 2 ? &words[2] : nullptr;
        if (const Word* option = valueOf(item, "-shape"))
            shape = option;
        bodies.push_back(
            {shape ? scene::findShapeSet(scene_, slice(clip_, shape->content)) : nullptr,
             {place.value_or(Vector::Zero()),
              geometry::Quaternion(Eigen::AngleAxisd(turn.norm(), turn.stableNormalized()))}});
    }
    return bodies;
}

void Pasting::findWay() {
    const std::vector<CopiedBody> bodies = this->bodies();
    const auto isTaken = [&](const CopiedBody& one) {
        const Vector place = one.pose.position + way_;
        return std::ranges::any_of(scene_.bodies, [&](const scene::Body& body) {
            return body.initialPosition.isApprox(place, 1e-9) ||
                   (body.initialPosition - place).norm() < 1e-9 * beside_.norm();
        });
    };
    while (!beside_.isZero() && std::ranges::any_of(bodies, isTaken))
        way_ += beside_;
    if (!beside_.isZero() && meets_)
        way_ = freeWay(bodies);
}

Vector Pasting::freeWay(const std::vector<CopiedBody>& bodies) const {
    constexpr int most = 50; // further away it is not beside them
    Vector way = way_;
    for (int i = 0; i < most; ++i, way += beside_) {
        std::vector<CopiedBody> moved = bodies;
        for (CopiedBody& one : moved)
            one.pose.position += way;
        if (!meets_(moved))
            return way;
    }
    return way_;
}

void Pasting::move(NewElement& element, const char* option, const Vector& now, const Vector& way) {
    if (way.isZero())
        return;
    std::string written = "{";
    for (int i = 0; i < 3; ++i) {
        const double sum = now[i] + way[i];
        const double value = std::abs(sum) < 1e-12 * way.norm() ? 0 : sum; // rounding
        written += (i > 0 ? " " : "") + numberText(value, 1e-9 * std::max(1.0, std::abs(value)));
    }
    written += "}";
    const auto word = std::ranges::find(element.words, option);
    if (word != element.words.end() && word + 1 != element.words.end())
        *(word + 1) = written;
    else
        element.words.insert(element.words.end(), {option, written});
}

void Pasting::moveBody(const Item& item, NewElement& element) const {
    const bool isGiven = valueOf(item, "-init_pos") != nullptr;
    if (const auto place = placeOf(item, "-init_pos"); place || !isGiven)
        move(element, "-init_pos", place.value_or(Vector::Zero()), way_);
}

// The point of the world, or of a body that stays, that a body of the copy is held by.
void Pasting::moveHold(const Item& item, NewElement& element) const {
    constexpr std::array<std::array<const char*, 2>, 2> ends{
        {{"-body1", "-offset1"}, {"-body2", "-offset2"}}};
    const auto bodyOf = [&](std::size_t end) {
        const Word* word = valueOf(item, ends[end][0]);
        return word != nullptr ? slice(clip_, word->content) : std::string();
    };
    const auto isCopied = [&](const std::string& body) {
        return std::ranges::any_of(
            items_, [&](const Item& one) { return one.kind == Kind::body && one.name == body; });
    };
    for (const std::size_t end : {0U, 1U}) {
        const std::string body = bodyOf(end);
        const auto place = placeOf(item, ends[end][1]);
        if (isCopied(body) || !isCopied(bodyOf(1 - end)) || !place)
            continue;
        const scene::Body* stays = scene::findBody(scene_, body);
        if (!body.empty() && stays == nullptr)
            continue;
        move(element, ends[end][1], *place,
             stays != nullptr ? Vector(stays->initialAttitude.conjugate() * way_) : way_);
    }
}

NewElement Pasting::elementOf(const Item& item) const {
    NewElement element;
    element.kind = item.kind;
    element.command = std::string(item.command->name(clip_));
    element.name = item.name;
    const std::size_t first = item.name.empty() ? 1 : 2;
    for (std::size_t i = first; i < item.command->words.size(); ++i)
        if (!item.command->words[i].fromList)
            element.words.push_back(slice(clip_, item.command->words[i].range));
    if (item.kind == Kind::body)
        moveBody(item, element);
    if (item.kind == Kind::joint || item.kind == Kind::link)
        moveHold(item, element);
    return element;
}

Pasted Pasting::pasted() {
    Pasted pasted;
    pasted.reason = readItems();
    if (!pasted.possible())
        return pasted;
    nameAnew();
    pasted.reason = readItems(); // with the new names
    findWay();
    std::vector<NewElement> elements;
    std::map<Kind, std::size_t> counts;
    std::string heavy;
    for (const Item& item : items_) {
        if (const std::string body = hasWeight(item); !body.empty())
            heavy = body;
        if (isThere(item) || !hasWeight(item).empty())
            continue;
        const std::size_t index = countOf(scene_, item.kind) + counts[item.kind]++;
        if (item.kind != Kind::shapeSet)
            pasted.added.push_back({item.kind, index});
        elements.push_back(elementOf(item));
    }
    if (elements.empty())
        pasted.reason = heavy.empty() ? "The scene has all of it already."
                                      : heavy + " has a weight already: select a body to copy it "
                                                "with its weight.";
    pasted.edits = created(text_, scene_, elements);
    return pasted;
}

} // namespace

Pasted pasted(const std::string& text, const scene::Scene& scene, const std::string& commands,
              const Vector& beside, const Meets& meets) {
    return Pasting(text, scene, commands, beside, meets).pasted();
}

} // namespace editing
