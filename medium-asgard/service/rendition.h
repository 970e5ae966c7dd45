// One rendition of the picture: its size and slots, how its user sees the scene, and which of its
// frames the host has not acknowledged.
//
// A frame is drawn only into a slot that the host does not read, and only when it would differ from
// the last one: `Look` is everything that decides a picture. Frames are drawn one after the other,
// from begin() to finish(); one that is no use any more is given up between.
#pragma once

#include "framing/view.h"
#include "ipc/messages.h"
#include "playing/playback.h"
#include "render/renderer.h"
#include "service/frame_memory.h"
#include "service/pictures.h"
#include "service/sheets.h"

#include <array>
#include <map>

namespace service {

using playing::Instant;

struct Look {
    unsigned generation = 0; // of the scene and its motion; of a sheet
    double time = 0;
    render::Camera camera;
    render::Display display;
    unsigned handles = 0;   // generation of what a gesture makes of them
    unsigned selection = 0; // of what is selected
    unsigned values = 0;    // of those beside bodies: generation of their plots
    std::size_t row = 0;    // of a text: the first that is seen
};
// A picture of one look is as good as one of the other, or better: it may have more samples.
[[nodiscard]] bool covers(const Look& shown, const Look& wanted);

[[nodiscard]] std::optional<render::CameraControl::Button> buttonOf(ipc::Button button);

class Rendition {
public:
    // Another size, other slots; the user's point of view stays. Frames of the old slots are void.
    void shape(const ipc::RenditionGeometry& geometry,
               std::array<std::shared_ptr<const MappedSlot>, 2> slots);
    [[nodiscard]] render::Size size() const;
    [[nodiscard]] double scale() const { return geometry_.scale; }
    [[nodiscard]] Presentation presentation() const { return presentation_; }

    // --- how the user sees it
    // The scene, its motion or the picture's size changed: the view that is followed is made anew.
    void see(const scene::Scene& scene, const simulation::MotionPointer& motion,
             unsigned generation);
    // Follows the scene's view of that name; "" its first, or one that shows all well.
    void follow(const std::string& view);
    [[nodiscard]] render::Camera camera(double time) const;
    // True when the picture changed. A view that is turned keeps `up` upright.
    bool input(const ipc::Input& input, double time, const render::Vector& up);
    // The picture stays as it is while what is in it moves.
    void holdView(double time);
    // For its next picture. The grid and the sun are chosen for the first whole motion, and stay
    // when that is edited; a view that frames all of each new motion keeps the grid where it fits.
    [[nodiscard]] Around around() const;
    [[nodiscard]] bool beingTurned() const { return control_.active(); }
    // All of that in words that another process understands: the host hands them back to it. Other
    // words change nothing.
    [[nodiscard]] std::string state() const;
    void restore(const std::string& state);
    std::string toldState;

    // --- frames
    struct Frame {
        ipc::RenditionFrame message; // without serial; pixels are missing where there are no slots
        render::Image into;          // the same
        std::shared_ptr<const MappedSlot> slot; // where that is
        std::shared_ptr<const Look> look;       // by it the rendition knows its frame
        bool isWhole = false;                   // it shows a scene whose motion is known to its end
    };
    [[nodiscard]] bool hasFreeSlot() const { return freeSlot().has_value(); }
    [[nodiscard]] bool shows(const Look& look) const { return shown_ && covers(*shown_, look); }
    // The next frame, to be drawn into `into`. Call only with a free slot, and none begun.
    [[nodiscard]] Frame begin(const Look& look);
    [[nodiscard]] bool draws() const { return begun_ != nullptr; }
    [[nodiscard]] bool draws(const Look& look) const { return begun_ && covers(*begun_, look); }
    [[nodiscard]] bool draws(const Frame& frame) const { return begun_ && begun_ == frame.look; }
    void finish(Frame& frame); // it is the one that is shown, and goes to the host
    void giveUp() { begun_.reset(); }
    void acknowledge(ipc::Integer serial) { unacknowledged_.erase(serial); }
    [[nodiscard]] bool sharesMemory() const { return slots_[0] != nullptr; }

    bool visible = false;
    Instant calmAt{}; // until then its user is moving the view
    render::Display display;
    std::size_t row = 0; // of a text: the first that is seen
    unsigned round = 0;  // of pictures that the last one was of

private:
    [[nodiscard]] std::optional<ipc::Integer> freeSlot() const;

    ipc::RenditionGeometry geometry_;
    std::array<std::shared_ptr<const MappedSlot>, 2> slots_;
    std::map<ipc::Integer, ipc::Integer> unacknowledged_; // serial to slot
    ipc::Integer serial_ = 0;
    std::optional<Look> shown_;
    std::shared_ptr<const Look> begun_; // of the frame that is being drawn

    struct Followed {
        std::string name;
        std::optional<render::SceneView> view;
        std::optional<std::pair<unsigned, render::Size>> of; // generation and size
    } followed_;
    std::shared_ptr<Around::Last> around_ = std::make_shared<Around::Last>();
    bool knowsWhole_ = false; // it has shown a whole motion
    Presentation presentation_ = Presentation::picture;
    bool turned_ = false; // by the user: the view is his
    render::CameraControl control_;
};

} // namespace service
