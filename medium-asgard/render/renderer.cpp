#include "render/renderer.h"

#include "render/coils.h"
#include "render/context.h"
#include "render/ground.h"
#include "render/handles.h"
#include "render/joint_places.h"
#include "render/joint_signs.h"
#include "render/overlay.h"
#include "render/rope_lines.h"
#include "render/solids.h"
#include "render/target.h"
#include "render/trails.h"

#include <algorithm>
#include <cmath>

namespace render {

struct Renderer::Implementation {
    std::unique_ptr<Context> context;
    Gl gl;
    std::unique_ptr<Target> target;
    std::unique_ptr<Solids> solids;
    std::unique_ptr<Lines> lines;
    Trails trails;
    Coils coils;

    // The extent of the motion that was drawn last.
    std::weak_ptr<const simulation::Motion> extentOfMotion;
    std::vector<scene::Body> extentOfBodies;
    std::vector<Vector> extentOfAnchors; // of springs, joints and ropes in the world
    Extent extent;

    ~Implementation() {
        if (context && context->makeCurrent()) {
            solids.reset();
            lines.reset();
            target.reset();
        }
    }

    [[nodiscard]] std::string build();
    void follow(const Drawing& drawing);
    void paint(const Drawing& drawing, const Frame& frame);
    void paintGround(std::span<const Solid> opaque, const Frame& frame, const float* projection);
    void paintJoints(const Drawing& drawing, const Frame& frame, const float* projection);
    void paintHandles(const Drawing& drawing, const Frame& frame, const float* projection);
};

namespace {

bool sameOutlines(const std::vector<scene::Body>& a, const std::vector<scene::Body>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.shape == y.shape && x.initialPosition == y.initialPosition &&
               x.initialAttitude.coeffs() == y.initialAttitude.coeffs() && x.fixed == y.fixed;
    });
}

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
    for (const std::string& fault : {solids->build(), lines->build()})
        if (!fault.empty())
            return "The graphics driver refuses a shader: " + fault;
    return "";
}

void Renderer::Implementation::follow(const Drawing& drawing) {
    std::vector<Vector> anchors = anchorsOf(*drawing.scene, drawing.motion.get());
    std::ranges::copy(jointAnchorsOf(*drawing.scene, drawing.motion.get()),
                      std::back_inserter(anchors));
    std::ranges::copy(ropeAnchorsOf(*drawing.scene), std::back_inserter(anchors));
    const bool same = extentOfMotion.lock() == drawing.motion && extentOfAnchors == anchors &&
                      sameOutlines(extentOfBodies, drawing.scene->bodies);
    if (!same) {
        extent = extentOf(*drawing.scene, drawing.motion.get());
        extentOfMotion = drawing.motion;
        extentOfBodies = drawing.scene->bodies;
        extentOfAnchors = std::move(anchors);
    }
    if (drawing.display.trails)
        trails.follow(drawing, extent);
}

// The grid under the scene, and the bodies' shadows on it or on the scene's own floor.
void Renderer::Implementation::paintGround(std::span<const Solid> opaque, const Frame& frame,
                                           const float* projection) {
    const std::optional<Floor> floor = floorOf(opaque, extent, frame, *solids);
    const Plane plane = floor ? floor->plane : groundOf(extent, frame);
    gl.DepthMask(GL_FALSE);
    if (!opaque.empty() && eyeDistance * plane.normal.z() > plane.offset) {
        gl.Enable(GL_STENCIL_TEST);
        if (floor) {
            gl.StencilFunc(GL_ALWAYS, 1, 0xFF);
            gl.StencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);
            gl.Enable(GL_POLYGON_OFFSET_FILL);
            solids->drawFacesOn(opaque[floor->solid], frame, plane);
            gl.Disable(GL_POLYGON_OFFSET_FILL);
        }
        // Each pixel of the ground is darkened once, whatever lies over it.
        gl.StencilFunc(GL_EQUAL, floor ? 1 : 0, 0xFF);
        gl.StencilOp(GL_KEEP, GL_KEEP, GL_INCR);
        solids->drawShadows(opaque, frame, plane, 0.5 * extent.size * frame.camera().scale);
        gl.Disable(GL_STENCIL_TEST);
    }
    addGrid(*lines, extent, frame, floor ? 0.55 : 1);
    lines->draw(projection, frame.halfSize(), 0);
    gl.DepthMask(GL_TRUE);
}

