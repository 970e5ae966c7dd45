// ensemble --check DOCUMENT: every fault of its schemas' files, of the document and of its
// subdocuments, in order of place, on standard output.
#pragma once

#include <QString>

namespace console {

[[nodiscard]] int check(const QString& input);

} // namespace console
