#include "service/value_reader.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace service {

// All at once; one by one only where some are faulty, which is seldom and lasts until it is mended.
ValueReader::ValueReader(const scene::Scene& scene, const simulation::Options& options,
                         const simulation::MotionPointer& motion,
                         const std::vector<std::string>& expressions)
    : faults_(expressions.size()) {
    std::vector<std::string> faults;
    sound_.emplace(scene, options, motion, expressions, faults);
    if (faults.empty())
        return;
    std::vector<std::string> sound;
    for (std::size_t i = 0; i < expressions.size(); ++i) {
        std::vector<std::string> own;
        const simulation::Quantities alone(scene, options, motion, {expressions[i]}, own);
        if (own.empty())
            sound.push_back(expressions[i]);
        else
            faults_[i] = own.front();
    }
    faults.clear();
    sound_.emplace(scene, options, motion, sound, faults);
}

ipc::Values ValueReader::at(double time) const {
    const std::vector<double> sound = sound_->at(time);
    ipc::Values read = none("it has no value at this time");
    std::size_t next = 0;
    for (std::size_t i = 0; i < faults_.size(); ++i) {
        if (!faults_[i].empty())
            continue;
        const double value = next < sound.size() ? sound[next] : read.values[i];
        ++next;
        if (!std::isfinite(value))
            continue;
        read.values[i] = value;
        read.faults[i].clear();
    }
    if (std::ranges::all_of(read.faults, &std::string::empty))
        read.faults.clear();
    return read;
}

ipc::Values ValueReader::none(const std::string& why) const {
    ipc::Values read;
    read.values.assign(faults_.size(), std::numeric_limits<double>::quiet_NaN());
    for (const std::string& fault : faults_)
        read.faults.push_back(fault.empty() ? why : fault);
    return read;
}

} // namespace service
