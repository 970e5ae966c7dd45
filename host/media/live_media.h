// Which subdocuments may have a process now?
// The nearest to what is seen, at most mostLive() of them over all documents and windows; the
// others are stills, which keep their last picture. None starts either while the memory of all may
// not suffice for it (PipeThread::hasRoom). One that lives is ended only when a nearer one needs
// its place. Views say how near each subdocument is; nobody else starts or stills one.
#pragma once

#include "media/live_subdocument.h"

#include <QHash>

namespace media {

class LiveMedia : public QObject {
    Q_OBJECT

public:
    static constexpr double notNeeded = 1e300;

    LiveMedia(Registry registry, QString executableFolder, PipeThread& pipes,
              TimeLimits limits = {}, QObject* parent = nullptr);

    [[nodiscard]] const Registry& registry() const { return registry_; }
    [[nodiscard]] int mostLive() const { return mostLive_; }
    void setMostLive(int count);

    // Nothing when no medium for the class is installed.
    [[nodiscard]] std::unique_ptr<LiveSubdocument> create(const QString& documentClass);

    // How far from the visible part of `view` it lies, in 1/96 inch: 0 when it is seen.
    void setDistance(LiveSubdocument& subdocument, const void* view, double distance);

private:
    void scheduleChoice();
    void choose();
    [[nodiscard]] std::vector<LiveSubdocument*> byDistance() const;
    [[nodiscard]] int live() const;
    void awaitRoom(LiveSubdocument* another);

    Registry registry_;
    QString executableFolder_;
    PipeThread& pipes_;
    TimeLimits limits_;
    int mostLive_ = 16; // more than a page has figures, mostly
    QHash<LiveSubdocument*, QHash<const void*, double>> distances_;
    QTimer choice_;
    QTimer room_; // until memory is looked at again
};

} // namespace media
