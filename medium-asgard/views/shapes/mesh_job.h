// A file with a mesh, read and decomposed on a thread of its own (dissertation 7.0.2: concave
// objects).
//
// The last wish counts: an older one that still runs is told to stop, and its result is dropped.
// The file is read once. When the job goes, its thread is told to stop, whatever it does.
#pragma once

#include "meshes/convex_parts.h"

#include <QObject>
#include <QString>

#include <memory>
#include <thread>

namespace views {

struct MeshResult {
    QString fault; // one sentence; "": there are parts
    std::size_t triangles = 0, solids = 0, openPieces = 0, openEdges = 0;
    geometry::Vector low = geometry::Vector::Zero(), high = geometry::Vector::Zero();
    meshes::ConvexParts made;
};

class MeshJob : public QObject {
    Q_OBJECT
public:
    explicit MeshJob(const QString& path, QObject* parent = nullptr);
    ~MeshJob() override; // does not wait

    void start(const meshes::Wanted& wanted);
    [[nodiscard]] bool running() const { return running_; }
    [[nodiscard]] static int threads(); // of all jobs, also of those that are gone
    [[nodiscard]] const MeshResult& result() const { return result_; }

Q_SIGNALS:
    void progressed(double share); // 0..1
    void finished();

private:
    struct Shared;
    void take(unsigned serial, const MeshResult& result);

    std::shared_ptr<Shared> shared_;
    std::thread thread_;
    MeshResult result_;
    bool running_ = false;
};

} // namespace views
