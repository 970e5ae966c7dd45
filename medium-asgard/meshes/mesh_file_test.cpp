// What files say, and the sentence where they are wrong.
#include "meshes/convex_parts.h"
#include "meshes/ears.h"
#include "meshes/mesh_file.h"
#include "meshes/solids.h"
#include "meshes/test_meshes.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <random>

namespace meshes {
namespace {

std::string fault(const std::string& bytes, const std::string& name) {
    const ReadMesh read = readMesh(bytes, name);
    const auto* refused = std::get_if<FileFault>(&read);
    return refused ? refused->sentence : "";
}

Mesh mesh(const std::string& bytes, const std::string& name) {
    const ReadMesh read = readMesh(bytes, name);
    EXPECT_TRUE(std::holds_alternative<Mesh>(read)) << fault(bytes, name);
    const auto* is = std::get_if<Mesh>(&read);
    return is ? *is : Mesh();
}

TEST(MeshFileTest, EveryKindHoldsTheSameSolid) {
    const Mesh given = prism(ell, 1);
    for (const auto& [bytes, name] :
         {std::pair(stlText(given), "a.stl"), std::pair(stlBinary(given), "a.STL"),
          std::pair(objText(given), "a.obj")}) {
        const Solids solids = solidsOf(mesh(bytes, name));
        ASSERT_EQ(solids.solids.size(), 1U) << name;
        EXPECT_NEAR(solids.solids[0].volume, 4, 1e-12) << name;
        EXPECT_EQ(solids.solids[0].surface.vertices.size(), given.vertices.size()) << name;
    }
}

TEST(MeshFileTest, ABinaryFileMayBeginLikeAText) {
    std::string bytes = stlBinary(prism(ell, 1));
    bytes.replace(0, 5, "solid");
    EXPECT_EQ(mesh(bytes, "a.stl").triangles.size(), 20U);
}

TEST(MeshFileTest, NumbersAreThoseThatOneWouldWrite) {
    const Mesh given = boxMesh({0.1, 0.2, 0.3}, {1.1, 1.2, 1.3});
    EXPECT_EQ(mesh(stlBinary(given), "a.stl").vertices[0].x(), static_cast<double>(0.1));
}

TEST(MeshFileTest, ObjHasPolygonsAndCountsBackwards) {
    const Mesh face = mesh("v 0 0 0\nv 3 0 0 1.0\nv 3 1 0\nv 1 1 \\\n 0\nv 1 2 0\nv 0 2 0\n"
                           "usemtl red\nf -6//1 -5//1 -4//1 -3//1 -2//1 -1//1 # an L\n",
                           "l.obj");
    double area = 0;
    for (const auto& t : face.triangles) {
        const Vector cross = (face.vertices[t[1]] - face.vertices[t[0]])
                                 .cross(face.vertices[t[2]] - face.vertices[t[0]]);
        EXPECT_GE(cross.z(), 0); // none covers what lies outside
        area += cross.z() / 2;
    }
    EXPECT_EQ(area, 4);
}

TEST(MeshFileTest, ABackslashGoesOnInTheNextLineOfAnObjFileOnly) {
    const Mesh given = prism(ell, 1);
    std::string text = stlText(given);
    text.insert(text.find('\n'), " C:\\models\\");
    EXPECT_EQ(mesh(text, "a.stl").triangles.size(), given.triangles.size());
    EXPECT_EQ(mesh("v 0 0 0\nv 1 0 0\nv 0 \\\r\n1 0\nf 1\\\n 2 3\n", "a.obj").triangles.size(), 1U);
}

// Teeth as high as the comb: only the corners at their ends are ears, and none for long.
std::vector<Eigen::Vector2d> comb(int teeth) {
    std::vector<Eigen::Vector2d> outline = {{0, 0}, {2.0 * teeth, 0}};
    for (int i = teeth; i-- > 0;) {
        outline.emplace_back(2 * i + 1.5, 10 + i % 3);
        outline.emplace_back(2 * i + 0.5, 0.5);
    }
    return outline;
}

TEST(MeshFileTest, EarsTakeAFewLooksForEachCorner) {
    const std::vector<Eigen::Vector2d> outline = comb(199);
    std::vector<Vector> vertices;
    std::vector<std::uint32_t> corners;
    double wanted = 0, area = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const auto& next = outline[(i + 1) % outline.size()];
        wanted += (outline[i].x() * next.y() - outline[i].y() * next.x()) / 2;
        vertices.emplace_back(outline[i].x(), outline[i].y(), 0);
        corners.push_back(static_cast<std::uint32_t>(i));
    }
    std::size_t looks = 0;
    const auto triangles = trianglesOf(vertices, corners, [&] { return ++looks > 0; });
    EXPECT_EQ(triangles.size(), corners.size() - 2);
    for (const auto& t : triangles) {
        const Vector cross =
            (vertices[t[1]] - vertices[t[0]]).cross(vertices[t[2]] - vertices[t[0]]);
        EXPECT_GE(cross.z(), 0);
        area += cross.z() / 2;
    }
    EXPECT_NEAR(area, wanted, 1e-9);
    EXPECT_LT(looks, 4 * corners.size());
    // Crossing itself everywhere it has no ears for long; that is no reason to look for ever.
    std::shuffle(corners.begin(), corners.end(), std::mt19937(5));
    looks = 0;
    EXPECT_EQ(trianglesOf(vertices, corners, [&] { return ++looks > 0; }).size(),
              corners.size() - 2);
    EXPECT_LT(looks, 12 * corners.size());
}

TEST(MeshFileTest, ReadingCanBeToldToStopAtAnyQuestion) {
    const Mesh ring = torus(2, 0.5, 60, 40);
    std::string combs = "# a face whose ears take long\n";
    for (const auto& p : comb(60))
        combs += "v " + std::to_string(p.x()) + " " + std::to_string(p.y()) + " 0\n";
    combs += "f";
    for (int i = 1; i <= 122; ++i)
        combs += " " + std::to_string(i);
    for (const auto& [bytes, name] :
         {std::pair(stlText(ring), "a.stl"), std::pair(stlBinary(ring), "a.stl"),
          std::pair(objText(ring), "a.obj"), std::pair(combs + "\n", "a.obj")})
        for (int last : {1, 2, 4}) {
            int asked = 0;
            const ReadMesh read = readMesh(bytes, name, [&](double share) {
                EXPECT_GE(share, 0);
                EXPECT_LE(share, 1);
                return ++asked < last;
            });
            ASSERT_TRUE(std::holds_alternative<FileFault>(read)) << name;
            EXPECT_EQ(std::get<FileFault>(read).sentence,
                      "Reading " + std::string(name) + " was ended.");
            EXPECT_EQ(asked, last);
        }
}

TEST(SolidsTest, CanBeToldToStop) {
    Mesh many = boxMesh({0, 0, 0}, {9, 9, 9});
    for (int i = 0; i < 4; ++i)
        many = together(
            many, insideOut(boxMesh(Vector::Constant(2 * i + 0.5), Vector::Constant(2 * i + 1))));
    int all = 0;
    EXPECT_EQ(solidsOf(many, [&](double) { return ++all > 0; }).solids.size(), 1U);
    EXPECT_GT(all, 8); // for each piece, and for each that lies in another
    for (int last = 1; last <= all; ++last) {
        int asked = 0;
        const Solids solids = solidsOf(many, [&](double) { return ++asked < last; });
        EXPECT_TRUE(solids.cancelled);
        EXPECT_TRUE(solids.solids.empty());
        EXPECT_EQ(asked, last);
    }
}

TEST(MeshFileTest, FaultsSayWhere) {
    const struct {
        std::string bytes, name, sentence;
    } cases[] = {
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 zero 0\n", "a.stl",
         "a.stl, line 5: \"zero\" is no number."},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertx 1 0 0\n", "a.stl",
         "a.stl, line 5: \"vertex\" should be here, not \"vertx\"."},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0", "a.stl",
         "a.stl, line 4: the file ends within a vertex."},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 1e300\n", "a.stl",
         "a.stl, line 4: \"1e300\" is not below 1e12."},
        {"solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 nan\n", "a.stl",
         "a.stl, line 4: \"nan\" is no number."},
        {"solid empty\nendsolid\n", "a.stl", "a.stl has no triangles."},
        {"\x7f"
         "ELF",
         "a.stl",
         "a.stl is no STL file: it does not begin with \"solid\", and with 4 bytes it is too short "
         "to be binary."},
        {stlBinary(prism(ell, 1)).substr(0, 200), "a.stl",
         "a.stl, byte 200: the file ends after 2 triangles and announces 20."},
        {"v 0 0\n", "a.obj", "a.obj, line 1: a vertex has three coordinates."},
        {"v 0 0 0\nv 1 0 0\nf 1 2\n", "a.obj", "a.obj, line 3: a face has three corners at least."},
        {"v 0 0 0\nf 1 2 3\n", "a.obj", "a.obj, line 2: there is no vertex 2 yet, only 1."},
        {"v 0 0 0\nf " + std::string(100'000, '0') + "5 1 1\n", "a.obj",
         "a.obj, line 2: there is no vertex 5 yet, only 1."},
        {"v 0 0 0\nf 0 1 1\n", "a.obj", "a.obj, line 2: \"0\" names no vertex."},
        {"v 0 0 0\nf 1 x 1\n", "a.obj", "a.obj, line 2: \"x\" names no vertex."},
        {"\n\nsolid\n", "a.obj", "a.obj, line 3: \"solid\" begins no line of an OBJ file."},
        {"cstype bspline\n", "a.obj",
         "a.obj, line 1: curved surfaces are not read (\"cstype\"); the program that it comes from "
         "can make triangles of them."},
        {"", "a.obj", "a.obj has no triangles."},
    };
    for (const auto& one : cases)
        EXPECT_EQ(fault(one.bytes, one.name), one.sentence);
    std::string nan = stlBinary(prism(ell, 1));
    nan.replace(84 + 50 + 12, 4, "\xff\xff\xff\xff");
    EXPECT_EQ(fault(nan, "a.stl"),
              "a.stl, byte 146: triangle 2 has a coordinate that is no number below 1e12.");
}

