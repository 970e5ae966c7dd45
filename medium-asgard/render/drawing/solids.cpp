#include "drawing/solids.h"

#include "drawing/shaders.h"

#include <algorithm>
#include <cstddef>
#include <iterator>

namespace render {

namespace {

// Where a part's mesh stands in the part's frame, and the ball about it.
struct Fit {
    Vector edges = Vector::Ones(); // the mesh is scaled by these
    Vector middle = Vector::Zero();
    double radius = 0;
};

Fit fitOf(const scene::Part& part) {
    if (const auto* sphere = std::get_if<scene::SphereShape>(&part.shape))
        return {Vector::Constant(sphere->radius), Vector::Zero(), sphere->radius};
    if (const auto* box = std::get_if<scene::BoxShape>(&part.shape))
        return {box->edges, Vector::Zero(), box->edges.norm() / 2};
    const auto* hull = std::get_if<scene::HullShape>(&part.shape);
    if (!hull) // in its own sizes
        return {Vector::Ones(), Vector::Zero(), scene::reachOf(part)};
    Fit fit;
    Eigen::AlignedBox3d bounds;
    for (const Vector& p : hull->points)
        bounds.extend(p);
    if (!bounds.isEmpty()) {
        fit.middle = bounds.center();
        fit.radius = bounds.sizes().norm() / 2;
    }
    return fit;
}

// What is not given is inherited: part, body, shape set.
template <class T>
T inherited(std::optional<T> scene::Appearance::*what, const scene::Part& part,
            const scene::Body& body, const scene::ShapeSet& shape, T otherwise) {
    for (const scene::Appearance* a : {&part.appearance, &body.appearance, &shape.appearance})
        if ((a->*what).has_value())
            return *(a->*what);
    return otherwise;
}

// A floor without an end that nobody has coloured fills the picture: in a dark one it is dark.
scene::Color plainColor(const scene::Part& part, const Display& display) {
    const bool isNight = display.studio && isDark(display.background) &&
                         std::holds_alternative<scene::PlaneShape>(part.shape);
    return isNight ? scene::Color{0.27, 0.28, 0.30} : scene::Color{};
}

Solid solidOf(const scene::Part& part, const scene::Body& body, const scene::ShapeSet& shape,
              const geometry::Pose& pose, const Frame& frame, const Display& display) {
    using scene::Appearance;
    const Fit fit = fitOf(part);
    Solid solid;
    solid.part = &part;
    const Eigen::Matrix3d turn =
        frame.linear() *
        (pose.attitude * geometry::fromRotationVector(part.rotation)).toRotationMatrix();
    solid.linear = turn * fit.edges.asDiagonal();
    solid.place = frame.toView(pose.toWorld(part.position));
    solid.middle = solid.place + turn * fit.middle;
    solid.radius = frame.camera().scale * fit.radius;
    const scene::Color c =
        inherited(&Appearance::color, part, body, shape, plainColor(part, display));
    solid.color = Eigen::Vector3d(c.red, c.green, c.blue).cast<float>();
    solid.alpha =
        static_cast<float>(1 - inherited(&Appearance::transparency, part, body, shape, 0.0));
    solid.shininess =
        static_cast<float>(inherited(&Appearance::shininess, part, body, shape, 0.35));
    return solid;
}

// Of a half space a square about what the picture shows, as wide as it can be seen; in a studio it
// meets the horizon.
void showPlane(Solid& solid, const geometry::Pose& pose, const Extent& extent, const Frame& frame,
               bool inStudio) {
    constexpr double wide = 4;        // of the scene's size
    constexpr double toHorizon = 300; // view units: within a pixel or two
    const scene::Part& part = *solid.part;
    const geometry::Quaternion turn = pose.attitude * geometry::fromRotationVector(part.rotation);
    const Vector up = turn * Vector::UnitY(), origin = pose.toWorld(part.position);
    const Vector middle = extent.box.center();
    const double half =
        std::max(wide * extent.size, inStudio ? toHorizon / frame.camera().scale : 0);
    solid.linear = frame.linear() * turn.toRotationMatrix() * half;
    solid.place = solid.middle = frame.toView(middle - up * up.dot(middle - origin));
    solid.radius = std::sqrt(2) * half * frame.camera().scale;
}

bool isBall(const scene::ShapeSet& shape) {
    return shape.parts.size() == 1 &&
           std::holds_alternative<scene::SphereShape>(shape.parts.front().shape);
}

bool isTrue(const std::vector<bool>& of, std::size_t body) { return body < of.size() && of[body]; }

} // namespace

Eigen::Vector3f colorOf(const scene::Scene& scene, const scene::Body& body) {
    scene::Color c;
    if (const scene::ShapeSet* shape = scene::findShapeSet(scene, body.shape);
        shape != nullptr && !shape->parts.empty())
        c = inherited(&scene::Appearance::color, shape->parts.front(), body, *shape, c);
    return Eigen::Vector3d(c.red, c.green, c.blue).cast<float>();
}

std::vector<Solid> solidsOf(const Drawing& drawing, const Extent& extent, const Frame& frame) {
    std::vector<Solid> solids;
    for (std::size_t i = 0; i < drawing.scene->bodies.size(); ++i) {
        const scene::Body& body = drawing.scene->bodies[i];
        const scene::ShapeSet* shape = scene::findShapeSet(*drawing.scene, body.shape);
        const geometry::Pose pose = poseOf(*drawing.scene, drawing.motion.get(), i, drawing.time);
        if (shape == nullptr || isHidden(drawing.display, body) || !pose.position.allFinite() ||
            !pose.attitude.coeffs().allFinite())
            continue;
        for (const scene::Part& part : shape->parts) {
            solids.push_back(solidOf(part, body, *shape, pose, frame, drawing.display));
            solids.back().body = i;
            if (std::holds_alternative<scene::PlaneShape>(part.shape))
                showPlane(solids.back(), pose, extent, frame, drawing.display.studio);
            solids.back().isMarked = (isBall(*shape) && isTrue(extent.turns, i)) ||
                                     (isRoundAboutY(part) && isTrue(extent.spins, i));
        }
    }
    std::erase_if(solids, [](const Solid& s) { return s.alpha <= 0; });
    const auto firstTransparent = std::stable_partition(
        solids.begin(), solids.end(), [](const Solid& s) { return s.alpha >= 1; });
    const Vector eye = frame.eye();
    std::stable_sort(firstTransparent, solids.end(), [&](const Solid& a, const Solid& b) {
        return (a.middle - eye).squaredNorm() > (b.middle - eye).squaredNorm();
    });
    return solids;
}

Solids::~Solids() {
    for (auto& [key, stored] : meshes_)
        release(*stored);
    gl_.DeleteBuffers(1, &instances_);
}

std::string Solids::build() {
    gl_.GenBuffers(1, &instances_);
    std::string fault = program_.build(solidVertexShader, {shadowFunctions, solidFragmentShader});
    return fault.empty() ? depths_.build(solidVertexShader, {depthFragmentShader}) : fault;
}

void Solids::begin(const Frame& frame, const std::vector<Light>& lights, const Vector& upInView,
                   const float* projection, std::span<const LightSight> sights) {
    ++picture_;
    forgetUnused();
    program_.use();
    gl_.UniformMatrix4fv(program_.place("projection"), 1, GL_FALSE, projection);
    gl_.Uniform1f(program_.place("eye"), static_cast<float>(frame.eye().z()));
    const Eigen::Vector3f up = upInView.cast<float>();
    gl_.Uniform3fv(program_.place("up"), 1, up.data());
    float places[4 * mostLights]{}, colors[3 * mostLights]{};
    for (std::size_t i = 0; i < lights.size(); ++i) {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            places[4 * i + k] = static_cast<float>(lights[i].place[axis]);
            colors[3 * i + k] = lights[i].color[axis];
        }
        places[4 * i + 3] = lights[i].isPoint ? 1.0F : 0.0F;
    }
    gl_.Uniform1i(program_.place("lights"), static_cast<GLint>(lights.size()));
    gl_.Uniform4fv(program_.place("lightPlace"), mostLights, places);
    gl_.Uniform3fv(program_.place("lightColor"), mostLights, colors);
    // Faces that the sun does not reach differ in brightness, too.
    const float beside = std::ranges::any_of(lights, &Light::isSun) ? 0.16F : 0.0F;
    gl_.Uniform3f(program_.place("beside"), beside, beside, 1.1F * beside);
    gl_.Uniform1i(program_.place("shadowed"), sights.empty() ? -1 : shadowedOf(lights));
    if (!sights.empty())
        program_.giveShadow(sights);
}

