#include "meshes/lines.h"
#include "meshes/mesh_file.h"

#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>

namespace meshes {

namespace {

constexpr std::size_t headerBytes = 84, triangleBytes = 50;
constexpr std::size_t trianglesBetween = 1024; // two questions whether to go on

std::uint32_t integerAt(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (int k = 3; k >= 0; --k)
        value = value << 8U | static_cast<unsigned char>(bytes[at + static_cast<std::size_t>(k)]);
    return value;
}

// The decimal that one would write for it: 0.1, not 0.10000000149011612.
double shortest(float x) {
    char text[32];
    const auto end = std::to_chars(text, text + sizeof text, x).ptr;
    double value = x;
    std::from_chars(text, end, value);
    return value;
}

void addTriangle(Mesh& mesh) {
    const auto last = static_cast<std::uint32_t>(mesh.vertices.size());
    mesh.triangles.push_back({last - 3, last - 2, last - 1});
}

std::string tooMany(const std::string& name) {
    return name + " has more than " + std::to_string(mostTriangles) +
           " triangles; the program that it comes from can reduce them.";
}

ReadMesh readBinary(std::string_view bytes, const std::string& name, const GoOn& goOn) {
    const std::size_t count = integerAt(bytes, 80);
    if (count > mostTriangles)
        return FileFault{tooMany(name)};
    Mesh mesh;
    for (std::size_t i = 0; i < count; ++i) {
        if (i % trianglesBetween == 0 && goOn &&
            !goOn(static_cast<double>(i) / static_cast<double>(count)))
            return wasEnded(name);
        for (std::size_t corner = 0; corner < 3; ++corner) {
            Vector p;
            for (std::size_t k = 0; k < 3; ++k) {
                const std::size_t at = headerBytes + i * triangleBytes + 12 * (corner + 1) + 4 * k;
                const float x = std::bit_cast<float>(integerAt(bytes, at));
                if (!(std::abs(x) <= mostCoordinate))
                    return FileFault{name + ", byte " + std::to_string(at) + ": triangle " +
                                     std::to_string(i + 1) +
                                     " has a coordinate that is no number below 1e12."};
                p[static_cast<int>(k)] = shortest(x);
            }
            mesh.vertices.push_back(p);
            if (corner == 2)
                addTriangle(mesh);
        }
    }
    return mesh;
}

// facet normal x y z  outer loop  vertex x y z (3)  endloop  endfacet
class TextReader {
public:
    TextReader(std::string_view bytes, std::string name, const GoOn& goOn)
        : words_(bytes, Continued::no), name_(std::move(name)), goOn_(goOn) {}

    ReadMesh read() {
        words_.skipLine(); // solid NAME
        for (;;) {
            const std::string_view word = words_.next();
            if (word.empty())
                break; // some programs leave the last "endsolid" away
            if (isWord(word, "endsolid") || isWord(word, "solid")) {
                words_.skipLine();
                continue;
            }
            if (mesh_.triangles.size() == mostTriangles)
                return FileFault{tooMany(name_)};
            if (mesh_.triangles.size() % trianglesBetween == 0 && goOn_ && !goOn_(words_.share()))
                return wasEnded(name_);
            if (!wants("facet", word) || !facet())
                return FileFault{fault_};
        }
        return std::move(mesh_);
    }

private:
    bool refuse(const std::string& what) {
        fault_ = name_ + ", line " + std::to_string(words_.line()) + ": " + what;
        return false;
    }
    bool wants(std::string_view wanted, std::string_view word) {
        if (isWord(word, wanted))
            return true;
        return refuse(word.empty()
                          ? "the file ends where \"" + std::string(wanted) + "\" should be."
                          : "\"" + std::string(wanted) + "\" should be here, not " + shown(word) +
                                ".");
    }
    bool wants(std::string_view wanted) { return wants(wanted, words_.next()); }
    bool number(double& value, bool counts) {
        const std::string_view word = words_.next();
        const auto is = numberOf(word);
        value = is.value_or(0);
        if (!counts) // a normal; some programs write nan for those of flat triangles
            return !word.empty() || refuse("the file ends within a normal.");
        if (!is)
            return refuse(word.empty() ? "the file ends within a vertex."
                                       : shown(word) + " is no number.");
        return std::abs(value) <= mostCoordinate || refuse(shown(word) + " is not below 1e12.");
    }
    bool vector(Vector& v, bool counts) {
        return number(v.x(), counts) && number(v.y(), counts) && number(v.z(), counts);
    }
    bool facet() {
        Vector normal, p;
        if (!wants("normal") || !vector(normal, false) || !wants("outer") || !wants("loop"))
            return false;
        for (int corner = 0; corner < 3; ++corner) {
            if (!wants("vertex") || !vector(p, true))
                return false;
            mesh_.vertices.push_back(p);
        }
        addTriangle(mesh_);
        return wants("endloop") && wants("endfacet");
    }

    Words words_;
    std::string name_, fault_;
    const GoOn& goOn_;
    Mesh mesh_;
};

} // namespace

ReadMesh readStl(std::string_view bytes, const std::string& name, const GoOn& goOn) {
    const bool hasCount = bytes.size() >= headerBytes;
    const std::size_t announced = hasCount ? integerAt(bytes, 80) : 0;
    const std::size_t length = headerBytes + announced * triangleBytes;
    // A binary file may well begin with "solid": its length tells.
    if (hasCount && bytes.size() == length)
        return readBinary(bytes, name, goOn);
    Words words(bytes, Continued::no);
    if (isWord(words.next(), "solid"))
        return TextReader(bytes, name, goOn).read();
    if (!hasCount)
        return FileFault{name + " is no STL file: it does not begin with \"solid\", and with " +
                         std::to_string(bytes.size()) + " bytes it is too short to be binary."};
    if (announced > 0 && announced <= mostTriangles && bytes.size() > length)
        return readBinary(bytes.substr(0, length), name,
                          goOn); // programs add what they like behind
    const std::size_t whole = (bytes.size() - headerBytes) / triangleBytes;
    return FileFault{name + ", byte " + std::to_string(bytes.size()) + ": the file ends after " +
                     std::to_string(whole) + " triangles and announces " +
                     std::to_string(announced) + "."};
}

FileFault wasEnded(const std::string& name) { return {"Reading " + name + " was ended."}; }

ReadMesh readMesh(std::string_view bytes, const std::string& name, const GoOn& goOn) {
    if (bytes.size() > mostBytes)
        return FileFault{name + " has more than " + std::to_string(mostBytes / 1'000'000) +
                         " MB; the program that it comes from can reduce it."};
    const bool isObj =
        name.size() >= 4 && isWord(std::string_view(name).substr(name.size() - 4), ".obj");
    ReadMesh read = isObj ? readObj(bytes, name, goOn) : readStl(bytes, name, goOn);
    if (const Mesh* mesh = std::get_if<Mesh>(&read); mesh && mesh->triangles.empty())
        return FileFault{name + " has no triangles."};
    return read;
}

} // namespace meshes
