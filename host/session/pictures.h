// Pictures of all subdocuments for paper: each medium draws at the resolution that is asked for, at
// its POSTER time or as it stands. A few at a time live for that; nothing waits, and one that fails
// is a sentence.
#pragma once

#include "session/open_document.h"

#include <QImage>

namespace session {

struct Picture {
    QImage image;    // null when there is none
    QString error{}; // why there is none, or what is wrong with it
    QString note{};  // what stands in its place and is no error
};

class Pictures : public QObject {
    Q_OBJECT

public:
    // `scale`: device pixels to 1/96 inch. `posters`: at the POSTER time, else as it stands now.
    Pictures(OpenDocument& document, std::vector<document::SubdocumentId> wanted, double scale,
             bool posters, QObject* parent = nullptr);
    ~Pictures() override;

    void start();
    [[nodiscard]] const std::map<document::SubdocumentId, Picture>& pictures() const {
        return pictures_;
    }
    [[nodiscard]] std::size_t remaining() const { return queue_.size() + running_; }

    static constexpr int mostMs = 120'000; // for one of them

Q_SIGNALS:
    void progressed(int done, int all);
    void finished();

private:
    void next();
    void take(document::SubdocumentId wanted);
    void shoot(document::SubdocumentId wanted, media::LiveSubdocument& live);
    void done(document::SubdocumentId wanted, Picture picture);

    OpenDocument& document_;
    std::vector<document::SubdocumentId> queue_; // last one first
    double scale_;
    bool posters_;
    std::size_t running_ = 0;
    int all_ = 0;
    std::map<document::SubdocumentId, Picture> pictures_;
};

} // namespace session
