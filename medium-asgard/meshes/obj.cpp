#include "meshes/ears.h"
#include "meshes/lines.h"
#include "meshes/mesh_file.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace meshes {

namespace {

constexpr std::size_t mostCorners = 10'000;
constexpr std::size_t linesBetween = 1024; // two questions whether to go on

// What has nothing to do with the surface's places.
constexpr std::string_view passedOver[] = {
    "vn",     "vt",       "vp",       "g",          "s",         "o",     "l",
    "p",      "usemtl",   "mtllib",   "mg",         "lod",       "bevel", "usemap",
    "maplib", "c_interp", "d_interp", "shadow_obj", "trace_obj", "call",  "csh"};
constexpr std::string_view freeForm[] = {"cstype", "deg",  "bmat", "step", "curv", "curv2", "surf",
                                         "parm",   "trim", "hole", "scrv", "sp",   "end",   "con"};

class Reader {
public:
    Reader(std::string_view bytes, std::string name, const GoOn& goOn)
        : words_(bytes, Continued::byBackslash), name_(std::move(name)), goOn_(goOn) {}

    ReadMesh read() {
        for (std::size_t lines = 0; words_.nextLine(); ++lines)
            if ((lines % linesBetween == 0 && !goesOn()) || !statement(words_.nextInLine()))
                return ended_ ? wasEnded(name_) : FileFault{fault_};
        return std::move(mesh_);
    }

private:
    bool goesOn() {
        ended_ = ended_ || (goOn_ && !goOn_(words_.share()));
        return !ended_;
    }
    bool refuse(const std::string& what) {
        fault_ = name_ + ", line " + std::to_string(words_.line()) + ": " + what;
        return false;
    }
    bool statement(std::string_view word) {
        if (word == "v")
            return vertex();
        if (word == "f" || word == "fo")
            return face();
        if (std::ranges::find(freeForm, word) != std::end(freeForm))
            return refuse("curved surfaces are not read (" + shown(word) +
                          "); the program that it comes from can make triangles of them.");
        if (!word.starts_with('#') && std::ranges::find(passedOver, word) == std::end(passedOver))
            return refuse(shown(word) + " begins no line of an OBJ file.");
        words_.skipLine();
        return true;
    }
    bool vertex() {
        Vector p;
        for (int k = 0; k < 3; ++k) {
            const std::string_view word = words_.nextInLine();
            const auto value = numberOf(word);
            if (!value)
                return refuse(word.empty() ? "a vertex has three coordinates."
                                           : shown(word) + " is no number.");
            if (!(std::abs(*value) <= mostCoordinate))
                return refuse(shown(word) + " is not below 1e12.");
            p[k] = *value;
        }
        if (mesh_.vertices.size() == 3 * mostTriangles)
            return refuse("the file has more than " + std::to_string(3 * mostTriangles) +
                          " vertices; the program that it comes from can reduce them.");
        mesh_.vertices.push_back(p);
        words_.skipLine(); // a weight or a colour
        return true;
    }
    // "7", "7/1/3", "-1//2": the first number, counted from 1 or back from the last vertex.
    bool corner(std::string_view word) {
        const std::string_view number = word.substr(0, word.find('/'));
        long long index = 0;
        const auto [end, fault] =
            std::from_chars(number.data(), number.data() + number.size(), index);
        const auto count = static_cast<long long>(mesh_.vertices.size());
        if (fault != std::errc() || end != number.data() + number.size() || index == 0)
            return refuse(shown(word) + " names no vertex.");
        if (index > count || index < -count)
            return refuse("there is no vertex " + std::to_string(index) + " yet, only " +
                          std::to_string(count) + ".");
        corners_.push_back(static_cast<std::uint32_t>(index > 0 ? index - 1 : count + index));
        return true;
    }
    bool face() {
        corners_.clear();
        for (auto word = words_.nextInLine(); !word.empty() && !word.starts_with('#');
             word = words_.nextInLine()) {
            if (corners_.size() == mostCorners)
                return refuse("a face has more than " + std::to_string(mostCorners) + " corners.");
            if (!corner(word))
                return false;
        }
        words_.skipLine();
        if (corners_.size() < 3)
            return refuse("a face has three corners at least.");
        const auto triangles = trianglesOf(mesh_.vertices, corners_, [this] { return goesOn(); });
        if (ended_)
            return false;
        if (mesh_.triangles.size() + triangles.size() > mostTriangles)
            return refuse("the file has more than " + std::to_string(mostTriangles) +
                          " triangles; the program that it comes from can reduce them.");
        mesh_.triangles.insert(mesh_.triangles.end(), triangles.begin(), triangles.end());
        return true;
    }

    Words words_;
    std::string name_, fault_;
    const GoOn& goOn_;
    bool ended_ = false;
    Mesh mesh_;
    std::vector<std::uint32_t> corners_;
};

} // namespace

ReadMesh readObj(std::string_view bytes, const std::string& name, const GoOn& goOn) {
    return Reader(bytes, name, goOn).read();
}

} // namespace meshes
