#include "render/renderer.h"

#include "drawing/context.h"
#include "drawing/discs.h"
#include "drawing/overlay.h"
#include "drawing/shadow_map.h"
#include "drawing/solids.h"
#include "drawing/target.h"
#include "framing/framing.h"
#include "framing/joint_places.h"
#include "framing/rope_lines.h"
#include "framing/standing_points.h"
#include "handles/handle_marks.h"
#include "handles/handles.h"
#include "signs/coils.h"
#include "signs/contact_forces.h"
#include "signs/joint_signs.h"
#include "signs/trails.h"
#include "surroundings/backdrop.h"
#include "surroundings/ground.h"
#include "surroundings/triad.h"

#include <algorithm>
#include <cmath>

namespace render {

using Projection = std::array<float, 16>;

namespace {

bool sameOutlines(const std::vector<scene::Body>& a, const std::vector<scene::Body>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.shape == y.shape && x.initialPosition == y.initialPosition &&
               x.initialAttitude.coeffs() == y.initialAttitude.coeffs() && x.fixed == y.fixed;
    });
}

// The extent of the motion that was drawn last: made anew for another motion, or where bodies or
// what holds them stand elsewhere.
class KeptExtent {
public:
    void follow(const Drawing& drawing) {
        std::vector<Vector> anchors = anchorsOf(*drawing.scene, drawing.motion.get());
        std::ranges::copy(jointAnchorsOf(*drawing.scene, drawing.motion.get()),
                          std::back_inserter(anchors));
        std::ranges::copy(ropeAnchorsOf(*drawing.scene), std::back_inserter(anchors));
        if (motion_.lock() == drawing.motion && anchors_ == anchors &&
            sameOutlines(bodies_, drawing.scene->bodies))
            return;
        extent_ = extentOf(*drawing.scene, drawing.motion.get());
        motion_ = drawing.motion;
        bodies_ = drawing.scene->bodies;
        anchors_ = std::move(anchors);
    }
    [[nodiscard]] const Extent& extent() const { return extent_; }

private:
    std::weak_ptr<const simulation::Motion> motion_;
    std::vector<scene::Body> bodies_;
    std::vector<Vector> anchors_; // of springs, joints and ropes in the world
    Extent extent_;
};

} // namespace

struct Renderer::Implementation {
    std::unique_ptr<Context> context;
    Gl gl;
    std::unique_ptr<Target> target;
    std::unique_ptr<Solids> solids;
    std::unique_ptr<Lines> lines;
    std::unique_ptr<Discs> discs;
    std::unique_ptr<Backdrop> backdrop;
    std::unique_ptr<ShadowMap> shadows;
    std::unique_ptr<GroundShadow> groundShadow;
    bool isSoftware = true; // no graphics processor
    Trails trails;
    Coils coils;
    KeptExtent kept;
    Surroundings around;                    // of the last picture
    std::optional<Surroundings> keptAround; // of pictures before
    Keeps keeps = Keeps::nothing;

    ~Implementation() {
        if (context && context->makeCurrent()) {
            solids.reset();
            lines.reset();
            discs.reset();
            backdrop.reset();
            shadows.reset();
            groundShadow.reset();
            target.reset();
        }
    }

    [[nodiscard]] std::string build();
    void follow(const Drawing& drawing);
    void clear(const Drawing& drawing, const Frame& frame);
    // The sights of the maps that are drawn, nearest first; empty: nothing throws a shadow.
    [[nodiscard]] std::vector<LightSight> mapShadows(const Drawing& drawing, const Frame& frame,
                                                     std::span<const Solid> opaque,
                                                     const Light& light, double nearest,
                                                     double furthest);
    [[nodiscard]] bool paint(const Drawing& drawing, const Frame& frame);
    void paintJoints(const Drawing& drawing, const Frame& frame, const Projection& projection);
    void paintHandles(const Drawing& drawing, const Frame& frame, const Projection& projection,
                      bool joints);
    void paintContacts(const Drawing& drawing, const Frame& frame);
    [[nodiscard]] Vector sun() const;
    [[nodiscard]] Ground groundBelow(std::span<const Solid> all, const Frame& frame) const;
    void addGrids(const Ground& below, const Drawing& drawing, const Frame& frame);
    void paintMarks(const Drawing& drawing, const Frame& frame, const Projection& projection);
};

