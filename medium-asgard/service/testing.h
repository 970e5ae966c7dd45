// Both ends of a pipe in one test, and a scene whose motion is known.
#pragma once

#include "service/session.h"

#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <poll.h>

namespace service {

// A ball of mass 1 is pushed from rest by p: x = p t^2 / 2.
inline scene::Scene pushedBallScene(double p) {
    scene::Scene scene;
    scene.simulator.finish = 4;
    scene.parameters.push_back({"p", p, 0, 10, "", "", {}});
    scene::ShapeSet set;
    set.name = "round";
    set.parts.resize(1);
    set.parts[0].shape = scene::SphereShape{0.5};
    scene.shapeSets = {set};
    scene::Body ball;
    ball.name = "b";
    ball.shape = "round";
    ball.mass = 1;
    scene.bodies = {ball};
    scene::Force push;
    push.body = "b";
    push.kind = scene::ComponentForce{{"p", "0", "0"}, scene::Frame::world};
    scene.forces = {push};
    return scene;
}

// The messages of either end reach the other, and what is to be drawn is; notifications are taken,
// requests are kept.
inline void exchangeOnce(ipc::HostChannel& host, ipc::MediumChannel& medium, Session& session,
                         Instant now, std::vector<ipc::Asked<ipc::ToHost>>& asked,
                         const std::function<void(ipc::ToHost)>& take) {
    medium.feed(std::string(host.outgoing()));
    host.sent(host.outgoing().size());
    while (const auto call = medium.next())
        session.receive(*call, now);
    session.attend(now);
    while (session.draws()) { // its thread is quick here
        pollfd news{session.descriptor(), POLLIN, 0};
        poll(&news, 1, 1000);
        session.attend(now);
    }
    host.feed(std::string(medium.outgoing()));
    medium.sent(medium.outgoing().size());
    while (auto call = host.next())
        if (auto* heard = std::get_if<ipc::Told<ipc::ToHost>>(&*call))
            take(std::move(heard->call));
        else
            asked.push_back(std::get<ipc::Asked<ipc::ToHost>>(*call));
}

// Notes its answer: its method, and ": why" of one that was refused.
template <class R>
void request(ipc::HostChannel& host, R request, std::vector<std::string>& answers) {
    host.request(std::move(request), [&answers](ipc::Outcome<typename R::Result> outcome) {
        const auto* error = std::get_if<ipc::Error>(&outcome);
        answers.push_back(std::string(R::method) + (error ? ": " + error->message : ""));
    });
}

} // namespace service
