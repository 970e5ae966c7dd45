// How long the interface's thread is busy between two events of a large scene: the longest piece of
// each kind, in its processor time.
#pragma once

#include "measurement.h"

namespace script {
class Reader;
}

namespace bench {

// Opens, drags, selects, undoes and plays in a scene of `bodies` bodies.
void measureCrowd(const Measurement& measurement, script::Reader& reader, int bodies);

} // namespace bench
