// The scenes that come with the program, as the medium's manifest names them.
#pragma once

#include <QList>
#include <QString>

namespace views {

struct Sample {
    QString path;    // of the scene's file
    QString title;   // "Newton's cradle"
    QString about;   // one short sentence
    QString group;   // "Impacts"
    double time = 0; // s; when a picture of it tells most
    bool operator==(const Sample&) const = default;
};

// Those of the manifest whose files are there, in its order. None without a manifest that can be
// read.
[[nodiscard]] QList<Sample> samplesOf(const QString& manifest);

// The manifest beside the program or in its data folder; "" where there is none.
[[nodiscard]] QString manifestOfProgram();

} // namespace views
