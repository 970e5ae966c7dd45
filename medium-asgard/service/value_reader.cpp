#include "service/value_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace service {

namespace {

// The equations keep what was read of them. After so many expressions they are built anew, so that
// a host that asks for ever new ones does not fill the memory.
constexpr std::size_t mostRead = 20'000;

} // namespace

ipc::Values ValueReader::at(double time) const {
    ipc::Values read{of_.at(time), of_.faults()};
    for (std::size_t i = 0; i < read.values.size(); ++i)
        if (!std::isfinite(read.values[i])) {
            read.values[i] = std::numeric_limits<double>::quiet_NaN();
            if (read.faults[i].empty())
                read.faults[i] = "it has no value at this time";
        }
    if (std::ranges::all_of(read.faults, &std::string::empty))
        read.faults.clear();
    return read;
}

ipc::Values ValueReader::none(const std::string& why) const {
    ipc::Values read{{}, of_.faults()};
    read.values.assign(read.faults.size(), std::numeric_limits<double>::quiet_NaN());
    for (std::string& fault : read.faults)
        if (fault.empty())
            fault = why;
    return read;
}

ValueReader ValueSource::reader(const ScenePointer& scene, const simulation::MotionPointer& motion,
                                const std::vector<std::string>& expressions) {
    read_ += expressions.size();
    if (!scene_ || of_ != scene || read_ > mostRead) {
        scene_.emplace(*scene);
        of_ = scene;
        read_ = expressions.size();
        ++built_;
    }
    return ValueReader(scene_->quantities(motion, expressions));
}

} // namespace service
