// Saving, with a question where a file is not replaced without one.
#pragma once

#include "files/save.h"

#include <QWidget>

#include <functional>

namespace panes {

// A saving that is refused for a reason is done all the same when the user says so. A failure is
// told. True: it is saved.
[[nodiscard]] bool saveAsking(QWidget* over, const QString& title,
                              const std::function<files::SaveResult(files::SaveOptions)>& saving);

} // namespace panes