// Over the bodies, with a rim of the background's colour, so that they are seen on any body.
void Renderer::Implementation::paintJoints(const Drawing& drawing, const Frame& frame,
                                           const float* projection) {
    const JointSigns signs = jointSignsOf(drawing, extent, frame);
    const scene::Color &ink = jointColor, &paper = drawing.display.background;
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    gl.DepthMask(GL_FALSE);
    const auto add = [&](const scene::Color& c, float opacity, float wider) {
        for (const JointSigns::Stroke& one : signs.strokes)
            lines->add(one.from, one.to,
                       Ink{Eigen::Vector3d(c.red, c.green, c.blue).cast<float>(),
                           opacity * one.alphaFrom, one.width + wider},
                       opacity * one.alphaTo);
        lines->draw(projection, frame.halfSize(), 0);
    };
    add(paper, 0.6F, frame.stroke(2));
    add(ink, 1, 0);
    gl.DepthMask(GL_TRUE);
    solids->drawOpaque(signs.solids, frame);
    gl.DepthMask(GL_FALSE);
    for (const Solid& solid : signs.solids)
        if (!std::holds_alternative<scene::HullShape>(solid.part->shape)) // a pin's sides are round
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
    lines->draw(projection, frame.halfSize(), 2e-5F);
    gl.DepthMask(GL_TRUE);
}

void Renderer::Implementation::paintHandles(const Drawing& drawing, const Frame& frame,
                                            const float* projection) {
    static const scene::Part ball{scene::SphereShape{1}, Vector::Zero(), Vector::Zero(), {}};
    const HandleSet made =
        drawing.handles ? HandleSet{}
                        : Handles(*drawing.scene, drawing.motion).at(drawing.time, drawing.display);
    const HandleSet& set = drawing.handles ? *drawing.handles : made;
    const auto inkOf = [&](HandleKind kind, double width) {
        const scene::Color c = colorOf(kind);
        return Ink{0.8F * Eigen::Vector3d(c.red, c.green, c.blue).cast<float>(), 0.9F,
                   frame.stroke(width)};
    };
    gl.Clear(GL_DEPTH_BUFFER_BIT);
    for (const HandleLine& line : set.lines)
        for (std::size_t i = 0; i + 1 < line.points.size(); ++i)
            lines->add(frame.toView(line.points[i]), frame.toView(line.points[i + 1]),
                       inkOf(line.kind, 1.5));
    for (const Handle& handle : set.handles)
        if (handle.isArrow())
            addArrow(*lines, frame, handle.base, handle.place,
                     inkOf(handle.kind, handle.kind == HandleKind::orientation ? 1.2 : 2));
    lines->draw(projection, frame.halfSize(), 0);
    for (int kind = 0; kind <= static_cast<int>(HandleKind::trajectoryPoint); ++kind) {
        gl.Clear(GL_DEPTH_BUFFER_BIT); // nothing hides a handle but one of its own kind
        std::vector<Solid> balls;
        for (const Handle& handle : set.handles) {
            if (handle.kind != static_cast<HandleKind>(kind) || !handle.movable)
                continue;
            const scene::Color c = colorOf(handle.kind);
            Solid solid;
            solid.part = &ball;
            solid.place = solid.middle = frame.toView(handle.place);
            solid.radius = frame.stroke(radiusOf(handle.kind)) /
                           std::max(frame.pixels(1, solid.place.z()), 1e-12);
            solid.linear = solid.radius * Eigen::Matrix3d::Identity();
            solid.color = Eigen::Vector3d(c.red, c.green, c.blue).cast<float>();
            solid.shininess = 0.5F;
            balls.push_back(solid);
        }
        solids->drawOpaque(balls, frame);
    }
}

