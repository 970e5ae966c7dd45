// Qt's own messages on standard error often have the name of a file or a font in them, so they are
// printed like ours.
#pragma once

namespace plain {

enum class QtMessages { all, errors };

// From now on. `program` stands before each; it must outlive the process.
void printQtMessages(const char* program, QtMessages which);

} // namespace plain
