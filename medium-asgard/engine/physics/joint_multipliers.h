// Multipliers and angles of joints, gears and ropes on their way to becoming unknowns.
//
// A condition is made again for each phase of the bodies that it moves. The conditions of an
// element with a release are gone from the first time on at which that expression is not 0.
#pragma once

#include "physics/carried_points.h"

#include <functional>
#include <limits>
#include <unordered_map>

namespace physics {

struct JointCondition {
    Jet jet;
    // first: the multiplier is in the rate. velocity: there is no gap. value: the rate is the
    // multiplier less the force that it is.
    enum class Order { first, second, velocity, value } order = Order::second;
};

struct JointBounds { // of a multiplier; of a stop, restitution
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double restitution = 0;
};

class JointMultipliers {
public:
    using Make = std::function<JointCondition(const Along&)>;
    // Of one joint, gear or rope: its name, and the bodies that it moves.
    struct Element {
        std::string name;
        std::vector<std::size_t> moving;
        double size = 1;            // of the joint
        std::string kind = "joint"; // as sentences call it
    };

    JointMultipliers(Graph& g, const scene::Scene& scene, const Scope& scope,
                     std::span<const BodyMotion> bodies, std::vector<std::string>& faults)
        : g_(g), scene_(scene), scope_(scope), bodies_(bodies), faults_(faults) {}

    // Conditions that are added from now on belong to that element.
    void begin(Element element, const std::optional<scene::Expression>& release);
    // The symbol of a new multiplier. `trajectories`, `reads`: those and the author's expressions
    // that its condition reads.
    [[nodiscard]] Node add(Make make, const JointBounds& bounds = {},
                           std::vector<std::size_t> trajectories = {},
                           std::vector<Node> reads = {});
    // J' force on the element's bodies, with J of this rate; `made` has kind and element.
    void push(std::vector<Contribution>& contributions, Contribution made, Node rate, Node force);
    // The condition that was added last holds through a blow: J of this rate; a stop's where its
    // gap is closed.
    void keepThroughBlows(const Jet& jet);
    // A force itself, or where it may be released a multiplier that is it.
    [[nodiscard]] Node releasable(Node force);
    // A value whose switches other than by the time move nothing as such, as those between numbers:
    // an unknown that is it, so that they are located. Others stay as they are.
    [[nodiscard]] Node located(Node value);
    // An unknown for an angle that is not wrapped.
    void addAngle(Node symbol, Node rate, double size, std::size_t owner);
    // Whether it needs a condition that keeps it with the attitudes; that is added to its rate.
    [[nodiscard]] bool needsTie(Node symbol) const;
    void tie(Node symbol, Node multiplier);
    // When all joints are named: what a joint does may release it.
    void readReleases();

    // The unknowns, behind those of the bodies. Joints that the bodies miss, and ropes that are too
    // short, go to faults; velocities at the start that joints do not allow, to notes. Answers with
    // the conditions that joints put on velocities.
    [[nodiscard]] std::vector<JointRow> addUnknowns(expression::EquationSet& set,
                                                    std::vector<std::size_t>& owners,
                                                    std::vector<std::string>& notes,
                                                    bool checksStart = true);
    // Of these unknowns, once they are there.
    [[nodiscard]] const std::vector<ContactReader>& contactReaders() const {
        return contactReaders_;
    }
    // With the branches that comparisons of the time with numbers take from that time on.
    [[nodiscard]] Node onBranches(Node node, double time);
    [[nodiscard]] Node rateOf(Node node, const Along& along);

private:
    struct Kept {
        Node multiplier;
        Element element;
        Make make;
        JointBounds bounds;
        std::optional<Node> release;
        std::vector<std::size_t> trajectories;
        std::vector<Node> reads;
    };
    struct Angle {
        Node symbol, rate;
        double size = 1;
        std::size_t owner = 0;
        std::optional<Node> tie;
    };
    struct Release { // a given unknown
        Node symbol;
        scene::Expression text;
        Element element;
        Node value;
    };

    struct Located { // a given unknown
        Node symbol, value;
        std::size_t owner = 0;
    };

    void addUnknown(expression::EquationSet& set, const Angle& angle) const;
    void addUnknown(expression::EquationSet& set, const Located& located) const;
    void addUnknown(expression::EquationSet& set, const Kept& kept) const;
    void addUnknown(expression::EquationSet& set, const Release& release) const;
    [[nodiscard]] expression::Phase phaseOf(const Kept& kept, const Along& along) const;
    [[nodiscard]] std::vector<double> startValues(const expression::EquationSet& set,
                                                  std::vector<Node>& inputs) const;
    void markReleased(expression::EquationSet& set, std::size_t first) const;
    void checkStart(const expression::EquationSet& set, std::size_t first,
                    std::vector<std::string>& notes);
    [[nodiscard]] bool isReleased(const Kept& kept, const std::vector<double>& values) const;
    [[nodiscard]] bool isUniversal(const std::string& joint) const;
    void tellDrive(const std::string& element, double gap);
    struct Where {
        std::string sentence;
        std::size_t body = 0; // of that element
    };
    void tell(const Where& where, double gap, double rate, std::vector<std::string>& notes);
    [[nodiscard]] const std::vector<std::size_t>& askedAbout(std::size_t body);
    [[nodiscard]] std::pair<double, double> extents() const;

    Graph& g_;
    const scene::Scene& scene_;
    const Scope& scope_;
    std::span<const BodyMotion> bodies_;
    std::vector<std::string>& faults_;
    struct Begun { // to which conditions are added now
        Element element;
        std::optional<Node> release;
    } begun_;
    std::vector<Kept> kept_;
    std::vector<JointRow> rows_;
    std::vector<Angle> angles_;
    std::vector<Release> releases_;
    std::vector<Located> located_;
    std::vector<ContactReader> contactReaders_;
    std::unordered_map<std::uint32_t, std::size_t> unknownOf_; // by symbol
    std::vector<std::vector<std::size_t>> asked_;              // by body, once asked
};

} // namespace physics
