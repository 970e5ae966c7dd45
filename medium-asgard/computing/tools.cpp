#include "computing/tools.h"

#include "resimulation/resimulation.h"

namespace computing {

Tools toolsOf(script::Reader& reader) {
    Tools tools;
    tools.read = [&reader](const std::string& text, const ParameterValues& parameters) {
        return reader.read(text, parameters);
    };
    tools.cancelReading = [&reader] { reader.cancel(); };
    tools.simulate = [kept = std::make_shared<simulation::Resimulation>()](
                         const auto& scene, const auto& options, const auto& observer) {
        return kept->update(scene, options, observer);
    };
    return tools;
}

} // namespace computing
