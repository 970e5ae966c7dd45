#include "scene/connections.h"

#include "expression/tokens.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <set>
#include <string_view>
#include <unordered_map>

namespace scene {
namespace {

using Index = std::unordered_map<std::string_view, std::size_t>;

template <typename Element> Index indexOf(const std::vector<Element>& elements) {
    Index index;
    index.reserve(elements.size());
    for (std::size_t i = 0; i < elements.size(); ++i)
        index.try_emplace(elements[i].name, i);
    return index;
}

class Collector {
public:
    Collector(const Scene& scene, std::vector<Mention>& mentions, bool& isBroken)
        : mentions_(mentions), isBroken_(isBroken), bodies_(indexOf(scene.bodies)),
          trajectories_(indexOf(scene.trajectories)), parameters_(indexOf(scene.parameters)),
          shapes_(indexOf(scene.shapeSets)), joints_(indexOf(scene.joints)),
          springs_(indexOf(scene.links)), ropes_(indexOf(scene.ropes)),
          contacts_(indexOf(scene.contacts)) {
        springs_.erase(std::string_view()); // links, and springs without a name
        contacts_.erase(std::string_view());
    }

    std::size_t body(const std::string& name) { return found(bodies_, name); }
    std::size_t shape(const std::string& name) { return found(shapes_, name); }
    std::size_t joint(const std::string& name) { return found(joints_, name); }

    void mention(std::size_t reader, Mention::Kind kind, std::size_t index) {
        if (reader != noElement && index != noElement)
            mentions_.push_back({reader, kind, index});
    }
    void trajectory(std::size_t reader, const std::string& name) {
        mention(reader, Mention::Kind::trajectory, found(trajectories_, name));
    }
    void expressions(std::size_t reader, const std::array<Expression, 3>& texts) {
        for (const Expression& text : texts)
            expression(reader, text);
    }
    void expression(std::size_t reader, const std::optional<Expression>& text) {
        if (!text)
            return;
        for (expression::Tokens tokens(*text); tokens.now().kind != expression::TokenKind::end;
             tokens.advance())
            if (tokens.now().kind == expression::TokenKind::name)
                word(reader, tokens.now().text);
    }

private:
    std::size_t found(const Index& index, const std::string& name) {
        const auto place = index.find(name);
        isBroken_ = isBroken_ || place == index.end();
        return place == index.end() ? noElement : place->second;
    }
    // As Names does: what stands before the last dot is the owner.
    void word(std::size_t reader, std::string_view name) {
        const std::string_view owner = name.substr(0, name.rfind('.'));
        for (const auto& [index, kind] :
             {std::pair{&bodies_, Mention::Kind::body},
              std::pair{&trajectories_, Mention::Kind::trajectory},
              std::pair{&parameters_, Mention::Kind::parameter},
              std::pair{&joints_, Mention::Kind::joint},
              std::pair{&springs_, Mention::Kind::spring}, std::pair{&ropes_, Mention::Kind::rope},
              std::pair{&contacts_, Mention::Kind::contact}})
            if (const auto place = index->find(owner); place != index->end())
                return mention(reader, kind, place->second);
    }

    std::vector<Mention>& mentions_;
    bool& isBroken_;
    Index bodies_, trajectories_, parameters_, shapes_, joints_, springs_, ropes_, contacts_;
};

std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
}

// Who reads a spring reads all that its ends follow from.
void mentionEndsOfSprings(const Scene& scene, Collector& collect,
                          const std::vector<Mention>& mentions, std::span<const std::size_t> first,
                          std::span<const std::size_t> second) {
    const std::size_t count = mentions.size();
    for (std::size_t m = 0; m < count; ++m) {
        const Mention mention = mentions[m]; // the list grows
        if (mention.kind != Mention::Kind::spring)
            continue;
        for (const std::size_t body : {first[mention.index], second[mention.index]})
            if (body != mention.reader)
                collect.mention(mention.reader, Mention::Kind::body, body);
        const Link& spring = scene.links[mention.index];
        if (const auto* driven = std::get_if<TrajectoryEnd>(&spring.second))
            collect.trajectory(mention.reader, driven->trajectory);
        else if (const auto* point = std::get_if<PointEnd>(&spring.second))
            collect.expressions(mention.reader, point->coordinates);
    }
}

} // namespace