const Mesh& Solids::meshOf(const Solid& solid, const Frame& frame) {
    return stored(solid, frame).mesh;
}

namespace {

struct MeshKey {
    double fineness; // in pixels: of the ball about it
    int coarser;
    [[nodiscard]] double level() const { return std::max(1, sphereLevel(fineness) - coarser); }
    [[nodiscard]] double sides() const { return std::max(12, ringSides(fineness) >> coarser); }

    std::vector<double> operator()(const scene::SphereShape&) const { return {0, level()}; }
    std::vector<double> operator()(const scene::BoxShape&) const { return {1}; }
    std::vector<double> operator()(const scene::HullShape& hull) const {
        std::vector<double> key{2};
        for (const Vector& p : hull.points)
            key.insert(key.end(), p.begin(), p.end());
        return key;
    }
    std::vector<double> operator()(const scene::CylinderShape& c) const {
        return {3, sides(), c.radius, c.height};
    }
    std::vector<double> operator()(const scene::ConeShape& c) const {
        return {4, sides(), c.radius, c.height};
    }
    std::vector<double> operator()(const scene::CapsuleShape& c) const {
        return {5, sides(), c.radius, c.height};
    }
    std::vector<double> operator()(const scene::EllipsoidShape& e) const {
        return {6, level(), e.axes.x(), e.axes.y(), e.axes.z()};
    }
    std::vector<double> operator()(const scene::PlaneShape&) const { return {7}; }
    std::vector<double> operator()(const scene::TubeShape& t) const {
        return {8, sides(), t.inner, t.outer, t.height};
    }
    std::vector<double> operator()(const scene::BowlShape& b) const {
        return {9, sides(), b.inner, b.outer};
    }
};

struct MeshMaker {
    const std::vector<double>& key;
    [[nodiscard]] int fineness() const { return static_cast<int>(key[1]); }

