#include "media/rendition.h"

#include "media/live_subdocument.h"
#include "processes/medium_process.h"

namespace media {

namespace {

void freeSlots(const QPointer<MediumProcess>& process, const std::vector<Slot>& slots) {
    if (process)
        for (const Slot& slot : slots)
            process->frames().free(slot);
}

} // namespace

Rendition::Rendition(LiveSubdocument& subdocument, ipc::Integer id)
    : subdocument_(&subdocument), id_(id) {}

LiveSubdocument* Rendition::subdocument() const { return subdocument_; }

Rendition::~Rendition() {
    // Until it answers, the medium may be drawing into them.
    if (process_)
        process_->request(ipc::RenditionDestroy{id_},
                          [process = process_, slots = slots_](const Outcome<ipc::Done>&) {
                              freeSlots(process, slots);
                          });
    if (subdocument_)
        subdocument_->forget(*this);
}

void Rendition::showAnew() {
    if (process_)
        sendGeometry(false);
}

void Rendition::setGeometry(QSize pixels, double scale) {
    pixels = pixels.expandedTo({1, 1}).boundedTo({8192, 8192});
    if (pixels == pixels_ && scale == scale_)
        return;
    pixels_ = pixels;
    scale_ = scale;
    if (process_)
        sendGeometry(false);
}

void Rendition::setShown(bool shown) {
    if (shown == shown_)
        return;
    shown_ = shown;
    if (!process_)
        return;
    if (shown)
        process_->notify(ipc::RenditionShow{id_});
    else
        process_->notify(ipc::RenditionHide{id_});
    if (!shown)
        painted(); // nobody will, and the medium must not wait for it
}

void Rendition::painted() {
    for (const ipc::Integer serial : std::exchange(unpainted_, {}))
        if (process_)
            process_->notify(ipc::RenditionAck{id_, serial});
}

void Rendition::input(ipc::Input input) {
    if (!process_)
        return keepPress(input);
    if (input.type == ipc::InputType::move && process_->isCongested())
        return;
    input.rendition = id_;
    if (input.text.size() > ipc::longestInput.most)
        input.text.clear(); // LIMIT: what an input method types at once is short
    process_->notify(ipc::RenditionInput{input});
}

void Rendition::attach(MediumProcess* process) {
    slots_.clear(); // they went with the memory of the process before
    unpainted_.clear();
    unanswered_ = 0;
    process_ = process;
    if (!process_)
        return;
    sendGeometry(true);
    if (shown_)
        process_->notify(ipc::RenditionShow{id_});
    if (auto pressed = std::exchange(pressed_, std::nullopt)) {
        ipc::Input chosen;
        chosen.type = ipc::InputType::focusIn;
        input(chosen);
        input(std::move(*pressed));
    }
}

// A drag that begins before there is a process goes on where it began.
void Rendition::keepPress(const ipc::Input& input) {
    if (input.type == ipc::InputType::press)
        pressed_ = input;
    else if (input.type == ipc::InputType::release || input.type == ipc::InputType::focusOut)
        pressed_.reset();
}

void Rendition::sendGeometry(bool create) {
    ipc::RenditionCreate geometry;
    geometry.rendition = id_;
    geometry.state = state_;
    geometry.presentation = subdocument_->presentation();
    geometry.width = pixels_.width();
    geometry.height = pixels_.height();
    geometry.scale = scale_;
    std::vector<Slot> slots;
    for (int i = 0; i < 2; ++i)
        if (const auto slot = process_->frames().allocate(pixels_.width(), pixels_.height()))
            slots.push_back(*slot);
    if (slots.size() <
        2) { // LIMIT: without room in the shared memory its pictures come by the pipe
        for (const Slot& slot : slots)
            process_->frames().free(slot);
        slots.clear();
    }
    for (const Slot& slot : slots)
        geometry.slots.push_back({slot.offset, slot.stride});
    // Until it answers, the medium may be drawing into the slots of before. It may count its
    // pictures from there anew, so those of before are not held against it.
    painted();
    ++unanswered_;
    const QPointer<Rendition> self = this;
    const auto done = [self, process = process_, retired = slots_](const Outcome<ipc::Done>&) {
        freeSlots(process, retired);
        if (self && self->process_ == process) {
            --self->unanswered_;
            self->painted();
        }
    };
    slots_ = std::move(slots);
    if (create)
        process_->request(geometry, done);
    else
        process_->request(ipc::RenditionResize{geometry}, done);
}

QImage Rendition::decoded(const ipc::RenditionFrame& frame) const {
    const auto expected = static_cast<std::size_t>(frame.width * frame.height * 4 + 2) / 3 * 4;
    if (frame.pixels->size() != expected)
        return {};
    const QByteArray bytes = QByteArray::fromBase64(QByteArray::fromStdString(*frame.pixels));
    const QImage image(reinterpret_cast<const uchar*>(bytes.constData()),
                       static_cast<int>(frame.width), static_cast<int>(frame.height),
                       static_cast<qsizetype>(frame.width) * 4, QImage::Format_RGB32);
    return bytes.size() == frame.width * frame.height * 4 ? image.copy() : QImage();
}

bool Rendition::take(const ipc::RenditionFrame& frame) {
    constexpr std::size_t mostAhead = 2;
    unpainted_.push_back(frame.serial);
    if (unpainted_.size() > (unanswered_ > 0 ? 2 * mostAhead : mostAhead))
        return false;
    if (QSize(static_cast<int>(frame.width), static_cast<int>(frame.height)) != pixels_) {
        painted(); // of a size before: acknowledged and dropped
        return true;
    }
    QImage picture;
    if (frame.pixels)
        picture = decoded(frame);
    else if (frame.slot >= 0 && frame.slot < static_cast<ipc::Integer>(slots_.size()))
        picture = process_->frames().picture(slots_[static_cast<std::size_t>(frame.slot)],
                                             frame.width, frame.height);
    if (picture.isNull())
        return false;
    picture_ = picture;
    if (!shown_)
        painted();
    Q_EMIT pictureChanged();
    return true;
}

} // namespace media