ByBody::ByBody(std::size_t bodies, std::span<const std::size_t> owners) : starts_(bodies + 1) {
    for (const std::size_t owner : owners)
        if (owner != noElement)
            ++starts_[owner + 1];
    std::partial_sum(starts_.begin(), starts_.end(), starts_.begin());
    elements_.resize(starts_.back());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (std::size_t i = 0; i < owners.size(); ++i)
        if (owners[i] != noElement)
            elements_[next[owners[i]]++] = i;
}

ByBody::ByBody(std::size_t bodies,
               std::span<const std::pair<std::size_t, std::size_t>> ownersAndElements) {
    std::vector<std::size_t> owners;
    for (const auto& [owner, element] : ownersAndElements)
        owners.push_back(owner);
    *this = ByBody(bodies, owners);
    for (std::size_t& place : elements_)
        place = ownersAndElements[place].second;
}

namespace {

using Ends = std::pair<std::size_t, std::size_t>; // bodies; noElement: the world
using Owned = std::vector<std::pair<std::size_t, std::size_t>>;

// Adds what each of these bodies moves by: the others of them.
void mentionEachOther(Collector& collect, std::span<const std::size_t> bodies) {
    for (const std::size_t a : bodies)
        for (const std::size_t b : bodies)
            if (a != b)
                collect.mention(a, Mention::Kind::body, b);
}

// The ends of all joints; what their bodies read by them is added.
std::vector<Ends> jointEnds(const Scene& scene, Collector& collect) {
    std::vector<Ends> ends;
    for (const Joint& joint : scene.joints) {
        const Ends on{collect.body(joint.body1),
                      joint.body2 ? collect.body(*joint.body2) : noElement};
        mentionEachOther(collect, std::array{on.first, on.second});
        for (const std::size_t reader : {on.first, on.second}) {
            for (const JointCoordinate& coordinate : joint.coordinates)
                for (const auto* text :
                     {&coordinate.motor, &coordinate.speed, &coordinate.position})
                    collect.expression(reader, *text);
            collect.expression(reader, joint.release);
        }
        ends.push_back(on);
    }
    return ends;
}

// A gear's bodies read all its joints, also one whose own bodies are fixed.
Owned gearOwners(const Scene& scene, Collector& collect, std::span<const Ends> ends) {
    Owned owners;
    for (std::size_t g = 0; g < scene.gears.size(); ++g) {
        std::vector<std::size_t> joints, bodies;
        for (const Gear::Term& term : scene.gears[g].terms)
            if (const std::size_t joint = collect.joint(term.joint); joint != noElement) {
                joints.push_back(joint);
                for (const std::size_t body : {ends[joint].first, ends[joint].second})
                    if (body != noElement && std::ranges::find(bodies, body) == bodies.end())
                        bodies.push_back(body);
            }
        mentionEachOther(collect, bodies);
        for (const std::size_t body : bodies) {
            for (const std::size_t joint : joints)
                collect.mention(body, Mention::Kind::joint, joint);
            collect.expression(body, scene.gears[g].release);
            owners.emplace_back(body, g);
        }
    }
    return owners;
}

// The bodies of each rope; what they read by it is added.
Owned ropeOwners(const Scene& scene, Collector& collect) {
    Owned owners;
    for (std::size_t r = 0; r < scene.ropes.size(); ++r) {
        std::vector<std::size_t> bodies;
        for (const Rope::Point& point : scene.ropes[r].points) {
            const std::size_t body = point.body ? collect.body(*point.body) : noElement;
            if (body != noElement && std::ranges::find(bodies, body) == bodies.end())
                bodies.push_back(body);
        }
        mentionEachOther(collect, bodies);
        for (const std::size_t body : bodies) {
            collect.expression(body, scene.ropes[r].release);
            owners.emplace_back(body, r);
        }
    }
    return owners;
}

// Who reads a rope reads its bodies, too.
void mentionBodiesOfRopes(Collector& collect, const std::vector<Mention>& mentions,
                          const Owned& owners) {
    const std::size_t count = mentions.size();
    for (std::size_t m = 0; m < count; ++m) {
        const Mention mention = mentions[m]; // the list grows
        if (mention.kind != Mention::Kind::rope)
            continue;
        for (const auto& [body, rope] : owners)
            if (rope == mention.index && body != mention.reader)
                collect.mention(mention.reader, Mention::Kind::body, body);
    }
}

// Who reads a contact reads its bodies, too.
void mentionBodiesOfContacts(const Scene& scene, Collector& collect,
                             const std::vector<Mention>& mentions) {
    const std::size_t count = mentions.size();
    for (std::size_t m = 0; m < count; ++m) {
        const Mention mention = mentions[m]; // the list grows
        if (mention.kind != Mention::Kind::contact)
            continue;
        const Contact& contact = scene.contacts[mention.index];
        for (const std::size_t body : {collect.body(contact.body1), collect.body(contact.body2)})
            if (body != mention.reader)
                collect.mention(mention.reader, Mention::Kind::body, body);
    }
}

// Who reads a joint reads its bodies, too.
void mentionBodiesOfJoints(Collector& collect, std::vector<Mention>& mentions,
                           std::span<const Ends> joints) {
    const std::size_t count = mentions.size();
    for (std::size_t m = 0; m < count; ++m) {
        const Mention mention = mentions[m]; // the list grows
        if (mention.kind == Mention::Kind::joint)
            for (const std::size_t body :
                 {joints[mention.index].first, joints[mention.index].second})
                if (body != mention.reader)
                    collect.mention(mention.reader, Mention::Kind::body, body);
    }
}

} // namespace

