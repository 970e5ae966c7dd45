// Exports a scene into files of other programs (dissertation 4.1.10): the picture that a viewer
// shows, pictures of all the motion, the motion as a table.
//
// Drawn and written on a thread of its own, which no window waits for.
#pragma once

#include "render/renderer.h"
#include "workbench/scene_document.h"

#include <QObject>

#include <atomic>
#include <thread>

namespace views {

struct ToExport {
    Shown shown;
    double time = 0;
    render::Camera camera;
    std::string view; // of the scene, followed; "": the camera stays
    render::Display display;
    render::Size size;
};

enum class ExportFormat { png, ppm, film, table };

[[nodiscard]] QString labelOf(ExportFormat format); // as a file dialog has it: "Picture (*.png)"
// The one that the name's ending asks for, whatever was chosen beside it.
[[nodiscard]] ExportFormat formatOf(const QString& path, ExportFormat chosen);
// With the ending that the format wants.
[[nodiscard]] QString withEnding(const QString& path, ExportFormat format);

inline constexpr double picturesPerSecond = 25; // of a film
inline constexpr int mostPictures = 100'000;
[[nodiscard]] double filmPictures(const Shown& shown); // however many these are

class Exporting : public QObject {
    Q_OBJECT
public:
    // A film's `path` is a folder, which is made; it has at most mostPictures.
    Exporting(ToExport what, QString path, ExportFormat format);
    ~Exporting() override; // gives up

    [[nodiscard]] int pictures() const { return pictures_; } // of a film; else 1
    void start();
    void cancel() { cancelled_ = true; }

Q_SIGNALS:
    void progressed(int pictures);
    void finished(const QString& fault); // "" when all is written, or it was cancelled

private:
    void run();
    [[nodiscard]] std::string drawAll();
    [[nodiscard]] std::string writeMotion() const;
    [[nodiscard]] double timeOf(int picture) const;
    [[nodiscard]] std::string fileOf(int picture) const;

    ToExport what_;
    std::string path_;
    ExportFormat format_;
    int pictures_ = 1;
    std::atomic<bool> cancelled_{false};
    std::thread thread_;
};

} // namespace views
