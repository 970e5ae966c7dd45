#include "media/kept_windows.h"

#include <utility>

namespace media {

void KeptWindows::keep(const std::string& state) {
    if (state.size() > longest)
        return;
    state_ = state;
    untried_ = false;
    if (state_.empty())
        notice_.clear();
}

std::optional<ipc::SessionRestore> KeptWindows::handOver(const QString& medium,
                                                         const QString& why) {
    if (!any())
        return std::nullopt;
    untried_ = true;
    notice_ =
        why.isEmpty()
            ? QStringLiteral("The windows of %1 are open again with what was typed.").arg(medium)
            : QStringLiteral("%1 Its windows are open again with what was typed.").arg(why);
    return ipc::SessionRestore{state_, notice_.toStdString()};
}

bool KeptWindows::opensAgain() {
    notice_.clear();
    return !std::exchange(untried_, false) && any();
}

bool KeptWindows::dismiss() { return !std::exchange(notice_, {}).isEmpty(); }

} // namespace media