Connections::Connections(const Scene& scene) {
    Collector collect(scene, mentionList, isBroken);
    std::vector<std::size_t> onBody, first, second, constrained, readers;
    for (const Body& body : scene.bodies)
        shapes.push_back(collect.shape(body.shape));
    for (const Force& force : scene.forces) {
        onBody.push_back(collect.body(force.body));
        if (const auto* expressions = std::get_if<ComponentForce>(&force.kind))
            collect.expressions(onBody.back(), expressions->components);
        else if (const auto* driven = std::get_if<TrajectoryForce>(&force.kind))
            collect.trajectory(onBody.back(), driven->trajectory);
        collect.expression(onBody.back(), force.release);
    }
    for (const Link& link : scene.links) {
        first.push_back(collect.body(link.first.body));
        second.push_back(noElement);
        if (const auto* end = std::get_if<BodyEnd>(&link.second)) {
            second.back() = collect.body(end->body);
            collect.mention(first.back(), Mention::Kind::body, second.back());
            collect.mention(second.back(), Mention::Kind::body, first.back());
        } else if (const auto* driven = std::get_if<TrajectoryEnd>(&link.second)) {
            collect.trajectory(first.back(), driven->trajectory);
        } else {
            collect.expressions(first.back(), std::get<PointEnd>(link.second).coordinates);
        }
        for (const std::size_t body : {first.back(), second.back()})
            collect.expression(body, link.release);
    }
    for (const Constraint& constraint : scene.constraints) {
        constrained.push_back(collect.body(constraint.body));
        collect.trajectory(constrained.back(), constraint.trajectory);
    }
    const std::size_t count = scene.bodies.size();
    const std::vector<Ends> ends = jointEnds(scene, collect);
    Owned onBodies;
    for (std::size_t j = 0; j < ends.size(); ++j)
        for (const std::size_t body : {ends[j].first, ends[j].second})
            onBodies.emplace_back(body, j);
    joints = ByBody(count, onBodies);
    gears = ByBody(count, gearOwners(scene, collect, ends));
    const Owned ofRopes = ropeOwners(scene, collect);
    ropes = ByBody(count, ofRopes);
    Owned ofContacts;
    for (std::size_t c = 0; c < scene.contacts.size(); ++c)
        for (const std::string* name : {&scene.contacts[c].body1, &scene.contacts[c].body2})
            if (const std::size_t body = collect.body(*name);
                body != noElement && !scene.bodies[body].fixed)
                ofContacts.emplace_back(body, c);
    mentionBodiesOfContacts(scene, collect, mentionList);
    contacts = ByBody(count, ofContacts);
    mentionBodiesOfJoints(collect, mentionList, ends);
    mentionBodiesOfRopes(collect, mentionList, ofRopes);
    mentionEndsOfSprings(scene, collect, mentionList, first, second);
    for (const Mention& mention : mentionList)
        readers.push_back(mention.reader);
    forces = ByBody(count, onBody);
    firstEnds = ByBody(count, first);
    secondEnds = ByBody(count, second);
    constraints = ByBody(count, constrained);
    mentions = ByBody(count, readers);

    group.resize(count);
    std::iota(group.begin(), group.end(), std::size_t{0});
    for (const Mention& mention : mentionList) {
        if (mention.kind != Mention::Kind::body || scene.bodies[mention.reader].fixed ||
            scene.bodies[mention.index].fixed)
            continue;
        const std::size_t a = rootOf(group, mention.reader), b = rootOf(group, mention.index);
        group[std::max(a, b)] = std::min(a, b);
    }
    for (std::size_t b = 0; b < count; ++b)
        group[b] = rootOf(group, b);
}

