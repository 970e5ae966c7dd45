#include "case_parts.h"

#include <cmath>
#include <utility>

namespace bench::contacts {

std::vector<double> timesTo(double end, int count) {
    std::vector<double> times;
    for (int i = 1; i <= count; ++i)
        times.push_back(end * i / count);
    return times;
}

Place onSlope(double slope, double along, double above) {
    return {along * std::cos(slope) - above * std::sin(slope),
            along * std::sin(slope) + above * std::cos(slope), 0};
}

std::vector<Place> centres(const std::vector<Body>& bodies) {
    std::vector<Place> places;
    places.reserve(bodies.size());
    for (const Body& body : bodies)
        places.push_back(body.at);
    return places;
}

Case withFloor(std::string name, double slope, double friction) {
    Case scene;
    scene.name = std::move(name);
    scene.planes = {{.name = "floor", .slope = slope}};
    scene.friction = scene.planeFriction = friction;
    return scene;
}

void moveAlong(Case& scene, const std::function<double(double)>& distance) {
    for (const double time : scene.times) {
        const Place by = onSlope(scene.planes.front().slope, distance(time), 0);
        std::vector<Place> places = centres(scene.bodies);
        for (Place& place : places)
            for (std::size_t a = 0; a < 3; ++a)
                place[a] += by[a];
        scene.right.push_back(std::move(places));
    }
}

} // namespace bench::contacts