void Renderer::Implementation::paint(const Drawing& drawing, const Frame& frame) {
    const Display& display = drawing.display;
    const std::vector<Solid> all = solidsOf(drawing, extent, frame);
    const auto firstTransparent =
        std::find_if(all.begin(), all.end(), [](const Solid& s) { return s.alpha < 1; });
    const std::span<const Solid> opaque(all.begin(), firstTransparent);
    const std::span<const Solid> transparent(firstTransparent, all.end());
    const auto [nearest, furthest] = depthRange(all, extent, frame);
    const std::array<float, 16> projection = frame.projection(nearest, furthest);
    const float lift = 2e-5F;

    solids->begin(frame, lightsOf(*drawing.scene, frame), frame.directionInView(extent.up),
                  projection.data());
    if (display.wireframe) {
        for (const Solid& solid : all)
            addWireframe(*lines, solid, solids->meshOf(solid, frame), frame);
    } else {
        gl.Enable(GL_POLYGON_OFFSET_FILL);
        solids->drawOpaque(opaque, frame);
        gl.Disable(GL_POLYGON_OFFSET_FILL);
    }
    gl.Enable(GL_BLEND);
    if (display.grid)
        paintGround(display.wireframe ? std::span<const Solid>{} : opaque, frame,
                    projection.data());
    gl.DepthMask(GL_FALSE);
    if (!display.wireframe)
        for (const Solid& solid : opaque)
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
    if (display.trails)
        trails.add(*lines, drawing, frame);
    coils.add(*lines, drawing, extent.size, frame);
    addRopes(*lines, drawing, extent, frame);
    if (display.axes)
        addAxes(*lines, extent, frame);
    lines->draw(projection.data(), frame.halfSize(), lift);
    if (!display.wireframe)
        for (const Solid& solid : transparent) {
            solids->drawTransparent(solid, frame);
            addEdges(*lines, solid, solids->meshOf(solid, frame), frame);
            lines->draw(projection.data(), frame.halfSize(), lift);
        }
    gl.DepthMask(GL_TRUE);
    if (display.joints && !drawing.scene->joints.empty())
        paintJoints(drawing, frame, projection.data());
    if (showsHandles(display))
        paintHandles(drawing, frame, projection.data());
    gl.Disable(GL_BLEND);
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

bool Renderer::draw(const Drawing& drawing, const Image& into) {
    Implementation& my = *implementation_;
    const Size size = into.size;
    const bool fits =
        size.width > 0 && size.height > 0 &&
        into.stride >= 4U * static_cast<unsigned>(size.width) &&
        into.pixels.size() >= into.stride * static_cast<std::size_t>(size.height - 1) +
                                  4U * static_cast<unsigned>(size.width);
    if (!fits || drawing.scene == nullptr || !my.context->makeCurrent() ||
        !my.target->prepare(size, drawing.display.samples))
        return false;
    const Gl& gl = my.gl;
    gl.Viewport(0, 0, size.width, size.height);
    gl.FrontFace(GL_CW); // the picture is drawn upside down
    gl.CullFace(GL_BACK);
    gl.Enable(GL_DEPTH_TEST);
    gl.DepthFunc(GL_LEQUAL);
    gl.DepthMask(GL_TRUE);
    gl.PolygonOffset(1, 1);
    gl.BlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE);
    const scene::Color& c = drawing.display.background;
    gl.ClearColor(static_cast<float>(c.red), static_cast<float>(c.green),
                  static_cast<float>(c.blue), 1);
    gl.Clear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    my.follow(drawing);
    my.paint(drawing, Frame(drawing, size));
    my.target->read(into);
    return gl.GetError() == GL_NO_ERROR;
}

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
