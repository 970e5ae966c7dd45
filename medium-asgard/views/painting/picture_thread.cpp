#include "painting/picture_thread.h"

#include "framing/framing.h"
#include "framing/view.h"
#include "gestures/picking.h"

#include <utility>

namespace views {

namespace {

constexpr int lastKind = static_cast<int>(render::HandleKind::trajectoryPoint);

// The kinds of handles that a display shows, but for lights: they stand far from everything.
unsigned kindsOf(const render::Display& display) {
    unsigned kinds = 0;
    for (int kind = 0; kind <= lastKind; ++kind)
        if (const auto one = static_cast<render::HandleKind>(kind);
            one != render::HandleKind::lightPlace && one != render::HandleKind::lightDirection &&
            render::shows(display, one))
            kinds |= 1U << kind;
    return kinds;
}

// All of the motion, and the handles at its start, which one wants to get at.
render::Camera framed(render::Handles& handles, const PictureWish& wish) {
    render::Extent extent = render::extentOf(*wish.shown.scene, wish.shown.motion.get());
    const unsigned kinds = kindsOf(wish.framing);
    if (kinds != 0) {
        const double start =
            wish.shown.motion ? wish.shown.motion->start() : wish.shown.scene->simulator.start;
        for (const render::Handle& handle : handles.at(start, wish.framing).handles)
            if ((kinds & 1U << static_cast<unsigned>(handle.kind)) != 0)
                extent.balls.push_back({handle.place, 0});
    }
    return render::fitted(extent,
                          wish.keepsDirection ? wish.camera.rotation : render::bestAttitude(extent),
                          wish.size, wish.camera.orthographic);
}

} // namespace

// One for all windows: they show the same scene mostly.
class PictureThread::Studio {
public:
    explicit Studio(bool paints) : paints_(paints) {}
    [[nodiscard]] Picture draw(Window window, const PictureWish& wish);
    void forget(Window window) { kept_.erase(window); }
    void close() { // on the thread whose graphics these are
        kept_.clear();
        renderer_.reset();
    }

private:
    struct Kept { // of one window, while its scene, motion and size stay
        Shown of;
        render::Size size;
        std::unique_ptr<render::Handles> handles;
        std::optional<render::SceneView> view;
        std::string viewName;
        struct Seen { // by a view, also of the scene before
            std::string view;
            render::Extent extent;
        };
        std::optional<Seen> seen;
        std::optional<render::Camera> framed;
        unsigned framedWith = 0; // the kinds of handles
        bool keptDirection = false;
        unsigned scaling = 0; // of the handles
        struct Around {
            std::optional<render::Renderer::Surroundings> last;
            unsigned scaling = 0;
        };
        Around around = {};
    };
    [[nodiscard]] Kept& kept(Window window, const PictureWish& wish);
    [[nodiscard]] static render::Camera cameraOf(Kept& kept, const PictureWish& wish);
    void paint(Picture& picture, Kept& kept);

