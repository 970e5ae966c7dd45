// ensemble --check-medium COMMAND...: does a program speak the medium protocol?
//
// Starts the program again for each check, confined by nothing but what the host does to every
// medium, and prints one line per check: `ok NAME` or `FAIL NAME: what happened`. A medium must
// refuse properly what its capabilities lack (time). Exit 0 when all checks hold.
#pragma once

#include <QStringList>

namespace console {

[[nodiscard]] int checkMedium(const QStringList& command);

} // namespace console
