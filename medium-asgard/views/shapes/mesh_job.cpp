#include "shapes/mesh_job.h"

#include "meshes/mesh_file.h"

#include <QElapsedTimer>
#include <QFile>
#include <QFileInfo>

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <optional>
#include <utility>

namespace views {

namespace {

struct Loaded {
    QString fault;
    std::size_t triangles = 0;
    Eigen::AlignedBox3d box;
    meshes::Solids solids;
};

Loaded load(const QString& path, const meshes::GoOn& goOn) {
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
                                       name.toStdString(), goOn);
    if (const auto* refused = std::get_if<meshes::FileFault>(&read)) {
        loaded.fault = QString::fromStdString(refused->sentence);
        return loaded;
    }
    const auto& mesh = std::get<meshes::Mesh>(read);
    loaded.triangles = mesh.triangles.size();
    for (const geometry::Vector& p : mesh.vertices)
        loaded.box.extend(p);
    loaded.solids = meshes::solidsOf(mesh, goOn);
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

// The threads of jobs that are gone. They were told to stop and end soon; no window waits for that,
// and the process does not end before.
class Leaving {
public:
    ~Leaving() {
        for (One& one : all_)
            one.thread.join();
    }
    void add(std::thread thread, std::shared_ptr<const std::atomic<bool>> ended) {
        for (One& one : all_)
            if (*one.ended)
                one.thread.join(); // at once
        std::erase_if(all_, [](const One& one) { return !one.thread.joinable(); });
        all_.push_back({std::move(thread), std::move(ended)});
    }

private:
    struct One {
        std::thread thread;
        std::shared_ptr<const std::atomic<bool>> ended;
    };
    std::vector<One> all_;
};

Leaving& leaving() {
    static Leaving all;
    return all;
}

std::atomic<int> threadsAlive{0};

} // namespace

struct MeshJob::Shared {
    std::mutex mutex; // of owner and wish
    std::condition_variable wished;
    MeshJob* owner; // null when it is gone
    std::optional<meshes::Wanted> wish;
    std::atomic<unsigned> serial{0}; // of the last wish
    std::atomic<bool> left{false};   // the owner is gone
    std::atomic<bool> ended{false};

    void run(const QString& path);

private:
    void post(const std::function<void(MeshJob*)>& call);
    [[nodiscard]] MeshResult made(const Loaded& loaded, const meshes::Wanted& wanted, unsigned of);
};

void MeshJob::Shared::post(const std::function<void(MeshJob*)>& call) {
    const std::lock_guard lock(mutex);
    if (MeshJob* to = owner)
        QMetaObject::invokeMethod(
            to, [to, call] { call(to); }, Qt::QueuedConnection);
}

MeshResult MeshJob::Shared::made(const Loaded& loaded, const meshes::Wanted& wanted, unsigned of) {
    QElapsedTimer told;
    told.start();
    return resultOf(loaded, wanted, [&](double share) {
        if (told.elapsed() > 50) {
            told.restart();
            post([share](MeshJob* to) { Q_EMIT to->progressed(share); });
        }
        return !left && serial == of;
    });
}

void MeshJob::Shared::run(const QString& path) {
    std::optional<Loaded> loaded;
    while (!left) {
        std::unique_lock lock(mutex);
        wished.wait(lock, [&] { return left || wish; });
        if (left)
            break;
        const meshes::Wanted wanted = *std::exchange(wish, std::nullopt);
        const unsigned of = serial;
        lock.unlock();
        if (!loaded)
            loaded = load(path, [this](double) { return !left; });
        const MeshResult result = made(*loaded, wanted, of);
        post([of, result](MeshJob* to) { to->take(of, result); });
    }
    ended = true;
}

MeshJob::MeshJob(const QString& path, QObject* parent)
    : QObject(parent), shared_(std::make_shared<Shared>()) {
    shared_->owner = this;
    setObjectName(path);
}

MeshJob::~MeshJob() {
    {
        const std::lock_guard lock(shared_->mutex);
        shared_->owner = nullptr;
        shared_->left = true;
    }
    shared_->wished.notify_one();
    if (thread_.joinable())
        leaving().add(std::move(thread_), {shared_, &shared_->ended});
}

void MeshJob::start(const meshes::Wanted& wanted) {
    {
        const std::lock_guard lock(shared_->mutex);
        ++shared_->serial;
        shared_->wish = wanted;
    }
    running_ = true;
    shared_->wished.notify_one();
    if (thread_.joinable())
        return;
    ++threadsAlive;
    thread_ = std::thread([shared = shared_, path = objectName()] {
        shared->run(path);
        --threadsAlive;
    });
}

int MeshJob::threads() { return threadsAlive; }

void MeshJob::take(unsigned serial, const MeshResult& result) {
    if (serial != shared_->serial)
        return;
    running_ = false;
    result_ = result;
    Q_EMIT finished();
}

} // namespace views