    bool paints_;
    std::map<Window, Kept> kept_;
    std::unique_ptr<render::Renderer> renderer_;
    QString noRenderer_;
};

PictureThread::Studio::Kept& PictureThread::Studio::kept(Window window, const PictureWish& wish) {
    if (!kept_.contains(window)) // another viewer tries again
        noRenderer_.clear();
    Kept& kept = kept_[window];
    const bool same = kept.handles && kept.of.scene == wish.shown.scene &&
                      kept.of.motion == wish.shown.motion && kept.size == wish.size;
    if (!same) {
        const auto scales = kept.handles && kept.scaling == wish.scaling
                                ? std::optional(kept.handles->scales())
                                : std::nullopt;
        auto seen = kept.scaling == wish.scaling ? std::move(kept.seen) : std::nullopt;
        kept.handles.reset(); // it reads the scene
        const auto around = kept.around;
        kept = {wish.shown, wish.size, nullptr, std::nullopt, {}, std::move(seen), std::nullopt};
        kept.around = around;
        kept.handles = std::make_unique<render::Handles>(*kept.of.scene, kept.of.motion, scales);
        kept.scaling = wish.scaling;
    } else if (kept.scaling != wish.scaling) {
        kept.handles = std::make_unique<render::Handles>(*kept.of.scene, kept.of.motion);
        kept.scaling = wish.scaling;
    }
    return kept;
}

render::Camera PictureThread::Studio::cameraOf(Kept& kept, const PictureWish& wish) {
    const scene::Scene& scene = *wish.shown.scene;
    switch (wish.from) {
    case SeenFrom::camera:
        break;
    case SeenFrom::framed:
        if (!kept.framed || kept.framedWith != kindsOf(wish.framing) ||
            kept.framed->orthographic != wish.camera.orthographic ||
            kept.keptDirection != wish.keepsDirection ||
            (wish.keepsDirection &&
             kept.framed->rotation.coeffs() != wish.camera.rotation.coeffs())) {
            kept.framed = framed(*kept.handles, wish);
            kept.framedWith = kindsOf(wish.framing);
            kept.keptDirection = wish.keepsDirection;
        }
        return *kept.framed;
    case SeenFrom::turned:
        return render::fitted(render::extentOf(scene, wish.shown.motion.get()),
                              wish.camera.rotation, wish.size, wish.camera.orthographic);
    case SeenFrom::view:
        if (!kept.view || kept.viewName != wish.view) {
            const bool stays = wish.keepsExtent && kept.seen && kept.seen->view == wish.view;
            kept.view.emplace(scene, wish.shown.motion, wish.view, wish.size,
                              stays ? std::optional(std::move(kept.seen->extent)) : std::nullopt);
            kept.viewName = wish.view;
            kept.seen = {wish.view, kept.view->framed()};
        }
        return kept.view->at(wish.time);
    }
    return wish.camera;
}

void PictureThread::Studio::paint(Picture& picture, Kept& kept) {
    if (!renderer_ && noRenderer_.isEmpty()) {
        auto made = render::Renderer::create();
        if (auto* renderer = std::get_if<std::unique_ptr<render::Renderer>>(&made))
            renderer_ = std::move(*renderer);
        else
            noRenderer_ = QString::fromStdString(std::get<std::string>(made));
    }
    picture.fault = noRenderer_;
    if (!renderer_)
        return;
    const PictureWish& wish = picture.of;
    QImage image(wish.size.width, wish.size.height, QImage::Format_RGB32);
    render::Drawing drawing = {wish.shown.scene.get(), wish.shown.motion, wish.time, picture.camera,
                               wish.display};
    if (render::showsHandles(wish.display)) // not owned: it lives in the picture
        drawing.handles = {std::shared_ptr<const void>(), &picture.handles};
    const render::Image into{
        {reinterpret_cast<std::byte*>(image.bits()), static_cast<std::size_t>(image.sizeInBytes())},
        static_cast<std::size_t>(image.bytesPerLine()),
        wish.size};
    using Keeps = render::Renderer::Keeps;
    const bool isFramedAnew = wish.from == SeenFrom::framed || kept.around.scaling != wish.scaling;
    const Keeps keeps = !wish.keepsGround ? Keeps::nothing
                        : isFramedAnew    ? Keeps::whereItFits
                                          : Keeps::all;
    if (renderer_->draw(drawing, into, &kept.around.last, keeps)) {
        image.setDevicePixelRatio(wish.size.ratio);
        picture.image = std::move(image);
        picture.ground = renderer_->surroundings().ground;
        kept.around.scaling = wish.scaling;
    } else {
        renderer_.reset();
        noRenderer_ = picture.fault =
            QObject::tr("The graphics context was lost. Open another viewer.");
    }
}

Picture PictureThread::Studio::draw(Window window, const PictureWish& wish) {
    const auto began = std::chrono::steady_clock::now();
    Kept& all = kept(window, wish);
    Picture picture;
    picture.of = wish;
    picture.camera = cameraOf(all, wish);
    picture.camera.orthographic = wish.camera.orthographic; // scenes' views do not say
    if (render::showsHandles(wish.display))
        picture.handles = all.handles->at(wish.time, wish.display, picture.camera, wish.size);
    picture.forceArrow = all.handles->arrowLength(render::HandleKind::forceHead, picture.camera);
    picture.torqueArrow = all.handles->arrowLength(render::HandleKind::torqueHead, picture.camera);
    if (paints_)
        paint(picture, all);
    picture.lasted = std::chrono::steady_clock::now() - began;
    return picture;
}

// ---------------------------------------------------------------------------------------------

PictureThread::PictureThread(bool paints)
    : studio_(std::make_unique<Studio>(paints)),
      thread_([studio = studio_.get()] { studio->close(); }) {}

PictureThread::~PictureThread() = default;

void PictureThread::open(Window window, std::function<void()> ready) {
    const std::lock_guard lock(mutex_);
    desks_[window].ready = std::move(ready);
}

void PictureThread::forget(Window window) {
    {
        const std::lock_guard lock(mutex_);
        desks_.erase(window);
    }
    thread_.takeBack(window);
    thread_.before([this, window] { studio_->forget(window); });
}

void PictureThread::draw(Window window, PictureWish wish) {
    {
        const std::lock_guard lock(mutex_);
        desks_.try_emplace(window);
    }
    thread_.draw(window, [this, window, wish = std::move(wish)] { paint(window, wish); });
}

PictureThread::PicturePointer PictureThread::last(Window window) {
    const std::lock_guard lock(mutex_);
    const auto desk = desks_.find(window);
    return desk == desks_.end() ? nullptr : desk->second.last;
}

void PictureThread::drop(PicturePointer picture) {
    thread_.before([dropped = std::move(picture)] {});
}

void PictureThread::wait(Window window, unsigned serial, std::chrono::milliseconds most) {
    std::unique_lock lock(mutex_);
    drawn_.wait_for(lock, most, [&] {
        const auto desk = desks_.find(window);
        return desk == desks_.end() ||
               (desk->second.last && desk->second.last->of.serial >= serial);
    });
}

std::vector<std::shared_ptr<const scene::Scene>> PictureThread::shown() {
    const std::lock_guard lock(mutex_);
    std::vector<std::shared_ptr<const scene::Scene>> scenes;
    for (const auto& [window, desk] : desks_)
        if (desk.last)
            scenes.push_back(desk.last->of.shown.scene);
    return scenes;
}

void PictureThread::paint(Window window, const PictureWish& wish) {
    PicturePointer picture = std::make_shared<const Picture>(studio_->draw(window, wish));
    // Until then an old picture lives: its motion may be large, and no window is to wait for that.
    const std::lock_guard lock(mutex_);
    const auto desk = desks_.find(window);
    if (desk == desks_.end())
        return;
    // Shapes of the scenes that are shown are made to be pointed at, when there is time.
    if (!desk->second.last || desk->second.last->of.shown.scene != picture->of.shown.scene)
        thread_.inSpareTime([this] { gestures::prepareShapes(shown()); });
    std::swap(desk->second.last, picture);
    drawn_.notify_all();
    if (desk->second.ready)
        desk->second.ready();
}

} // namespace views