std::vector<std::vector<std::size_t>> joinedBodies(const Scene& scene, const Released& released) {
    const Index bodies = indexOf(scene.bodies);
    std::vector<std::vector<std::size_t>> joined(scene.bodies.size());
    const auto join = [&](std::size_t a, std::size_t b) {
        joined[a].push_back(b);
        joined[b].push_back(a);
    };
    for (std::size_t l = 0; l < scene.links.size(); ++l) {
        const Link& link = scene.links[l];
        const auto* second = std::get_if<BodyEnd>(&link.second);
        if (second && !link.spring && !released.links.contains(l))
            join(bodies.at(link.first.body), bodies.at(second->body));
    }
    std::vector<std::size_t> rigid(scene.bodies.size()); // what fixed joints make one piece
    std::iota(rigid.begin(), rigid.end(), std::size_t{0});
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const Joint& joint = scene.joints[j];
        if (!joint.body2 || released.joints.contains(j))
            continue;
        const std::size_t a = bodies.at(joint.body1), b = bodies.at(*joint.body2);
        join(a, b);
        if (joint.type == JointType::fixed)
            rigid[rootOf(rigid, a)] = rootOf(rigid, b);
    }
    // Teeth are in each other's gaps, which no shape has. A body that slides has teeth for one that
    // turns alone: sliders that are coupled have none.
    const Index joints = indexOf(scene.joints);
    for (std::size_t g = 0; g < scene.gears.size(); ++g) {
        if (released.gears.contains(g))
            continue;
        std::vector<std::pair<std::size_t, bool>> toothed; // bodies, and whether they turn
        for (const Gear::Term& term : scene.gears[g].terms) {
            const Joint& joint = scene.joints[joints.at(term.joint)];
            const std::size_t first = bodies.at(joint.body1);
            const bool isSecond = scene.bodies[first].fixed && joint.body2;
            toothed.emplace_back(isSecond ? bodies.at(*joint.body2) : first,
                                 joint.type != JointType::slider);
        }
        for (const auto& [a, turnsA] : toothed)
            for (const auto& [b, turnsB] : toothed)
                if (a < b && (turnsA || turnsB))
                    join(a, b);
    }
    std::unordered_map<std::size_t, std::vector<std::size_t>> pieces;
    for (std::size_t b = 0; b < rigid.size(); ++b)
        pieces[rootOf(rigid, b)].push_back(b);
    for (const auto& [root, members] : pieces)
        for (std::size_t i = 0; members.size() > 2 && i < members.size(); ++i)
            for (std::size_t k = 0; k < i; ++k)
                join(members[i], members[k]);
    return joined;
}

} // namespace scene