namespace {

// View z of what is nearest to the eye and of what is furthest away: all solids and the scene.
std::pair<double, double> depthRange(std::span<const Solid> solids, const Extent& extent,
                                     const Frame& frame) {
    const double size = frame.camera().scale * extent.size;
    const double middle = frame.toView(extent.box.center()).z();
    double nearest = middle + size, furthest = middle - 2 * size;
    for (const Solid& solid : solids) {
        nearest = std::max(nearest, solid.middle.z() + solid.radius);
        furthest = std::min(furthest, solid.middle.z() - solid.radius);
    }
    return {nearest, furthest};
}

void addRopes(Lines& lines, const Drawing& drawing, const Extent& extent, const Frame& frame) {
    const Ink ink{{0.42F, 0.30F, 0.18F}, 0.95F, frame.stroke(2)};
    for (const RopeLine& rope :
         ropeLinesOf(*drawing.scene, drawing.motion.get(), drawing.time, extent.up))
        for (std::size_t i = 1; i < rope.corners.size(); ++i)
            lines.add(frame.toView(rope.corners[i - 1]), frame.toView(rope.corners[i]), ink);
}

} // namespace

std::string Renderer::Implementation::build() {
    if (const std::string missing = gl.load(); !missing.empty())
        return "The graphics driver lacks " + missing + ": install libgl1-mesa-dri.";
    target = std::make_unique<Target>(gl);
    solids = std::make_unique<Solids>(gl);
    lines = std::make_unique<Lines>(gl);
    discs = std::make_unique<Discs>(gl);
    backdrop = std::make_unique<Backdrop>(gl);
    shadows = std::make_unique<ShadowMap>(gl);
    groundShadow = std::make_unique<GroundShadow>(gl);
    const auto* name = reinterpret_cast<const char*>(gl.GetString(GL_RENDERER));
    isSoftware = name == nullptr || std::string_view(name).starts_with("llvmpipe") ||
                 std::string_view(name).starts_with("softpipe");
    for (const std::string& fault : {solids->build(), lines->build(), discs->build(),
                                     backdrop->build(), groundShadow->build()})
        if (!fault.empty())
            return "The graphics driver refuses a shader: " + fault;
    return "";
}

void Renderer::Implementation::follow(const Drawing& drawing) {
    kept.follow(drawing);
    if (drawing.display.trails)
        trails.follow(drawing, kept.extent());
}

void Renderer::Implementation::clear(const Drawing& drawing, const Frame& frame) {
    const Display& display = drawing.display;
    const scene::Color& c = display.background;
    gl.ClearColor(static_cast<float>(c.red), static_cast<float>(c.green),
                  static_cast<float>(c.blue), 1);
    if (!display.studio) {
        gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        return;
    }
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    backdrop->show(frame, frame.directionInView(kept.extent().ground), isDark(c));
}

// Of a picture that moves, drawn in software, one sample is taken from a small map.
std::vector<LightSight> Renderer::Implementation::mapShadows(const Drawing& drawing,
                                                             const Frame& frame,
                                                             std::span<const Solid> opaque,
                                                             const Light& light, double nearest,
                                                             double furthest) {
    constexpr double nearRoom = -2, finer = 1.5; // view z; times as fine: worth a map of its own
    const int shorter = std::min(frame.size().width, frame.size().height);
    const bool quick = isSoftware && drawing.display.samples <= 1;
    int texels = 256;
    while (texels < (quick ? shorter / 2 : isSoftware ? shorter : 2 * shorter) && texels < 2048)
        texels *= 2;
    const std::vector<Solid> throwing = throwingShadows(opaque);
    std::vector<LightSight> sights;
    const auto add = [&](double until) {
        if (const auto sight = sightOf(light, throwing, visibleRoom(frame, nearest, until), texels))
            sights.push_back(*sight);
    };
    add(furthest);
    if (furthest < nearRoom && !sights.empty())
        add(nearRoom);
    if (sights.size() > 1 && sights[1].texel * finer > sights[0].texel)
        sights.pop_back();
    std::ranges::reverse(sights);
    if (sights.empty() || !shadows->begin(texels))
        return {};
    for (std::size_t i = 0; i < sights.size(); ++i) {
        sights[i].softness = std::max(1.6 / texels, 0.004);
        sights[i].samples = quick ? 1 : isSoftware ? 4 : 8;
        shadows->bind(i);
        solids->drawDepths(throwing, frame, sights[i].columns(), 1); // no fine outline
    }
    shadows->end();
    return sights;
}

