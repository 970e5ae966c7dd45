// MuJoCo on the cases of contact and joints: joint coordinates, soft contacts as they are by
// default, and as stiff as its step allows with its correction of slip.
#include "play.h"
#include "tree.h"

#include <mujoco/mujoco.h>

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <unistd.h>

namespace {

using namespace bench;
using namespace bench::contacts;

struct Destroy {
    void operator()(mjModel* model) const { mj_deleteModel(model); }
    void operator()(mjData* data) const { mj_deleteData(data); }
};

std::string numbers(const std::vector<double>& values) {
    std::string all;
    for (const double value : values) {
        char text[40];
        std::snprintf(text, sizeof text, "%.17g ", value);
        all += text;
    }
    return all;
}
std::string attribute(const char* name, const std::vector<double>& values) {
    return std::string(" ") + name + "=\"" + numbers(values) + "\"";
}

std::string place(const char* name, const Place& p) { return attribute(name, {p[0], p[1], p[2]}); }

// A damper holds a motor to its speed, so strong that its error is none; the engine takes it
// implicitly but for RK4.
constexpr double holding = 1e8;

std::string jointText(const Body& body, const Joint& joint) {
    std::string text = joint.type == Joint::Type::slider ? "<joint type=\"slide\"" : "<joint";
    text += place("axis", turned(body.angle, joint.axis)) + place("pos", inBody(body, joint.at));
    if (joint.stiffness != 0)
        text += attribute("stiffness", {joint.stiffness}) + attribute("springref", {joint.rest});
    if (joint.dryCouple != 0)
        text += attribute("frictionloss", {joint.dryCouple});
    if (joint.speed)
        text += attribute("damping", {holding});
    return text + "/>";
}

// A body, and those that hang on it, in the frame of what it hangs on. At the start all frames are
// along the world's axes but for the bodies' own angles.
std::string bodyText(const Case& scene, std::size_t index, const Place& from, double angle) {
    const Body& body = scene.bodies[index];
    const double turn = body.angle - angle;
    const Place at = {body.at[0] - from[0], body.at[1] - from[1], body.at[2] - from[2]};
    std::string text = "<body name=\"" + body.name + "\"" + place("pos", turned(angle, at)) +
                       attribute("quat", {std::cos(turn / 2), 0, 0, std::sin(turn / 2)}) + ">";
    const auto joint = treeJoint(scene, index);
    text += joint ? jointText(body, scene.joints[*joint]) : "<freejoint/>";
    const Place inertia = body.inertia();
    text += "<inertial pos=\"0 0 0\"" + attribute("mass", {body.mass}) +
            attribute("diaginertia", {inertia[0], inertia[1], inertia[2]}) + "/>";
    if (scene.collide)
        for (const Place& ball : body.balls())
            text += "<geom type=\"sphere\"" + attribute("size", {body.size[0]}) +
                    place("pos", ball) + "/>";
    if (scene.collide && body.shape == Body::Shape::box)
        text += "<geom type=\"box\"" +
                attribute("size", {body.size[0] / 2, body.size[1] / 2, body.size[2] / 2}) + "/>";
    for (std::size_t b = 0; b < scene.bodies.size(); ++b)
        if (const auto found = treeJoint(scene, b);
            found && scene.joints[*found].body2 == static_cast<int>(index))
            text += bodyText(scene, b, body.at, body.angle);
    return text + "</body>";
}

struct Manner {
    const char* integrator;
    bool stiff;
};

// How soft conditions give way: not at all, as far as the step allows.
std::string softness(double h, bool stiff, const std::string& what = "") {
    if (!stiff)
        return "";
    return attribute(("solref" + what).c_str(), {2 * h, 1}) + " solimp" + what +
           "=\"0.9999 0.9999 0.001\"";
}

std::string documentOf(const Case& scene, double h, const Manner& way) {
    const auto count = static_cast<double>(scene.bodies.size());
    std::string text =
        "<mujoco><size" + attribute("nconmax", {8.0 * (count + 1)}) +
        attribute("njmax", {32.0 * (count + 1)}) + "/><compiler angle=\"radian\"/><option" +
        attribute("timestep", {h}) + attribute("gravity", {0, -scene.gravity, 0}) +
        " cone=\"elliptic\" tolerance=\"1e-12\" integrator=\"" + way.integrator + "\"" +
        (way.stiff ? " noslip_iterations=\"50\" noslip_tolerance=\"1e-14\"" : "") +
        "/><default><geom" + attribute("friction", {scene.friction, 0, 0}) +
        softness(h, way.stiff) + "/><joint" + softness(h, way.stiff, "friction") + "/><equality" +
        softness(h, way.stiff) + "/></default><worldbody>";
    // Of two geoms the one with the priority says the friction.
    for (const Plane& plane : scene.planes)
        text += "<geom type=\"plane\" size=\"0 0 1\"" +
                attribute("zaxis", {-std::sin(plane.slope), std::cos(plane.slope), 0}) +
                " priority=\"1\"" + attribute("friction", {scene.planeFriction, 0, 0}) + "/>";
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        const auto joint = treeJoint(scene, b);
        if (!joint || scene.joints[*joint].body2 < 0)
            text += bodyText(scene, b, {}, 0);
    }
    text += "</worldbody><equality>";
    for (const std::size_t loop : loopJoints(scene)) {
        const Joint& joint = scene.joints[loop];
        const Body& body = scene.bodies[static_cast<std::size_t>(joint.body1)];
        for (const Place& at : closingPoints(scene, joint)) {
            text += "<connect body1=\"" + body.name + "\"";
            if (joint.body2 >= 0)
                text +=
                    " body2=\"" + scene.bodies[static_cast<std::size_t>(joint.body2)].name + "\"";
            text += place("anchor", inBody(body, at)) + "/>";
        }
    }
    return text + "</equality></mujoco>";
}

