#include "media/renditions.h"

#include "media/live_subdocument.h"
#include "processes/medium_process.h"

#include <algorithm>

namespace media {

Renditions::~Renditions() {
    for (Rendition* rendition : all_)
        rendition->subdocument_ = nullptr;
}

std::unique_ptr<Rendition> Renditions::create(LiveSubdocument& of) {
    auto rendition = std::unique_ptr<Rendition>(new Rendition(of, ++last_));
    all_.push_back(rendition.get());
    return rendition;
}

Rendition* Renditions::of(ipc::Integer id) const {
    const auto found = std::ranges::find(all_, id, &Rendition::id);
    return found == all_.end() ? nullptr : *found;
}

bool Renditions::anyPicture() const {
    return std::ranges::any_of(all_, [](const Rendition* one) { return !one->picture().isNull(); });
}

void Renditions::attach(MediumProcess& process) {
    for (Rendition* rendition : all_)
        rendition->attach(&process);
}

void Renditions::attach(Rendition& one, MediumProcess& process) { one.attach(&process); }

void Renditions::detach(const MediumProcess& process) {
    for (Rendition* rendition : all_)
        if (rendition->process_ == &process)
            rendition->attach(nullptr);
}

// --- presentations

void Renditions::setPresentations(std::vector<ipc::Presentation> presentations) {
    presentations_ = std::move(presentations);
}

std::string Renditions::presentation() const {
    if (std::ranges::find(presentations_, wanted_, &ipc::Presentation::id) != presentations_.end())
        return wanted_;
    return presentations_.empty() ? "picture" : presentations_.front().id;
}

bool Renditions::want(const std::string& name) {
    const std::string before = presentation();
    wanted_ = name;
    return presentation() != before;
}

void Renditions::showAnew() {
    for (Rendition* rendition : all_)
        rendition->showAnew();
}

// --- what the medium says of one

Renditions::Taken Renditions::take(const ipc::RenditionFrame& frame) {
    const bool isFirst = !anyPicture();
    Rendition* rendition = of(frame.rendition);
    if (!rendition)
        return Taken::another;
    if (!rendition->take(frame))
        return Taken::faulty;
    return isFirst && !rendition->picture().isNull() ? Taken::first : Taken::another;
}

void Renditions::take(const ipc::RenditionState& state) const {
    if (Rendition* rendition = of(state.rendition))
        rendition->state_ = state.state;
}

void Renditions::take(const ipc::RenditionCursor& cursor) const {
    if (Rendition* rendition = of(cursor.rendition)) {
        rendition->cursor_ = cursor.shape;
        Q_EMIT rendition->cursorChanged();
    }
}

// A listener may scroll the rendition out of use.
void Renditions::take(const ipc::RenditionUnhandled& input) const {
    if (Rendition* rendition = of(input.rendition))
        Q_EMIT rendition->unhandledInput(input);
}

// --- the size

bool Renditions::setAvailable(QSizeF available) {
    return std::exchange(available_, available) != available;
}

ipc::PresentationSize Renditions::askForSize() const {
    ipc::PresentationSize call;
    call.presentation = presentation();
    call.availableWidth = std::clamp(available_.width(), 1.0, 1e6);
    if (available_.height() >= 1)
        call.availableHeight = available_.height();
    return call;
}

bool Renditions::setPreferredSize(QSizeF size) {
    return std::exchange(preferredSize_, size) != size;
}

} // namespace media
