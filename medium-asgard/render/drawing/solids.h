// Draws the parts of all bodies: opaque ones instanced by mesh, transparent ones back to front.
#pragma once

#include "drawing/frame.h"
#include "drawing/mesh.h"
#include "drawing/program.h"
#include "framing/extent.h"

#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace render {

// A part as it stands in one picture.
struct Solid {
    const scene::Part* part = nullptr;
    std::size_t body = 0;
    Eigen::Matrix3d linear; // mesh to view
    Vector place;           // view: the mesh's origin
    Vector middle;          // view
    double radius = 0;      // view: of the ball about the middle that holds it
    Eigen::Vector3f color;  // sRGB
    float alpha = 1;
    float shininess = 0;
    // Two quarters are darker, so that one sees it turn: across z of a ball, about y of the others.
    bool isMarked = false;

    [[nodiscard]] Vector toView(const Vector& inMesh) const { return linear * inMesh + place; }
};

// The colour that most shows of a body: its own, else its first part's.
[[nodiscard]] Eigen::Vector3f colorOf(const scene::Scene& scene, const scene::Body& body);

// All parts of the scene at the drawing's time, opaque first, transparent ones from back to front.
[[nodiscard]] std::vector<Solid> solidsOf(const Drawing& drawing, const Extent& extent,
                                          const Frame& frame);

class Solids {
public:
    explicit Solids(const Gl& gl) : gl_(gl), program_(gl), depths_(gl) {}
    ~Solids();
    Solids(const Solids&) = delete;
    Solids& operator=(const Solids&) = delete;

    [[nodiscard]] std::string build();

    // The mesh of a solid, as fine as its size in the picture needs.
    [[nodiscard]] const Mesh& meshOf(const Solid& solid, const Frame& frame);

    // Light comes through the shadow map that is bound, as `sight` says; none: there are no
    // shadows.
    void begin(const Frame& frame, const std::vector<Light>& lights, const Vector& upInView,
               const float* projection, std::span<const LightSight> sights);
    void drawOpaque(std::span<const Solid> solids, const Frame& frame);
    // One solid, its back faces before its front faces.
    void drawTransparent(const Solid& solid, const Frame& frame);
    // Only their depths, through that matrix to clip space; `coarser`: levels of their meshes.
    void drawDepths(std::span<const Solid> solids, const Frame& frame,
                    const std::array<float, 16>& matrix, int coarser);

private:
    struct Instance {
        float rows[12], color[4], material[2];
    };
    struct Stored {
        Mesh mesh;
        GLuint array = 0, vertices = 0, indices = 0;
        unsigned used = 0; // the last picture that needed it
    };
    using Key = std::vector<double>; // what the mesh depends on

    Stored& stored(const Solid& solid, const Frame& frame, int coarser = 0);
    void upload(Stored& stored);
    void release(Stored& stored);
    void forgetUnused();
    void drawInstances(Stored& stored, const std::vector<Instance>& instances);
    static Instance instanceOf(const Solid& solid);
    void drawGrouped(const Program& program, std::span<const Solid> solids, const Frame& frame,
                     int coarser = 0);

    const Gl& gl_;
    Program program_, depths_;
    GLuint instances_ = 0;
    std::map<Key, std::unique_ptr<Stored>> meshes_;
    unsigned picture_ = 0;
};

} // namespace render
