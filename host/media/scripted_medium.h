// For tests: the medium of tests/media, which behaves as it is told, and an event loop to wait in.
#pragma once

#include "media/live_media.h"

#include <QCoreApplication>
#include <QDir>
#include <QElapsedTimer>
#include <functional>

namespace media::testing {

// Runs events until `done` or `ms` have passed. Tests wait for states, never for times; the limit
// only ends a test that would hang.
inline bool waitFor(const std::function<bool()>& done, int ms = 120'000) {
    QElapsedTimer elapsed;
    elapsed.start();
    while (!done()) {
        if (elapsed.hasExpired(ms))
            return false;
        QCoreApplication::processEvents(QEventLoop::AllEvents | QEventLoop::WaitForMoreEvents, 20);
    }
    return true;
}

inline Manifest scriptedManifest(const QStringList& behaviour = {}) {
    QString fault;
    Manifest manifest;
    manifest.name = "Scripted";
    manifest.documentClass = "SCRIPTED";
    manifest.storage = "SCRIPT";
    manifest.command =
        QStringList(QStringLiteral(SOURCE_DIR "/tests/media/scripted_medium.py")) + behaviour;
    return manifest;
}

// Short enough for tests, long enough for a machine under load.
inline TimeLimits shortLimits() {
    return {.initialize = 120'000,
            .quiet = 300,
            .hung = 2500,
            .shutdown = 500,
            .pingEvery = 50,
            .restartsPerMinute = 0};
}

} // namespace media::testing
