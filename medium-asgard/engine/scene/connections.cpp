#include "scene/connections.h"

#include "expression/tokens.h"

#include <array>
#include <numeric>
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
          shapes_(indexOf(scene.shapeSets)) {}

    std::size_t body(const std::string& name) { return found(bodies_, name); }
    std::size_t shape(const std::string& name) { return found(shapes_, name); }

    void mention(std::size_t reader, Mention::Kind kind, std::size_t index) {
        if (reader != noElement && index != noElement)
            mentions_.push_back({reader, kind, index});
    }
    void trajectory(std::size_t reader, const std::string& name) {
        mention(reader, Mention::Kind::trajectory, found(trajectories_, name));
    }
    void expressions(std::size_t reader, const std::array<Expression, 3>& texts) {
        for (const Expression& text : texts)
            for (expression::Tokens tokens(text); tokens.now().kind != expression::TokenKind::end;
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
        for (const auto& [index, kind] : {std::pair{&bodies_, Mention::Kind::body},
                                          std::pair{&trajectories_, Mention::Kind::trajectory},
                                          std::pair{&parameters_, Mention::Kind::parameter}})
            if (const auto place = index->find(owner); place != index->end())
                return mention(reader, kind, place->second);
    }

    std::vector<Mention>& mentions_;
    bool& isBroken_;
    Index bodies_, trajectories_, parameters_, shapes_;
};

std::size_t rootOf(std::vector<std::size_t>& parent, std::size_t i) {
    while (parent[i] != i)
        i = parent[i] = parent[parent[i]];
    return i;
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
    }
    for (const Constraint& constraint : scene.constraints) {
        constrained.push_back(collect.body(constraint.body));
        collect.trajectory(constrained.back(), constraint.trajectory);
    }
    for (const Mention& mention : mentionList)
        readers.push_back(mention.reader);
    const std::size_t count = scene.bodies.size();
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

} // namespace scene
