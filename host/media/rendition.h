// The picture of one subdocument in one view: it has a size, shows the subdocument's presentation,
// and outlives the process that drew it.
//
// It belongs to a LiveSubdocument, which talks to the medium. The medium draws into two slots and
// may have two frames that are not acknowledged; each frame is copied out when it comes, and
// acknowledged when a view has painted it: so a view that is not painted costs the medium nothing.
#pragma once

#include "processes/frame_memory.h"

#include "ipc/messages.h"

#include <QObject>
#include <QPointer>

namespace media {

class MediumProcess;
class LiveSubdocument;

class Rendition : public QObject {
    Q_OBJECT

public:
    ~Rendition() override;

    [[nodiscard]] ipc::Integer id() const { return id_; }
    [[nodiscard]] LiveSubdocument* subdocument() const; // nullptr: it was removed from the document

    // The newest picture, null before the first. It stays when the medium is gone.
    [[nodiscard]] const QImage& picture() const { return picture_; }
    [[nodiscard]] ipc::CursorShape cursor() const { return cursor_; }

    void setGeometry(QSize pixels,
                     double scale); // device pixels, and how many there are to 1/96 inch
    void setShown(bool shown);
    void painted(); // the picture is on the screen: the medium may go on
    void input(ipc::Input input);

Q_SIGNALS:
    void pictureChanged();
    void cursorChanged();
    void unhandledInput(const ipc::Input& input); // keys that the medium does not use

private:
    friend class Renditions;
    Rendition(LiveSubdocument& subdocument, ipc::Integer id);

    void attach(MediumProcess* process); // makes itself there; nullptr: the process is gone
    void sendGeometry(bool create);
    void showAnew(); // as the presentation that counts now
    void keepPress(const ipc::Input& input);
    [[nodiscard]] bool take(const ipc::RenditionFrame& frame); // false: not a frame of ours
    [[nodiscard]] QImage decoded(const ipc::RenditionFrame& frame) const;

    QPointer<LiveSubdocument> subdocument_;
    ipc::Integer id_;
    std::string state_; // what the medium last said of how it is seen, for the next process
    QSize pixels_{320, 240};
    double scale_ = 1;
    bool shown_ = false;
    QImage picture_;
    ipc::CursorShape cursor_ = ipc::CursorShape::arrow;
    QPointer<MediumProcess> process_;
    std::optional<ipc::Input> pressed_;   // a button that is held since before there was a process
    std::vector<Slot> slots_;             // that the medium draws into now
    std::vector<ipc::Integer> unpainted_; // serials of frames that are not acknowledged yet
    int unanswered_ = 0;                  // changes of the geometry that the medium has yet to obey
};

} // namespace media
