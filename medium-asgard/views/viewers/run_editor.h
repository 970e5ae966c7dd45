// The stand-alone program: how it begins, and its unsaved work.
#pragma once

#include <string>

namespace script {
class Reader;
}

namespace views {

// One window with the picture and its panes; `file` may be "": then the first page. `reader` was
// made before anything else of this process. Returns the exit code.
int runEditor(int argc, char** argv, const std::string& file, script::Reader& reader);

} // namespace views
