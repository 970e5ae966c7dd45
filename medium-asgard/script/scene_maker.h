// make_scene.h, command by command.
#pragma once

#include "scene/names.h"
#include "script/arguments.h"
#include "script/make_scene.h"
#include "text/places.h"

#include <array>
#include <set>

namespace script {

// One run of a scene command with the places of its words, as far as they are known.
[[nodiscard]] Call callOf(std::string_view text, const Structure& structure,
                          const RecordedCommand& recorded);

class SceneMaker {
public:
    SceneMaker(std::string_view text, const std::map<std::string, double>& parameters,
               MadeScene& made);

    void make(Call& call);
    void finish(bool finished); // what needs the whole scene

private:
    // One function per command.
    void simulator(Call& call);
    void shapeSet(Call& call);
    void body(Call& call);
    void force(Call& call);
    void link(Call& call);
    void joint(Call& call);
    void gear(Call& call);
    void rope(Call& call);
    void contact(Call& call);
    void spring(Call& call);
    void trajectory(Call& call);
    void constrain(Call& call);
    void lightSource(Call& call);
    void view(Call& call);
    void parameter(Call& call);
    void plot(Call& call);

    // --- names ---
    enum class Kind {
        shapeSet,
        body,
        trajectory,
        parameter,
        joint,
        gear,
        rope,
        contact,
        spring,
        lightSource,
        view,
        plot
    };
    // The name at words[1], checked and registered; "" and a report when there is none.
    std::string newName(Call& call, Kind kind);
    std::string optionalName(Call& call, Kind kind, std::size_t& first);
    void registerName(const std::string& name, const Value& word, Kind kind);
    bool validSymbol(const std::string& name, const Value& word, Kind kind);
    [[nodiscard]] bool exists(Kind kind, const std::string& name) const;
    // The suggestion when one does not; "" after a few hundred, which a loop can ask for.
    [[nodiscard]] std::string suggest(Kind kind, const std::string& name);
    // The element of that name exists already, else a report.
    bool refers(Arguments& arguments, std::string_view option, const std::string& name, Kind kind);
    std::optional<std::string> reference(Arguments& arguments, std::string_view option, Kind kind);

    // --- parts of elements ---
    std::vector<scene::Part> partsOf(Arguments& arguments, const Value& description);
    std::optional<scene::Part> partOf(Arguments& arguments, const Value& description);
    bool shapeOfPart(Arguments& arguments, const std::string& option, const Value& value,
                     scene::Part& part);
    bool hollowPart(Arguments& arguments, const std::string& option, const Value& value,
                    scene::Part& part);
    template <typename Round>
    bool roundPart(Arguments& arguments, const std::string& option, const Value& value,
                   bool mayBeFlat, scene::Part& part);
    void checkShapeOf(Arguments& arguments, const scene::Body& body);
    bool facePoints(Arguments& arguments, const Value& face, std::vector<geometry::Vector>& points,
                    scene::Appearance& appearance);
    bool solid(Arguments& arguments, std::string_view option, Range range,
               const std::vector<geometry::Vector>& points);
    bool appearanceWord(Arguments& arguments, const std::vector<Value>& words, std::size_t& i,
                        scene::Appearance& appearance);
    void attitude(Arguments& arguments, scene::Body& body);
    void inertia(Arguments& arguments, scene::Body& body);
    std::optional<std::array<scene::Expression, 3>> components(Arguments& arguments,
                                                               bool allRequired);
    void ends(Arguments& arguments, std::string_view what, scene::Link& link);
    void smoothCurves(Arguments& arguments, scene::Trajectory& trajectory);
    void bezierCurves(Arguments& arguments, scene::Trajectory& trajectory);
    void orderCurves(Arguments& arguments, const std::vector<Value>& words,
                     scene::Trajectory& trajectory);
    std::optional<scene::VectorValue> vectorValue(Arguments& arguments, std::string_view option);
    std::optional<scene::ScalarValue> scalarValue(Arguments& arguments, std::string_view option);

    // --- parts of joints, gears and ropes ---
    void jointEnds(Arguments& arguments, scene::Joint& joint);
    void jointAxes(Arguments& arguments, scene::Joint& joint);
    void refuseOptions(Arguments& arguments, const scene::Joint& joint);
    scene::JointCoordinate jointCoordinate(Arguments& arguments, const scene::Joint& joint,
                                           std::size_t index);
    void jointLimits(Arguments& arguments, const std::string& suffix, bool startsAtZero,
                     scene::JointCoordinate& coordinate);
    void jointDrive(Arguments& arguments, const std::string& suffix,
                    scene::JointCoordinate& coordinate);
    std::optional<scene::Expression> expressionOf(Arguments& arguments, std::string_view option,
                                                  scene::Reading reading);
    std::optional<scene::Expression> drivenPosition(Arguments& arguments,
                                                    const std::string& option);
    std::vector<scene::Gear::Term> gearPair(Arguments& arguments);
    std::vector<scene::Gear::Term> gearList(Arguments& arguments);
    std::optional<scene::Gear::Term> gearTerm(Arguments& arguments, std::string_view option,
                                              const Value& value, double ratio);
    std::vector<scene::Rope::Point> ropePoints(Arguments& arguments);
    std::optional<scene::Rope::Point> ropePoint(Arguments& arguments, const Value& value);
    bool ropeWheel(Arguments& arguments, const std::vector<Value>& parts,
                   scene::Rope::Point& point);
    void checkContact(Arguments& arguments, const scene::Contact& contact);
    void checkJoints();
    void checkJointCycles();

    // --- what is checked when all names are known ---
    struct PendingExpression {
        Value value;
        std::string subject; // "-x of the force on body "b1""
        scene::Reading reading;
    };
    std::string expression(Arguments& arguments, std::string_view option, const Value& value,
                           scene::Reading reading = scene::Reading::state);
    void checkExpressions();
    void checkHolds();
    void checkPlanes();
    void warnOfUnusedParameters();
    void checkOverrides(bool finished);

    std::string_view text_;
    const std::map<std::string, double>& overrides_;
    MadeScene& made_;
    text::Places places_;
    Faults faults_;
    std::map<std::string, Kind> symbols_; // of all kinds that share their names
    std::map<Kind, std::vector<std::string>> others_;
    std::map<std::string, Range> defined_; // where, by kind and name
    std::vector<PendingExpression> expressions_;
    struct Hold {
        Range range; // of the option
        std::string option;
        scene::Constraint constraint;
    };
    std::vector<Hold> holds_;
    std::vector<std::pair<std::string, Range>> planes_; // bodies with a half space that may move
    int suggestions_ = 0;
    bool simulatorSeen_ = false;
};

} // namespace script
