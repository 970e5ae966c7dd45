// A reader's pointer on handles in the document's picture, with the real evaluator and engine.
#pragma once

#include "ipc/base64.h"
#include "service/testing.h"

#include <gmock/gmock.h>

#include <atomic>
#include <set>

#include <poll.h>

namespace service::pointing {

using render::Handle;
using render::HandleKind;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

inline script::Reader& reader() {
    static script::Reader shared;
    return shared;
}

inline const std::string ball = "simulator -finish 2\nshape_set ball -desc {-sub {-sphere 0.5}}\n";

class HandleEditingTest : public testing::Test {
protected:
    HandleEditingTest() {
        reader(); // made by this thread: it ends with the one that makes it
        Platform platform;
        platform.tools.read = [this](const std::string& text, const ParameterValues& parameters) {
            ++readings;
            return reader().read(text, parameters);
        };
        platform.tools.cancelReading = [] { reader().cancel(); };
        platform.tools.simulate = [](const auto& scene, const auto& options, const auto& observer) {
            return simulation::simulate(*scene, options, observer);
        };
        platform.draw = [this](const render::Drawing& drawing, const render::Image& image,
                               const Around&) {
            camera = drawing.camera;
            size = image.size;
            handles = drawing.handles ? *drawing.handles : render::HandleSet{};
            std::ranges::fill(image.pixels, std::byte(0));
            return true;
        };
        session.emplace(std::move(platform), medium);
    }

    void exchange() {
        for (int i = 0; i < 3; ++i)
            exchangeOnce(host, medium, *session, now, asked,
                         [this](ipc::ToHost call) { take(std::move(call)); });
    }
    void take(ipc::ToHost call) {
        if (auto* sent = std::get_if<ipc::RenditionFrame>(&call)) {
            frame = ipc::fromBase64(sent->pixels.value_or("")).value_or(std::vector<std::byte>());
            host.notify(ipc::RenditionAck{1, sent->serial});
        } else if (auto* changed = std::get_if<ipc::MenuChanged>(&call))
            menus = changed->menus;
        else if (auto* diagnostics = std::get_if<ipc::Diagnostics>(&call))
            diagnosed = diagnostics->revision;
        else if (auto* report = std::get_if<ipc::ProgressReport>(&call))
            said.push_back(report->message);
        else if (auto* begin = std::get_if<ipc::ProgressBegin>(&call)) {
            if (begin->title != "Editing") // the motion's, whenever that ends
                others.insert(begin->token);
        } else if (auto* end = std::get_if<ipc::ProgressEnd>(&call); end != nullptr) {
            if (!others.contains(end->token))
                saidLast = end->message;
        }
    }
    // Until what is shown is what is to be shown, and drawn.
    void settle() {
        const Instant end = Clock::now() + std::chrono::seconds(20);
        do {
            ASSERT_LT(Clock::now(), end) << "waited too long";
            pollfd news{session->descriptor(), POLLIN, 0};
            poll(&news, 1, 5);
            now += std::chrono::milliseconds(200);
            exchange();
        } while (session->subdocument().computing() || !session->subdocument().upToDate());
        now += std::chrono::seconds(1);
        exchange();
    }
    template <class R> void ask(R request) {
        host.request(std::move(request), [](const ipc::Outcome<typename R::Result>& outcome) {
            const auto* error = std::get_if<ipc::Error>(&outcome);
            EXPECT_EQ(error, nullptr) << R::method << ": " << error->message;
        });
        exchange();
    }
    void open(const std::string& text, const std::vector<std::string>& switches) {
        ask(ipc::Initialize{});
        ask(ipc::SubdocumentLoad{text, 1});
        ipc::RenditionCreate create;
        create.rendition = 1;
        create.width = create.height = 400;
        ask(create);
        host.notify(ipc::RenditionShow{1});
        for (const std::string& id : switches)
            ask(ipc::MenuInvoke{id, 1});
        settle();
    }

    Eigen::Vector2d pixels(const render::Vector& world) const {
        return render::toPixels(camera, size, world);
    }
    Handle handle(HandleKind kind, std::size_t part = 0) const {
        for (const Handle& one : handles.handles)
            if (one.kind == kind && one.part == part)
                return one;
        throw std::runtime_error("no such handle");
    }
    void pointer(ipc::InputType type, const Eigen::Vector2d& at,
                 ipc::Button button = ipc::Button::left, bool shifted = true) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = type;
        input.button = type == ipc::InputType::move ? ipc::Button::none : button;
        if (shifted)
            input.modifiers = {ipc::Modifier::shift};
        input.x = at.x();
        input.y = at.y();
        host.notify(input);
        exchange();
    }
    void key(const std::string& name) {
        ipc::RenditionInput input;
        input.rendition = 1;
        input.type = ipc::InputType::keyPress;
        input.key = name;
        input.modifiers = {ipc::Modifier::shift};
        host.notify(input);
        exchange();
    }
    void press(const Eigen::Vector2d& at) { pointer(ipc::InputType::press, at); }
    void move(const Eigen::Vector2d& at) { pointer(ipc::InputType::move, at); }
    void release(const Eigen::Vector2d& at) { pointer(ipc::InputType::release, at); }
    void drag(const render::Vector& from, const render::Vector& to) {
        const Eigen::Vector2d start = pixels(from), end = pixels(to);
        press(start);
        move((start + end) / 2);
        move(end);
        release(end);
    }
    // The host takes the only change that it was asked for.
    text::Edit accepted(const std::string& label) {
        EXPECT_THAT(asked, SizeIs(1));
        const auto& change = std::get<ipc::SubdocumentChanged>(asked.at(0).call);
        EXPECT_EQ(change.label, label);
        const text::Edit edit = change.edits.at(0);
        host.answer(asked[0].id, ipc::Revised{change.base + 1});
        asked.clear();
        settle();
        return edit;
    }
    const std::string& text() { return session->subdocument().text(); }
    const scene::Scene& scene() { return *session->subdocument().scene(); }

    ipc::HostChannel host;
    ipc::MediumChannel medium;
    std::atomic<int> readings = 0;
    std::optional<Session> session;
    Instant now = Clock::now();
    render::Camera camera;
    render::Size size;
    render::HandleSet handles;
    std::vector<std::byte> frame; // that was sent last
    std::vector<ipc::MenuEntry> menus;
    std::vector<std::string> said;
    std::string saidLast;
    ipc::Integer diagnosed = 0;    // the revision that was told of last
    std::set<ipc::Integer> others; // tokens
    std::vector<ipc::Asked<ipc::ToHost>> asked;
};

} // namespace service::pointing
