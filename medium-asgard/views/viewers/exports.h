// Asks what is to be exported and whereto, and shows how far it is.
#pragma once

#include "workbench/exporting.h"

#include <QObject>
#include <QPointer>
#include <QProgressDialog>

#include <functional>

namespace views {

class Exports : public QObject {
    Q_OBJECT
public:
    explicit Exports(SceneDocument& document, QObject* parent = nullptr);
    ~Exports() override; // ends what is being written

    // The motion and view that a picture is to show; none: no viewer is open.
    std::function<std::optional<ToExport>()> pictured;
    // Instead of boxes that ask and warn, for tests.
    std::function<bool(const QString& question)> agrees;

    void ask();
    // One at a time. Asks before it overwrites, about the name that is written, and where the
    // motion is not (all) that of the scene.
    void write(const QString& path, ExportFormat format);
    [[nodiscard]] bool isBusy() const { return !progress_.isNull(); }

Q_SIGNALS:
    void says(const QString& words);

private:
    [[nodiscard]] bool isAgreed(const QString& question);
    [[nodiscard]] bool mayWrite(const QString& path, ExportFormat format);
    [[nodiscard]] bool isMotionMeant(const Shown& shown, ExportFormat format);
    void begin(ToExport what, const QString& path, ExportFormat format);

    SceneDocument& document_;
    QPointer<QProgressDialog> progress_; // while something is written
};

} // namespace views