TEST(SolidsTest, CavitiesAreTakenAwayAndInsideOutIsTurned) {
    const Mesh outer = boxMesh({0, 0, 0}, {3, 3, 3}), inner = boxMesh({1, 1, 1}, {2, 2, 2});
    const Solids hollow = solidsOf(together(outer, insideOut(inner)));
    ASSERT_EQ(hollow.solids.size(), 1U);
    EXPECT_NEAR(hollow.solids[0].volume, 26, 1e-12);
    EXPECT_NEAR(windingNumber(hollow.solids[0].surface, {1.5, 1.5, 1.5}), 0, 1e-9);
    EXPECT_NEAR(windingNumber(hollow.solids[0].surface, {0.5, 1.5, 1.5}), 1, 1e-9);
    const Solids turned = solidsOf(insideOut(together(outer, insideOut(inner))));
    ASSERT_EQ(turned.solids.size(), 1U);
    EXPECT_NEAR(turned.solids[0].volume, 26, 1e-12);
    Mesh mixed = outer; // some triangles look inwards
    for (std::size_t t = 0; t < mixed.triangles.size(); t += 3)
        std::swap(mixed.triangles[t][0], mixed.triangles[t][1]);
    const Solids agreed = solidsOf(mixed);
    ASSERT_EQ(agreed.solids.size(), 1U);
    EXPECT_NEAR(agreed.solids[0].volume, 27, 1e-12);
}

