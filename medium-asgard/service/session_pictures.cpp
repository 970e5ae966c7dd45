// A session draws frames of renditions and snapshots. Bodies are drawn on the renderer's thread
// (pictures.h), charts and texts here.
#include "service/session.h"

#include "handles/handle_layout.h"
#include "ipc/base64.h"
#include "lettering/values_beside.h"
#include "service/handle_labels.h"
#include "terminal/terminal.h"

#include <algorithm>

namespace service {
namespace {

using std::chrono::milliseconds;

constexpr milliseconds longestPause{100}; // between two frames, however long one took
constexpr milliseconds untilSpareTime{1000};
constexpr const char* lostState = "the graphics driver lost its state";

} // namespace

bool Session::moving(const Rendition& rendition) const {
    return subdocument_.playback.playing() || at_.now < pace_.calmAt ||
           at_.now < rendition.calmAt || rendition.beingTurned() || gesture_.handles.active();
}

const scene::Scene& Session::drawnScene() const {
    static const scene::Scene nothing;
    return subdocument_.scene() ? *subdocument_.scene() : nothing;
}

Look Session::lookOf(Rendition& rendition) const {
    Look look;
    if (rendition.presentation() != Presentation::picture) {
        const SheetLook sheet =
            sheets_.lookOf(rendition.presentation(), shown_.time, rendition.row);
        look.generation = sheet.generation;
        look.time = sheet.time;
        look.row = sheet.row;
        return look;
    }
    look.generation = subdocument_.generation();
    look.time = shown_.time;
    look.display = rendition.display;
    if (!subdocument_.scene())
        look.display.grid = false;
    look.display.samples = moving(rendition) ? movingSamples : stillSamples;
    look.camera = rendition.camera(shown_.time);
    look.handles = render::showsHandles(look.display) ? gesture_.handles.generation() : 0;
    look.selection = gesture_.selection.generation();
    look.values = sheets_.lookOf(Presentation::picture, shown_.time, 0).generation;
    return look;
}

render::Drawing Session::drawingOf(const Look& look) const {
    render::Drawing drawing;
    drawing.scene = &drawnScene();
    drawing.motion = subdocument_.motion();
    drawing.time = look.time;
    drawing.camera = look.camera;
    drawing.display = look.display;
    return drawing;
}

void Session::drawOwed() {
    const bool nothingYet =
        !subdocument_.scene() && (subdocument_.computing() || !subdocument_.readAt());
    if (nothingYet || channel_.congested())
        return;
    const Instant begin = Clock::now();
    int sheets = 0;
    for (auto& [id, rendition] : shown_.all) {
        const bool isSheet = rendition.presentation() != Presentation::picture;
        if (!rendition.visible || (!platform_.draw && !isSheet))
            continue;
        if (!sheets_.drawable(rendition.presentation()))
            continue; // until its plots are there
        rendition.see(drawnScene(), subdocument_.motion(), subdocument_.viewGeneration());
        const Look look = lookOf(rendition);
        if (const Instant calm = std::max(pace_.calmAt, rendition.calmAt); at_.now < calm)
            dueAt(calm);
        if (rendition.draws()
                ? !replaces(rendition, look)
                : rendition.shows(look) || !rendition.hasFreeSlot() || !mayBegin(rendition))
            continue;
        draw(id, rendition, look);
        sheets += isSheet ? 1 : 0;
    }
    for (const auto cost = Clock::now() - begin; sheets > 0; --sheets)
        endOne(sheets == 1 ? cost : Clock::duration());
}

// A picture that waits for its turn becomes the newest; one that is being drawn is waited for.
bool Session::replaces(Rendition& rendition, const Look& look) {
    return !rendition.draws(look) && takeBack(rendition);
}

bool Session::takeBack(Rendition& rendition) {
    if (!pictures_.takeBack(&rendition))
        return false;
    rendition.giveUp();
    endOne({});
    return true;
}

bool Session::mayBegin(const Rendition& rendition) {
    if (pace_.round.drawn > 0)
        return rendition.round != pace_.round.number;
    if (at_.now < pace_.nextFrame) {
        dueAt(pace_.nextFrame);
        return false;
    }
    pace_.round = {pace_.round.number + 1, 0, at_.now, {}};
    return true;
}

void Session::draw(ipc::Integer id, Rendition& rendition, const Look& look) {
    Rendition::Frame frame = rendition.begin(look);
    rendition.round = pace_.round.number;
    ++pace_.round.drawn;
    if (rendition.presentation() != Presentation::picture) {
        const auto pixels = frame.slot ? std::vector<std::byte>() : pixelsFor(frame.into);
        sheets_.draw(rendition.presentation(), {look.generation, look.time, look.row},
                     rendition.scale(), frame.into);
        frame.message.time = shown_.time;
        if (!frame.slot)
            frame.message.pixels = ipc::toBase64(pixels);
        return send(rendition, frame);
    }
    Pictures::Wish wish{subdocument_.scene(), drawingOf(look), frame.into, frame.slot};
    wish.around = rendition.around();
    frame.isWhole = !drawnScene().bodies.empty() && !subdocument_.computing();
    if (subdocument_.scene())
        wish.drawing.handles =
            gesture_.handles.handles(subdocument_.scene(), wish.drawing, frame.into.size);
    auto frames =
        gesture_.selection.frames(wish.drawing, {look.camera, frame.into.size}, rendition.scale());
    const bool hasLabels = wish.drawing.handles && !render::labelled(*wish.drawing.handles).empty();
    auto values = lettering::valuesBeside(wish.drawing, frame.into.size, rendition.scale(),
                                          sheets_.sampled());
    if (!frames.empty() || hasLabels || !values.empty())
        wish.over = [frames = std::move(frames), values = std::move(values),
                     handles = wish.drawing.handles, camera = look.camera,
                     scale = rendition.scale(),
                     isDark = render::isDark(look.display.background)](const render::Image& into) {
            drawFrames(frames, scale, isDark, into);
            auto taken = lettering::drawValues(values, scale, isDark, into);
            if (handles)
                drawLabels(*handles, {camera, into.size}, scale, isDark, std::move(taken), into);
        };
    pictures_.draw(&rendition, std::move(wish), [this, id, frame](Pictures::Drawn drawn) mutable {
        finish(id, frame, std::move(drawn));
    });
}

// The rendition may be another one by now, hidden, or of another size.
void Session::finish(ipc::Integer id, Rendition::Frame& frame, Pictures::Drawn drawn) {
    endOne(drawn.lasted);
    if (!drawn.isFine)
        losePictures();
    const auto found = shown_.all.find(id);
    if (found == shown_.all.end() || !found->second.draws(frame))
        return;
    Rendition& rendition = found->second;
    if (!drawn.isFine || !rendition.visible)
        return rendition.giveUp();
    if (!rendition.sharesMemory())
        frame.message.pixels = std::move(drawn.packed);
    send(rendition, frame);
}

void Session::send(Rendition& rendition, Rendition::Frame& frame) {
    rendition.finish(frame);
    channel_.notify(frame.message);
    if (!pace_.firstFrame)
        pace_.firstFrame = at_.now;
}

void Session::endOne(Clock::duration cost) {
    --pace_.round.drawn;
    pace_.round.cost += cost;
    // No pause for a hand: it waits for the new motion.
    const int times = gesture_.handles.active() ? 1 : 2;
    pace_.nextFrame = pace_.round.began + std::clamp<Clock::duration>(times * pace_.round.cost,
                                                                      shortestFrame, longestPause);
}

void Session::losePictures() {
    if (!platform_.draw)
        return;
    platform_.draw = nullptr;
    platform_.noPictures = lostState;
    terminal::complain("asgard: " + platform_.noPictures);
}

void Session::answerWhenFree(const ipc::Id& id, Rendition& rendition) {
    takeBack(rendition);
    pictures_.whenFree(&rendition, [this, id] { channel_.answer(id, ipc::Done{}); });
}

void Session::useSpareTime() {
    if (!platform_.inSpareTime || !pace_.firstFrame || subdocument_.playback.playing())
        return;
    if (at_.now < *pace_.firstFrame + untilSpareTime)
        return dueAt(*pace_.firstFrame + untilSpareTime);
    pictures_.inSpareTime(std::exchange(platform_.inSpareTime, nullptr));
}

// --- snapshots ---------------------------------------------------------------------------------

// How the scene is seen in a snapshot, at that time.
render::Drawing Session::printed(const ipc::RenditionSnapshot& call, double time,
                                 render::Size size) {
    const ScenePointer scene = subdocument_.scene();
    render::Drawing drawing;
    drawing.scene = scene.get();
    drawing.motion = subdocument_.motion();
    drawing.time = time;
    const auto seen = call.rendition ? shown_.all.find(*call.rendition) : shown_.all.end();
    if (seen != shown_.all.end()) {
        seen->second.see(*scene, subdocument_.motion(), subdocument_.viewGeneration());
        drawing.camera = seen->second.camera(time);
        drawing.display = seen->second.display;
        drawing.display.opened.reset();
    } else {
        drawing.camera = render::cameraOf(*scene, subdocument_.motion(), "", time, size);
        drawing.display = shown_.display;
    }
    drawing.display.samples = printedSamples;
    return drawing;
}

std::optional<ipc::Error> Session::take(const ipc::Id& id, const ipc::RenditionSnapshot& call) {
    const Presentation presentation = *presentationNamed(call.presentation);
    if (const auto error = noPicture(presentation, call.width, call.height))
        return *error;
    if (!subdocument_.scene() && presentation != Presentation::text) {
        const auto faults = subdocument_.diagnostics();
        return notPossible(faults.empty() ? "no scene was loaded" : faults.front().message);
    }
    const auto& span = subdocument_.playback.span();
    ipc::Taken taken{std::clamp(call.time.value_or(shown_.time), span.start,
                                std::max(span.start, span.computed)),
                     std::nullopt};
    render::Image image;
    image.size = {static_cast<int>(call.width), static_cast<int>(call.height)};
    image.stride = static_cast<std::size_t>(4 * call.width);
    std::shared_ptr<const MappedSlot> slot;
    if (shown_.memory && call.offset && call.stride) {
        auto mapped = shown_.memory->map({*call.offset, *call.stride}, call.width, call.height);
        if (const auto* sentence = std::get_if<std::string>(&mapped))
            return ipc::Error{ipc::ErrorCode::invalidParameters, *sentence};
        slot = std::get<std::shared_ptr<const MappedSlot>>(mapped);
        image.pixels = slot->pixels();
        image.stride = static_cast<std::size_t>(*call.stride);
    }
    if (presentation != Presentation::picture) {
        const auto pixels = slot ? std::vector<std::byte>() : pixelsFor(image);
        sheets_.draw(presentation, sheets_.lookOf(presentation, taken.time, 0), call.scale, image);
        if (!slot)
            taken.pixels = ipc::toBase64(pixels);
        channel_.answer(id, taken);
        return std::nullopt;
    }
    Pictures::Wish wish{subdocument_.scene(), printed(call, taken.time, image.size), image, slot};
    if (auto values =
            lettering::valuesBeside(wish.drawing, image.size, call.scale, sheets_.sampled());
        !values.empty())
        wish.over =
            [values = std::move(values), scale = call.scale,
             isDark = render::isDark(wish.drawing.display.background)](const render::Image& into) {
                lettering::drawValues(values, scale, isDark, into);
            };
    pictures_.draw(this, std::move(wish), [this, id, taken](Pictures::Drawn drawn) mutable {
        if (!drawn.isFine)
            return channel_.refuse(id, notPossible(lostState));
        if (!drawn.packed.empty())
            taken.pixels = std::move(drawn.packed);
        channel_.answer(id, taken);
    });
    return std::nullopt;
}

} // namespace service
