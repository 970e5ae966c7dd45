// The process that serves a host: what is done in which order, so that the document meets a process
// that can do nothing but compute and draw (docs/architecture.md, "Who runs where").
//
//   1. tie its death to the host's          4. read `initialize`: it says the mode
//   2. fork the evaluator server            5. modes play and batch: confine, for good
//   3. open EGL and draw                    6. only then look at the document
#pragma once

#include "script/reader.h"

namespace asgard {

// 1. For `--medium` only: the other commands may outlive the shell that started them.
void dieWithTheHost(int argc, char** argv);

// 3 to 6, until the host is done. Returns the exit code.
[[nodiscard]] int serveAsMedium(script::Reader& reader);

} // namespace asgard
