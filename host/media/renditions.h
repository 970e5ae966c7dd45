// The pictures of a subdocument in all views, as which presentation they show it, and the size that
// its medium would like. They outlive the process that draws them.
#pragma once

#include "media/rendition.h"

#include <QSizeF>
#include <memory>
#include <optional>
#include <vector>

namespace media {

class Renditions {
public:
    Renditions() = default;
    ~Renditions(); // those that live on know that their subdocument is gone
    Renditions(const Renditions&) = delete;
    Renditions& operator=(const Renditions&) = delete;

    [[nodiscard]] std::unique_ptr<Rendition> create(LiveSubdocument& of);
    void forget(const Rendition& rendition) { std::erase(all_, &rendition); }
    [[nodiscard]] Rendition* of(ipc::Integer id) const; // null: there is none
    [[nodiscard]] bool anyPicture() const;

    // That process draws them from now on: all of them, or one.
    void attach(MediumProcess& process);
    static void attach(Rendition& one, MediumProcess& process);
    void detach(const MediumProcess& process); // it draws nothing more

    // --- presentations
    void setPresentations(std::vector<ipc::Presentation> presentations);
    [[nodiscard]] const std::vector<ipc::Presentation>& presentations() const {
        return presentations_;
    }
    // Of another name than those, and of "", the first counts. True when another one counts now.
    bool want(const std::string& name);
    [[nodiscard]] std::string presentation() const; // that counts
    void showAnew();

    // --- what the medium says of one
    enum class Taken { another, first, faulty };
    // A frame that was on its way when its rendition was destroyed is no fault.
    [[nodiscard]] Taken take(const ipc::RenditionFrame& frame);
    void take(const ipc::RenditionState& state) const;
    void take(const ipc::RenditionCursor& cursor) const;
    void take(const ipc::RenditionUnhandled& input) const;

    // --- the size, in 1/96 inch
    // The most room that there is. False: it is as it was.
    [[nodiscard]] bool setAvailable(QSizeF available);
    [[nodiscard]] ipc::PresentationSize askForSize() const;
    // False: it is as it was.
    [[nodiscard]] bool setPreferredSize(QSizeF size);
    [[nodiscard]] std::optional<QSizeF> preferredSize() const { return preferredSize_; }

private:
    std::vector<Rendition*> all_;
    ipc::Integer last_ = 0; // id
    std::vector<ipc::Presentation> presentations_;
    std::string wanted_; // presentation; "": the first
    std::optional<QSizeF> preferredSize_;
    QSizeF available_{640, 0};
};

} // namespace media