    Mesh operator()(const scene::SphereShape&) const { return sphereMesh(fineness()); }
    Mesh operator()(const scene::BoxShape&) const {
        return polyhedronMesh(geometry::box(Vector::Ones()));
    }
    Mesh operator()(const scene::HullShape& hull) const { return hullMesh(hull.points); }
    Mesh operator()(const scene::CylinderShape& c) const {
        return cylinderMesh(c.radius, c.height, fineness());
    }
    Mesh operator()(const scene::ConeShape& c) const {
        return coneMesh(c.radius, c.height, fineness());
    }
    Mesh operator()(const scene::CapsuleShape& c) const {
        return capsuleMesh(c.radius, c.height, fineness());
    }
    Mesh operator()(const scene::EllipsoidShape& e) const {
        return ellipsoidMesh(e.axes, fineness());
    }
    Mesh operator()(const scene::PlaneShape&) const { return squareMesh(); }
    Mesh operator()(const scene::TubeShape& t) const {
        return tubeMesh(t.inner, t.outer, t.height, fineness());
    }
    Mesh operator()(const scene::BowlShape& b) const {
        return bowlMesh(b.inner, b.outer, fineness());
    }
};

} // namespace

Solids::Stored& Solids::stored(const Solid& solid, const Frame& frame, int coarser) {
    const Key key = std::visit(MeshKey{frame.pixels(solid.radius, solid.middle.z()), coarser},
                               solid.part->shape);
    std::unique_ptr<Stored>& entry = meshes_[key];
    if (!entry) {
        entry = std::make_unique<Stored>();
        entry->mesh = std::visit(MeshMaker{key}, solid.part->shape);
        upload(*entry);
    }
    entry->used = picture_;
    return *entry;
}

void Solids::upload(Stored& stored) {
    gl_.GenVertexArrays(1, &stored.array);
    gl_.GenBuffers(1, &stored.vertices);
    gl_.GenBuffers(1, &stored.indices);
    gl_.BindVertexArray(stored.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, stored.vertices);
    gl_.BufferData(GL_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(stored.mesh.vertices.size() * sizeof(float)),
                   stored.mesh.vertices.data(), GL_STATIC_DRAW);
    for (GLuint i = 0; i < 2; ++i) {
        gl_.EnableVertexAttribArray(i);
        const std::size_t offset = 3 * i * sizeof(float);
        gl_.VertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 6 * sizeof(float), asPointer(offset));
    }
    gl_.BindBuffer(GL_ELEMENT_ARRAY_BUFFER, stored.indices);
    gl_.BufferData(GL_ELEMENT_ARRAY_BUFFER,
                   static_cast<GLsizeiptr>(stored.mesh.indices.size() * sizeof(std::uint32_t)),
                   stored.mesh.indices.data(), GL_STATIC_DRAW);
}