TEST(SolidsTest, GapsOfRoundingAreClosedAndOthersAreNot) {
    Mesh apart;
    for (const auto& t : boxMesh({0, 0, 0}, {1, 1, 1}).triangles)
        for (const auto v : t) {
            apart.vertices.push_back(boxMesh({0, 0, 0}, {1, 1, 1}).vertices[v] +
                                     Vector(1e-9, 2e-9, 0) *
                                         static_cast<double>(apart.vertices.size() % 5));
            if (apart.vertices.size() % 3 == 0) {
                const auto last = static_cast<std::uint32_t>(apart.vertices.size());
                apart.triangles.push_back({last - 3, last - 2, last - 1});
            }
        }
    EXPECT_EQ(solidsOf(apart).solids.size(), 1U);
    Mesh open = boxMesh({0, 0, 0}, {1, 1, 1});
    open.triangles.pop_back();
    const Solids none = solidsOf(open);
    EXPECT_EQ(none.solids.size(), 0U);
    EXPECT_EQ(none.open.size(), 1U);
    EXPECT_EQ(none.openEdges, 3U);
}

// Whatever is done to a file: a mesh whose indices are its own, or a sentence; and what comes of a
// mesh has volumes that are numbers.
TEST(MeshFileTest, DamagedFilesAreReadOrRefused) {
    const char* files = std::getenv("ASGARD_MESH_FILES");
    const char* seed = std::getenv("ASGARD_SEED");
    std::mt19937 random(seed ? static_cast<unsigned>(std::atoi(seed)) : 20261120U);
    const Mesh given = prism(ell, 1);
    const std::pair<std::string, std::string> whole[] = {
        {stlText(given), "a.stl"}, {stlBinary(given), "a.stl"}, {objText(given), "a.obj"}};
    const std::string pieces[] = {"-1",   "nan",   "1e999", "\n",     "f 1 2 3\n", "v 1 2 3\n",
                                  "\\\n", "facet", "0",     "999999", "/",         "endloop"};
    std::size_t readable = 0;
    for (int i = 0; i < (files ? std::atoi(files) : 3000); ++i) {
        auto [bytes, name] = whole[random() % 3];
        for (unsigned k = random() % 8; k > 0; --k) {
            const std::size_t at = random() % (bytes.size() + 1);
            switch (random() % 5) {
            case 0:
                bytes.insert(at, pieces[random() % std::size(pieces)]);
                break;
            case 1:
                bytes.erase(at, random() % 40);
                break;
            case 2:
                if (at < bytes.size())
                    bytes[at] = static_cast<char>(random());
                break;
            case 3:
                bytes.insert(at, bytes.substr(random() % bytes.size(), random() % 100));
                break;
            default:
                if (random() % 8 == 0)
                    bytes.resize(at);
            }
            if (bytes.empty())
                break;
        }
        const ReadMesh read = readMesh(bytes, name);
        if (const auto* refused = std::get_if<FileFault>(&read)) {
            EXPECT_EQ(refused->sentence.find(name), 0U);
            EXPECT_EQ(refused->sentence.back(), '.');
            EXPECT_LT(refused->sentence.size(), 200U);
            continue;
        }
        ++readable;
        const Mesh& mesh = std::get<Mesh>(read);
        for (const auto& t : mesh.triangles)
            for (const auto v : t)
                ASSERT_LT(v, mesh.vertices.size());
        if (readable % 8 == 0) {
            const ConvexParts parts = convexParts(solidsOf(mesh), {.parts = 4});
            EXPECT_TRUE(std::isfinite(parts.volume) && std::isfinite(parts.partsVolume));
        }
    }
    EXPECT_GT(readable, 50U);
}

} // namespace
} // namespace meshes
