// The texts that a medium proposes to begin with, with pictures of them that the medium draws; and
// texts of media in files.
#pragma once

#include "media/live_media.h"

#include <QImage>

namespace session {

struct MediumText {
    std::string text{};
    QString fault{}; // why there is none, as a sentence
};

// UTF-8 of at most so many bytes as a message to a medium takes.
[[nodiscard]] MediumText readMediumText(const QString& file);

// Draws the samples of one medium, one after another, in one process of mode `batch`. Nothing
// waits; a sample that cannot be drawn has no picture and a sentence.
class SamplePictures : public QObject {
    Q_OBJECT

public:
    // `scale`: device pixels to 1/96 inch.
    SamplePictures(media::LiveMedia& media, const media::Manifest& manifest, QSize pixels,
                   double scale, QObject* parent = nullptr);
    ~SamplePictures() override;

    void add(int sample);

    static constexpr int mostMs = 20'000; // for one of them

Q_SIGNALS:
    void drawn(int sample, const QImage& picture);
    void failed(int sample, const QString& sentence);

private:
    void next();
    void shoot();
    void done(const media::LiveSubdocument::Snapshot& snapshot);

    media::LiveMedia& media_;
    media::Manifest manifest_;
    QSize pixels_;
    double scale_;
    std::unique_ptr<media::LiveSubdocument> live_;
    std::vector<int> waiting_; // last one first
    std::optional<int> current_;
    bool isLoaded_ = false, isAsked_ = false; // the current one
    int asked_ = 0;
    QTimer timer_;
};

} // namespace session