// Over the bodies, with a rim of the background's colour, so that they are seen on any body.
void Renderer::Implementation::paintJoints(const Drawing& drawing, const Frame& frame,
                                           const Projection& projection) {
    lines->begin(frame, projection);
    const JointSigns signs = jointSignsOf(drawing, kept.extent(), frame);
    const scene::Color &ink = jointColor, &paper = drawing.display.background;
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.DepthMask(GL_FALSE);
    const auto add = [&](const scene::Color& c, float opacity, float wider) {
        for (const JointSigns::Stroke& one : signs.strokes)
            lines->add(one.from, one.to,
                       Ink{Eigen::Vector3d(c.red, c.green, c.blue).cast<float>(),
                           opacity * one.alphaFrom, one.width + wider},
                       opacity * one.alphaTo);
        lines->draw(0);
    };
    add(paper, 0.6F, frame.stroke(2));
    add(ink, 1, 0);
    gl.DepthMask(GL_TRUE);
    solids->drawOpaque(signs.solids, frame);
    gl.DepthMask(GL_FALSE);
    for (const Solid& solid : signs.solids)
        if (!std::holds_alternative<scene::HullShape>(solid.part->shape)) // a pin's sides are round
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
    lines->draw(2e-5F);
    gl.DepthMask(GL_TRUE);
}

// Faint where bodies hide them; only its own body hides no handle.
void Renderer::Implementation::paintHandles(const Drawing& drawing, const Frame& frame,
                                            const Projection& projection, bool joints) {
    const HandleSet made =
        drawing.handles ? HandleSet{}
                        : Handles(*drawing.scene, drawing.motion)
                              .at(drawing.time, drawing.display, frame.camera(), frame.size());
    const std::vector<Disc> marks = addHandles(*lines, drawing.handles ? *drawing.handles : made,
                                               frame, drawing.display.background, joints);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GREATER);
    lines->show(0, 0.3F);
    discs->show(marks, frame, projection, 0.3F);
    gl.DepthFunc(GL_LEQUAL);
    lines->draw(0);
    discs->show(marks, frame, projection);
    gl.DepthMask(GL_TRUE);
}

// Seen through the bodies, faintly: they begin where these touch.
void Renderer::Implementation::paintContacts(const Drawing& drawing, const Frame& frame) {
    if (!drawing.motion)
        return;
    addContactForces(*lines, simulation::contactForcesAt(*drawing.motion, drawing.time),
                     contactForceScale(*drawing.motion), frame, drawing.display);
    gl.DepthMask(GL_FALSE);
    gl.DepthFunc(GL_GREATER);
    lines->show(0, 0.6F);
    gl.DepthFunc(GL_LEQUAL);
    lines->draw(0);
    gl.DepthMask(GL_TRUE);
}

void Renderer::Implementation::paintMarks(const Drawing& drawing, const Frame& frame,
                                          const Projection& projection) {
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    if (drawing.display.rotationCenter) {
        const bool dark = isDark(drawing.display.background);
        const Eigen::Vector4f ink =
            dark ? Eigen::Vector4f(1, 1, 1, 0.85F) : Eigen::Vector4f(0.12F, 0.14F, 0.18F, 0.85F);
        const Eigen::Vector4f clear(ink.x(), ink.y(), ink.z(), 0);
        const Vector place = frame.toView(frame.camera().center);
        discs->show({{place, clear, ink, frame.stroke(9), frame.stroke(1.4)},
                     {place, ink, ink, frame.stroke(2.2), 0}},
                    frame, projection);
    }
    if (drawing.display.triad)
        showTriad(*lines, *discs, frame, drawing.display.background);
}