class MujocoWorld : public World {
public:
    MujocoWorld(const Case& scene, double h, const Manner& way) : h_(h) {
        std::string name =
            (std::filesystem::temp_directory_path() / "bench_mujoco_XXXXXX.xml").string();
        char why[1000] = "";
        const int file = mkstemps(name.data(), 4);
        if (file >= 0)
            close(file);
        std::ofstream(name) << documentOf(scene, h, way);
        model_.reset(mj_loadXML(name.c_str(), nullptr, why, sizeof why));
        std::remove(name.c_str());
        if (!model_) {
            std::fprintf(stderr, "bench_mujoco_contacts: %s\n", why);
            throw std::runtime_error(why);
        }
        data_.reset(mj_makeData(model_.get()));
        for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
            const Body& body = scene.bodies[b];
            ids_.push_back(mj_name2id(model_.get(), mjOBJ_BODY, body.name.c_str()));
            mjtNum* rate = data_->qvel + model_->body_dofadr[ids_.back()];
            if (const auto joint = treeJoint(scene, b)) {
                rate[0] = treeRate(scene, b);
                const Joint& driven = scene.joints[*joint];
                data_->qfrc_applied[model_->body_dofadr[ids_.back()]] =
                    driven.couple + holding * driven.speed.value_or(0);
                continue;
            }
            for (std::size_t a = 0; a < 3; ++a)
                rate[a] = body.velocity[a];
            rate[5] = body.spin;
        }
    }
    void advance(double span) override {
        const long steps = stepsIn(span, h_);
        model_->opt.timestep = span / static_cast<double>(steps);
        for (long i = 0; i < steps; ++i)
            mj_step(model_.get(), data_.get());
        if (data_->warning[mjWARN_BADQACC].number > 0 || data_->warning[mjWARN_BADQPOS].number > 0)
            throw std::runtime_error("the state is not finite");
        count(steps);
    }
    [[nodiscard]] Place centre(std::size_t body) const override {
        mj_kinematics(model_.get(), data_.get());
        const mjtNum* p = data_->xpos + 3 * ids_[body];
        return {p[0], p[1], p[2]};
    }

private:
    double h_;
    std::unique_ptr<mjModel, Destroy> model_;
    std::unique_ptr<mjData, Destroy> data_;
    std::vector<int> ids_;
};

Build with(const Manner& way) {
    return
        [way](const Case& scene, double h) { return std::make_unique<MujocoWorld>(scene, h, way); };
}

} // namespace

int main(int argc, char** argv) {
    const Measurement m("mujoco", argc, argv);
    // It knows no coefficient of restitution.
    const std::vector<Feature> lacks{Feature::rebound, Feature::stop},
        explicitly{Feature::rebound, Feature::stop, Feature::heldSpeed};
    playAll(m, {{"RK4", usualSteps, with({"RK4", false}), explicitly},
                {"Euler", usualSteps, with({"Euler", false}), lacks},
                {"RK4;stiff;noslip", usualSteps, with({"RK4", true}), explicitly},
                {"Euler;stiff;noslip", usualSteps, with({"Euler", true}), lacks}});
    return 0;
}