void Solids::release(Stored& stored) {
    gl_.DeleteVertexArrays(1, &stored.array);
    gl_.DeleteBuffers(1, &stored.vertices);
    gl_.DeleteBuffers(1, &stored.indices);
}

// Shapes that are being edited leave a mesh behind with each change.
void Solids::forgetUnused() {
    constexpr std::size_t many = 256;
    if (meshes_.size() <= many)
        return;
    std::erase_if(meshes_, [&](auto& entry) {
        const bool old = entry.second->used + 2 < picture_;
        if (old)
            release(*entry.second);
        return old;
    });
}

Solids::Instance Solids::instanceOf(const Solid& solid) {
    Instance instance{};
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column)
            instance.rows[4 * row + column] = static_cast<float>(solid.linear(row, column));
        instance.rows[4 * row + 3] = static_cast<float>(solid.place[row]);
        // Nothing is quite black: light shows its form.
        instance.color[row] = static_cast<float>(0.012 + 0.988 * linearLight(solid.color[row]));
    }
    instance.color[3] = solid.alpha;
    instance.material[0] = solid.shininess;
    if (solid.isMarked)
        instance.material[1] = isRoundAboutY(*solid.part) ? -0.16F : 0.16F;
    return instance;
}

void Solids::drawInstances(Stored& stored, const std::vector<Instance>& instances) {
    gl_.BindVertexArray(stored.array);
    gl_.BindBuffer(GL_ARRAY_BUFFER, instances_);
    gl_.BufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(instances.size() * sizeof(Instance)),
                   instances.data(), GL_STREAM_DRAW);
    const std::size_t offsets[] = {offsetof(Instance, rows), offsetof(Instance, rows) + 16,
                                   offsetof(Instance, rows) + 32, offsetof(Instance, color),
                                   offsetof(Instance, material)};
    for (GLuint i = 0; i < 5; ++i) {
        gl_.EnableVertexAttribArray(2 + i);
        gl_.VertexAttribPointer(2 + i, i < 4 ? 4 : 2, GL_FLOAT, GL_FALSE, sizeof(Instance),
                                asPointer(offsets[i]));
        gl_.VertexAttribDivisor(2 + i, 1);
    }
    gl_.DrawElementsInstanced(GL_TRIANGLES, static_cast<GLsizei>(stored.mesh.indices.size()),
                              GL_UNSIGNED_INT, nullptr, static_cast<GLsizei>(instances.size()));
}

void Solids::drawGrouped(const Program& program, std::span<const Solid> solids, const Frame& frame,
                         int coarser) {
    std::vector<std::pair<Stored*, std::vector<Instance>>> groups; // in order of first use
    std::map<const Stored*, std::size_t> places;
    for (const Solid& solid : solids) {
        Stored& mesh = stored(solid, frame, coarser);
        const auto [place, isNew] = places.try_emplace(&mesh, groups.size());
        if (isNew)
            groups.emplace_back(&mesh, std::vector<Instance>{});
        groups[place->second].second.push_back(instanceOf(solid));
    }
    program.use();
    for (auto& [mesh, instances] : groups)
        drawInstances(*mesh, instances);
}

void Solids::drawOpaque(std::span<const Solid> solids, const Frame& frame) {
    gl_.Enable(GL_CULL_FACE);
    drawGrouped(program_, solids, frame);
}

void Solids::drawTransparent(const Solid& solid, const Frame& frame) {
    Stored& mesh = stored(solid, frame);
    program_.use();
    gl_.Enable(GL_CULL_FACE);
    for (GLenum hidden : {GL_FRONT, GL_BACK}) {
        gl_.CullFace(hidden);
        drawInstances(mesh, {instanceOf(solid)});
    }
    gl_.CullFace(GL_BACK);
}

void Solids::drawDepths(std::span<const Solid> solids, const Frame& frame,
                        const std::array<float, 16>& matrix, int coarser) {
    depths_.use();
    gl_.UniformMatrix4fv(depths_.place("projection"), 1, GL_FALSE, matrix.data());
    gl_.Enable(GL_CULL_FACE);
    drawGrouped(depths_, solids, frame, coarser);
}

} // namespace render