// The plane in front has the grid in place of the ground while one looks along an axis.
void Renderer::Implementation::addGrids(const Ground& below, const Drawing& drawing,
                                        const Frame& frame) {
    const Display& display = drawing.display;
    const Extent& extent = kept.extent();
    TakenRoom taken;
    const auto facing =
        display.studio ? facingPlane(drawing, extent.ground) : std::optional<FacingPlane>();
    if (facing)
        addGrid(*lines, facing->plane, extent, frame, display, {std::nullopt, facing->weight},
                taken);
    addGrid(*lines, below.plane, extent, frame, display,
            {below.floor, facing ? 1 - facing->weight : 1, below.shadowed.has_value()}, taken);
}

// Shadows stay while one edits, also where another motion would be seen from another side.
Vector Renderer::Implementation::sun() const {
    const Vector& up = kept.extent().up;
    const Vector now = sunOf(kept.extent());
    constexpr double rounding = 1e-9;
    const bool stays =
        keptAround && std::abs(keptAround->sun.dot(up) - now.dot(up)) < rounding; // as high
    return stays ? keptAround->sun : now;
}

Ground Renderer::Implementation::groundBelow(std::span<const Solid> all, const Frame& frame) const {
    Ground below = groundOf(all, kept.extent(), frame, *solids);
    if (!keptAround || !keptAround->ground || below.floor)
        return below;
    const GroundPlane& last = *keptAround->ground;
    const bool stays = last.up == below.plane.up &&
                       (keeps == Keeps::all || isGroundOf(kept.extent(), last.height));
    return stays ? Ground{last, std::nullopt, last} : below;
}

bool Renderer::Implementation::paint(const Drawing& drawing, const Frame& frame) {
    const Display& display = drawing.display;
    const Extent& extent = kept.extent();
    const std::vector<Solid> all = solidsOf(drawing, extent, frame);
    const auto firstTransparent =
        std::find_if(all.begin(), all.end(), [](const Solid& s) { return s.alpha < 1; });
    const std::span<const Solid> opaque(all.begin(), firstTransparent);
    const std::span<const Solid> transparent(firstTransparent, all.end());
    const auto [nearest, furthest] = depthRange(all, extent, frame);
    // Grids reach further, and handles may stand before everything.
    const bool isDeep = display.studio || showsHandles(display);
    const double back = display.studio && !frame.camera().orthographic ? -3000.0 : -40.0;
    const Projection projection =
        isDeep ? frame.projection(std::max(nearest, eyeDistance - 0.5), std::min(furthest, back))
               : frame.projection(nearest, furthest);
    const std::vector<Light> lights = lightsOf(*drawing.scene, sun(), frame);
    const Light& shadowing = lights[static_cast<std::size_t>(shadowedOf(lights))];
    const float lift = 2e-5F;

    std::vector<LightSight> sights;
    if (display.shadows && !display.wireframe)
        sights = mapShadows(drawing, frame, opaque, shadowing, nearest, furthest);
    if (!target->prepare(frame.size(), display.samples))
        return false;
    gl.Viewport(0, 0, frame.size().width, frame.size().height);
    clear(drawing, frame);
    lines->begin(frame, projection);
    solids->begin(frame, lights, frame.directionInView(extent.up), projection.data(), sights);
    if (display.wireframe) {
        for (const Solid& solid : all)
            addWireframe(*lines, solid, solids->meshOf(solid, frame), frame);
    } else {
        gl.Enable(GL_POLYGON_OFFSET_FILL);
        solids->drawOpaque(opaque, frame);
        gl.Disable(GL_POLYGON_OFFSET_FILL);
    }
    gl.Enable(GL_BLEND);
    gl.DepthMask(GL_FALSE);
    around = {std::nullopt, sun()};
    if (display.grid) {
        const Ground below = groundBelow(all, frame);
        around.ground = below.plane;
        if (!sights.empty() && below.shadowed)
            groundShadow->show(*below.shadowed, shadowing, sights, frame, projection.data(),
                               isDark(display.background) ? 0.45F : 0.28F);
        addGrids(below, drawing, frame);
        lines->draw(lift);
    }
    if (!display.wireframe)
        for (const Solid& solid : opaque)
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
    if (display.trails)
        trails.add(*lines, drawing, frame);
    coils.add(*lines, drawing, extent.size, frame);
    addRopes(*lines, drawing, extent, frame);
    if (display.axes)
        addAxes(*lines, extent, frame);
    lines->draw(lift);
    if (!display.wireframe)
        for (const Solid& solid : transparent) {
            solids->drawTransparent(solid, frame);
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
            lines->draw(lift);
        }
    gl.DepthMask(GL_TRUE);
    if (display.contactForces || display.frictionCones)
        paintContacts(drawing, frame);
    if (showsHandles(display))
        paintHandles(drawing, frame, projection, false);
    if (display.joints && !drawing.scene->joints.empty())
        paintJoints(drawing, frame, projection);
    if (display.jointHandles)
        paintHandles(drawing, frame, projection, true);
    if (display.triad || display.rotationCenter)
        paintMarks(drawing, frame, projection);
    gl.Disable(GL_BLEND);
    return true;
}

