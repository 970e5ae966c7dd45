#include "media/value_watch.h"

namespace media {

ValueWatch::Commands ValueWatch::watch(std::vector<std::string> expressions) {
    if (expressions.size() > most)
        expressions.resize(most);
    Commands commands;
    if (expressions == expressions_)
        return commands;
    if (!expressions_.empty())
        commands.end = ipc::ValueUnsubscribe{id_};
    ++id_;
    expressions_ = std::move(expressions);
    values_ = {};
    commands.begin = forNextProcess();
    return commands;
}

std::optional<ipc::ValueSubscribe> ValueWatch::forNextProcess() const {
    if (expressions_.empty())
        return std::nullopt;
    return ipc::ValueSubscribe{id_, expressions_};
}

ValueWatch::Heard ValueWatch::told(const ipc::ValueChanged& report) {
    if (report.id != id_)
        return Heard::old;
    if (report.values.size() != expressions_.size() ||
        (!report.faults.empty() && report.faults.size() != report.values.size()))
        return Heard::faulty;
    values_ = {report.values, report.faults};
    return Heard::taken;
}

} // namespace media
