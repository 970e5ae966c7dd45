// A medium's samples to begin with: a grid of pictures, each with a name and a line about it, and
// beside it the groups of samples, where the manifest has some.
#pragma once

#include "media/live_media.h"

#include <QDialog>

class QListWidget;

namespace session {
class SamplePictures;
}

namespace menus {

class GalleryDialog : public QDialog {
    Q_OBJECT

public:
    // The medium draws the pictures while the dialog is open; they are kept for the next time.
    GalleryDialog(media::LiveMedia& media, const media::Manifest& manifest, QWidget* parent);
    ~GalleryDialog() override;

    [[nodiscard]] int chosen() const; // of Manifest::samples; -1: none

private:
    void fill(const media::Manifest& manifest);
    void askForPictures(media::LiveMedia& media, const media::Manifest& manifest);
    void show(int sample, const QPixmap& picture);
    void fillGroups(const media::Manifest& manifest);
    void showGroup(const media::Manifest& manifest);

    QListWidget* list_;
    QListWidget* groups_; // "All" first
    session::SamplePictures* pictures_ = nullptr;
};

} // namespace menus
