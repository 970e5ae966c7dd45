// What Qt itself says on standard error: often with the name of a file or a font in it, so that it
// is printed like our own messages.
#pragma once

namespace plain {

enum class QtMessages { all, errors };

// From now on. `program` stands before each; it must outlive the process.
void printQtMessages(const char* program, QtMessages which);

} // namespace plain