Renderer::Renderer() : implementation_(std::make_unique<Implementation>()) {}
Renderer::~Renderer() = default;

std::variant<std::unique_ptr<Renderer>, std::string> Renderer::create() {
    auto context = Context::create();
    if (const std::string* fault = std::get_if<std::string>(&context))
        return *fault;
    std::unique_ptr<Renderer> renderer(new Renderer);
    renderer->implementation_->context = std::move(std::get<0>(context));
    if (std::string fault = renderer->implementation_->build(); !fault.empty())
        return fault;
    return renderer;
}

bool Renderer::draw(const Drawing& drawing, const Image& into, std::optional<Surroundings>* last,
                    Keeps keeps) {
    Implementation& my = *implementation_;
    const Size size = into.size;
    const bool fits =
        size.width > 0 && size.height > 0 &&
        into.stride >= 4U * static_cast<unsigned>(size.width) &&
        into.pixels.size() >= into.stride * static_cast<std::size_t>(size.height - 1) +
                                  4U * static_cast<unsigned>(size.width);
    if (!fits || drawing.scene == nullptr || !my.context->makeCurrent())
        return false;
    const Gl& gl = my.gl;
    gl.FrontFace(GL_CW); // the picture is drawn upside down
    gl.CullFace(GL_BACK);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.PolygonOffset(1, 1);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    my.follow(drawing);
    my.keeps = keeps;
    my.keptAround = last && keeps != Keeps::nothing ? *last : std::nullopt;
    if (!my.paint(drawing, Frame(drawing, size)))
        return false;
    if (last) {
        *last = my.around;
        if (!my.around.ground && my.keptAround && keeps == Keeps::all) // it may be shown again
            (*last)->ground = my.keptAround->ground;
    }
    my.target->read(into);
    return gl.GetError() == GL_NO_ERROR;
}

const Renderer::Surroundings& Renderer::surroundings() const { return implementation_->around; }

int Renderer::maximumSamples() const {
    GLint most = 1;
    if (implementation_->context->makeCurrent())
        implementation_->gl.GetIntegerv(GL_MAX_SAMPLES, &most);
    return std::max(1, most);
}

int Renderer::maximumSize() const {
    GLint most = 0;
    if (implementation_->context->makeCurrent())
        implementation_->gl.GetIntegerv(GL_MAX_RENDERBUFFER_SIZE, &most);
    return most;
}

std::string Renderer::description() const {
    if (!implementation_->context->makeCurrent())
        return "the graphics context is lost";
    const auto text = [&](GLenum what) {
        const GLubyte* s = implementation_->gl.GetString(what);
        return std::string(s == nullptr ? "?" : reinterpret_cast<const char*>(s));
    };
    return text(GL_RENDERER) + ", OpenGL " + text(GL_VERSION);
}

} // namespace render
