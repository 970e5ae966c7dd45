// The process that serves a host: what is done in which order, so that the document meets a process
// that can do nothing but compute and draw (docs/architecture.md, "Processes").
//
//   1. tie its death to the host's, and     4. read `initialize`: it says the mode
//      let no signal out                    5. modes play and batch: confine, for good
//   2. fork the evaluator servers           6. only then look at the document
//   3. open EGL and draw
#pragma once

#include "script/reader.h"

namespace asgard {

// 1. For `--medium` only: the other commands may outlive the shell that started them.
void tieToTheHost(int argc, char** argv);

// 3 to 6, until the host is done. Returns the exit code.
[[nodiscard]] int serveAsMedium(script::Reader& reader);

} // namespace asgard
