// Pictures of bodies, drawn beside the thread that answers the host.
//
// The asker hands over all that a picture needs, and gets it back by collect(), on its own thread.
// Memory that a picture goes to is written to until then, whatever the asker does meanwhile.
#pragma once

#include "render/drawing_thread.h"
#include "render/renderer.h"
#include "service/frame_memory.h"
#include "service/subdocument.h"

#include <memory>
#include <mutex>
#include <string>
#include <vector>

namespace service {

// The grid and the sun of a rendition's pictures. Null: each picture has its own.
struct Around {
    using Last = std::optional<render::Renderer::Surroundings>;
    std::shared_ptr<Last> last; // the drawing thread alone reads and writes it
    render::Renderer::Keeps keeps = render::Renderer::Keeps::nothing;
};

// Drawn on the thread of a renderer; false: the graphics context was lost.
using Draw = std::function<bool(const render::Drawing&, const render::Image&, const Around&)>;

// Memory for the pixels of an image that has none.
[[nodiscard]] std::vector<std::byte> pixelsFor(render::Image& image);

class Pictures {
public:
    using Customer = render::DrawingThread::Customer;

    // `wake` is called on the thread when there is something to collect.
    Pictures(std::unique_ptr<render::DrawingThread> thread, Draw draw, std::function<void()> wake);

    struct Wish {
        ScenePointer scene; // lives as long as the drawing of it
        render::Drawing drawing;
        render::Image into;                     // without pixels: they are wanted as text
        std::shared_ptr<const MappedSlot> slot; // where its pixels are
        std::function<void(const render::Image&)> over = {}; // draws over the bodies, on the thread
        Around around = {};
    };
    struct Drawn {
        bool isFine = false;
        std::string packed; // the pixels as the protocol's text
        Clock::duration lasted{};
    };
    using Done = std::function<void(Drawn)>;
    // One picture of a customer at a time.
    void draw(Customer customer, Wish wish, Done done);
    // It is not begun any more, and nobody hears of it. False: it is, or none was asked for.
    bool takeBack(Customer customer);
    // At once, or when its last picture is drawn: then its memory is not written to any more.
    void whenFree(Customer customer, std::function<void()> done);
    [[nodiscard]] bool draws(Customer customer) const;
    [[nodiscard]] bool drawsAny() const { return !asked_.empty(); }
    void collect();
    // On the thread, when nothing is to be drawn.
    void inSpareTime(std::function<void()> work) { thread_->inSpareTime(std::move(work)); }

private:
    struct Asked {
        unsigned number = 0;
        Customer customer = nullptr;
        Done done;
        std::vector<std::function<void()>> whenFree;
    };
    [[nodiscard]] std::vector<Asked>::iterator of(Customer customer); // the newest

    Draw draw_;
    std::function<void()> wake_;
    unsigned number_ = 0;
    std::vector<Asked> asked_;
    std::mutex mutex_;
    std::vector<std::pair<unsigned, Drawn>> drawn_; // under mutex_
    std::unique_ptr<render::DrawingThread> thread_; // the first to go
};

} // namespace service
