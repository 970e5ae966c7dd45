#include "workbench/exporting.h"

#include "batch/picture_file.h"
#include "batch/table.h"
#include "framing/view.h"

#include <cerrno>
#include <cmath>
#include <cstring>
#include <filesystem>

namespace views {

namespace {

constexpr int samples = 8; // of a picture that is kept
constexpr int tableIntervals = 100;

} // namespace

QString labelOf(ExportFormat format) {
    switch (format) {
    case ExportFormat::png:
        return QObject::tr("Picture (*.png)");
    case ExportFormat::ppm:
        return QObject::tr("Picture (*.ppm)");
    case ExportFormat::film:
        return QObject::tr("Pictures of all the motion, 25 a second, in a folder (*)");
    case ExportFormat::table:
        break;
    }
    return QObject::tr("Table of the motion (*.csv)");
}

ExportFormat formatOf(const QString& path, ExportFormat chosen) {
    constexpr std::pair<const char*, ExportFormat> endings[] = {
        {".png", ExportFormat::png}, {".ppm", ExportFormat::ppm}, {".csv", ExportFormat::table}};
    for (const auto& [ending, format] : endings)
        if (path.endsWith(QLatin1String(ending), Qt::CaseInsensitive))
            return format;
    return chosen;
}

QString withEnding(const QString& path, ExportFormat format) {
    const QString ending = format == ExportFormat::png     ? QStringLiteral(".png")
                           : format == ExportFormat::ppm   ? QStringLiteral(".ppm")
                           : format == ExportFormat::table ? QStringLiteral(".csv")
                                                           : QString();
    return path.endsWith(ending, Qt::CaseInsensitive) ? path : path + ending;
}

double filmPictures(const Shown& shown) {
    return shown.motion
               ? std::floor((shown.motion->computed() - shown.motion->start()) * picturesPerSecond +
                            1e-9) +
                     1
               : 1;
}

Exporting::Exporting(ToExport what, QString path, ExportFormat format)
    : what_(std::move(what)), path_(path.toLocal8Bit().toStdString()), format_(format) {
    if (format_ == ExportFormat::film)
        pictures_ = static_cast<int>(std::min<double>(filmPictures(what_.shown), mostPictures));
}

void Exporting::start() {
    thread_ = std::thread([this] { run(); });
}

Exporting::~Exporting() {
    cancelled_ = true;
    if (thread_.joinable())
        thread_.join();
}

void Exporting::run() {
    const std::string fault = format_ == ExportFormat::table ? writeMotion() : drawAll();
    Q_EMIT finished(QString::fromStdString(fault));
}

double Exporting::timeOf(int picture) const {
    return format_ == ExportFormat::film && what_.shown.motion
               ? what_.shown.motion->start() + picture / picturesPerSecond
               : what_.time;
}

std::string Exporting::fileOf(int picture) const {
    if (format_ != ExportFormat::film)
        return path_;
    char name[32];
    std::snprintf(name, sizeof name, "%05d.png", picture + 1);
    return (std::filesystem::path(path_) / name).string();
}

std::string Exporting::drawAll() {
    std::error_code error;
    if (format_ == ExportFormat::film && !std::filesystem::is_directory(path_, error) &&
        !std::filesystem::create_directories(path_, error))
        return path_ + ": " + error.message();
    auto created = render::Renderer::create();
    if (const auto* sentence = std::get_if<std::string>(&created))
        return *sentence;
    render::Renderer& renderer = *std::get<std::unique_ptr<render::Renderer>>(created);
    const auto stride = 4 * static_cast<std::size_t>(what_.size.width);
    std::vector<std::byte> pixels(stride * static_cast<std::size_t>(what_.size.height));
    const render::Image image{pixels, stride, what_.size};
    std::optional<render::SceneView> view;
    if (!what_.view.empty())
        view.emplace(*what_.shown.scene, what_.shown.motion, what_.view, what_.size);
    render::Drawing drawing{what_.shown.scene.get(), what_.shown.motion, 0, what_.camera,
                            what_.display};
    drawing.display.samples = samples;
    const auto format =
        format_ == ExportFormat::ppm ? batch::PictureFormat::ppm : batch::PictureFormat::png;
    for (int i = 0; i < pictures_ && !cancelled_; ++i) {
        drawing.time = timeOf(i);
        if (view)
            drawing.camera = view->at(drawing.time);
        std::string why = "the graphics driver lost its state";
        if (!renderer.draw(drawing, image) || !batch::writePicture(fileOf(i), format, image, why))
            return fileOf(i) + ": " + why;
        Q_EMIT progressed(i + 1);
    }
    return {};
}

std::string Exporting::writeMotion() const {
    const auto& motion = what_.shown.motion;
    if (!motion)
        return "there is no motion yet";
    std::vector<double> times;
    for (int i = 0; i <= tableIntervals; ++i)
        times.push_back(motion->start() +
                        (motion->computed() - motion->start()) * i / tableIntervals);
    std::vector<std::string> faults;
    const simulation::Quantities none(*what_.shown.scene, {}, motion, {}, faults);
    std::FILE* file = std::fopen(path_.c_str(), "wb");
    if (!file)
        return path_ + ": " + std::strerror(errno);
    batch::Columns columns;
    columns.digits = batch::Digits::shortest;
    const bool written = batch::writeTable(file, *what_.shown.scene, *motion, none, columns, times);
    return std::fclose(file) == 0 && written ? std::string() : path_ + ": cannot be written";
}

} // namespace views
