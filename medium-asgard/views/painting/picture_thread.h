// Draws the pictures of windows on a thread of its own (render/drawing_thread.h): however heavy a
// scene is, no window waits for it.
//
// Windows wait for a picture only as long as nobody notices, so that what is quick is drawn at
// once; what is not comes when it is ready, and until then the last one stays. With a picture comes
// what was found out for it: where it is seen from, and where the handles stand.
#pragma once

#include "handles/handles.h"
#include "render/drawing_thread.h"
#include "render/renderer.h"
#include "workbench/scene_document.h"

#include <QImage>

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>

namespace views {

enum class SeenFrom : std::uint8_t {
    camera,
    framed, // so that all of the motion is seen
    turned, // the same, with the camera's attitude
    view,   // as the scene's view of that name says
};

struct PictureWish {
    unsigned serial = 0; // of one window's wishes
    Shown shown;
    double time = 0;
    render::Display display;
    render::Size size;
    SeenFrom from = SeenFrom::framed;
    render::Camera camera;
    std::string view;
    render::Display framing = {}; // whose handles are to be in the frame, too
    bool keepsDirection = false;  // the frame is seen from the camera's, not from the best side
    bool keepsExtent = false;     // what a view frames stays as it was for the scene before
    bool keepsGround = false;     // it stays, and the sun; once framed anew, where it still fits
    unsigned scaling = 0;         // while it stays, arrows keep their scale as long as they fit
};

struct Picture {
    PictureWish of;
    render::Camera camera;
    QImage image; // none: see `fault`
    QString fault;
    render::HandleSet handles; // that the display shows
    double forceArrow = 1, torqueArrow = 1;
    std::optional<render::GroundPlane> ground; // where its grid lies
    std::chrono::duration<double> lasted{};    // making it
};

class PictureThread {
public:
    using PicturePointer = std::shared_ptr<const Picture>;
    using Window = render::DrawingThread::Customer;

    // Without paint a picture has all but its image.
    explicit PictureThread(bool paints = true);
    ~PictureThread();
    PictureThread(const PictureThread&) = delete;
    PictureThread& operator=(const PictureThread&) = delete;

    // `ready` is called on this thread, once for each picture, until forget().
    void open(Window window, std::function<void()> ready);
    void forget(Window window);
    void draw(Window window, PictureWish wish);
    // The last one that was drawn; null: none yet.
    [[nodiscard]] PicturePointer last(Window window);
    // Takes a picture that nobody shows any more: its motion may be large, and freeing that long.
    void drop(PicturePointer picture);
    // Until that wish, or a newer one, is drawn.
    void wait(Window window, unsigned serial, std::chrono::milliseconds most);

private:
    struct Desk { // of one window
        std::function<void()> ready;
        PicturePointer last;
    };
    class Studio; // what belongs to the thread

    void paint(Window window, const PictureWish& wish); // on the thread
    [[nodiscard]] std::vector<std::shared_ptr<const scene::Scene>> shown();

    std::mutex mutex_;
    std::condition_variable drawn_;
    std::map<Window, Desk> desks_;   // under mutex_
    std::unique_ptr<Studio> studio_; // the thread's
    render::DrawingThread thread_;   // the first to go
};

} // namespace views
