#include "views/mesh_job.h"

#include "meshes/mesh_file.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>
#include <QThreadPool>

#include <atomic>
#include <mutex>

namespace views {

namespace {

struct Loaded {
    QString fault;
    std::size_t triangles = 0;
    Eigen::AlignedBox3d box;
    meshes::Solids solids;
};

Loaded load(const QString& path) {
    Loaded loaded;
    const QString name = QFileInfo(path).fileName();
    QFile file(path);
    if (QFileInfo(path).exists() && !QFileInfo(path).isFile()) {
        loaded.fault = MeshJob::tr("%1 is no ordinary file.").arg(name);
        return loaded;
    }
    if (!file.open(QIODevice::ReadOnly)) {
        loaded.fault = MeshJob::tr("Cannot read %1: %2.").arg(name, file.errorString());
        return loaded;
    }
    const QByteArray bytes = file.read(static_cast<qint64>(meshes::mostBytes) + 1);
    const auto read = meshes::readMesh({bytes.constData(), static_cast<std::size_t>(bytes.size())},
                                       name.toStdString());
    if (const auto* refused = std::get_if<meshes::FileFault>(&read)) {
        loaded.fault = QString::fromStdString(refused->sentence);
        return loaded;
    }
    const auto& mesh = std::get<meshes::Mesh>(read);
    loaded.triangles = mesh.triangles.size();
    for (const geometry::Vector& p : mesh.vertices)
        loaded.box.extend(p);
    loaded.solids = meshes::solidsOf(mesh);
    if (loaded.solids.pieces > meshes::mostPieces)
        loaded.fault = MeshJob::tr("%1 has %2 pieces that do not hang together; at most %3 are "
                                   "taken.")
                           .arg(name)
                           .arg(loaded.solids.pieces)
                           .arg(meshes::mostPieces);
    return loaded;
}

MeshResult resultOf(const Loaded& loaded, const meshes::Wanted& wanted, const meshes::GoOn& goOn) {
    MeshResult result;
    result.fault = loaded.fault;
    if (!result.fault.isEmpty())
        return result;
    result.triangles = loaded.triangles;
    result.solids = loaded.solids.solids.size();
    result.openPieces = loaded.solids.open.size();
    result.openEdges = loaded.solids.openEdges;
    result.low = loaded.box.min();
    result.high = loaded.box.max();
    result.made = meshes::convexParts(loaded.solids, wanted, goOn);
    if (result.made.parts.empty() && !result.made.cancelled)
        result.fault = MeshJob::tr("All triangles lie in a plane: there is no solid.");
    return result;
}

} // namespace

struct MeshJob::Shared {
    std::mutex mutex;   // of owner
    MeshJob* owner;     // null when it is gone
    std::mutex loading; // of loaded
    std::shared_ptr<const Loaded> loaded;
    std::atomic<unsigned> serial{0};
};

MeshJob::MeshJob(const QString& path, QObject* parent)
    : QObject(parent), shared_(std::make_shared<Shared>()) {
    shared_->owner = this;
    setObjectName(path);
}

MeshJob::~MeshJob() {
    ++shared_->serial;
    const std::lock_guard lock(shared_->mutex);
    shared_->owner = nullptr;
}

void MeshJob::start(const meshes::Wanted& wanted) {
    const unsigned serial = ++shared_->serial;
    running_ = true;
    QThreadPool::globalInstance()->start([shared = shared_, path = objectName(), wanted, serial] {
        const auto post = [&shared](auto call) {
            const std::lock_guard lock(shared->mutex);
            if (MeshJob* owner = shared->owner)
                QMetaObject::invokeMethod(
                    owner, [owner, call] { call(owner); }, Qt::QueuedConnection);
        };
        std::shared_ptr<const Loaded> loaded;
        {
            const std::lock_guard lock(shared->loading);
            if (!shared->loaded && shared->serial == serial)
                shared->loaded = std::make_shared<const Loaded>(load(path));
            loaded = shared->loaded;
        }
        if (!loaded || shared->serial != serial)
            return;
        QElapsedTimer told;
        told.start();
        const MeshResult result = resultOf(*loaded, wanted, [&](double share) {
            if (told.elapsed() > 50) {
                told.restart();
                post([share](MeshJob* owner) { Q_EMIT owner->progressed(share); });
            }
            return shared->serial == serial;
        });
        post([serial, result](MeshJob* owner) { owner->take(serial, result); });
    });
}

void MeshJob::take(unsigned serial, const MeshResult& result) {
    if (serial != shared_->serial)
        return;
    running_ = false;
    result_ = result;
    Q_EMIT finished();
}

} // namespace views
