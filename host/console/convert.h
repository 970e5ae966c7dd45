// ensemble --convert-to FORMAT [--output FILE|DIR] [--presentation NAME] DOCUMENT
#pragma once

#include <QString>

namespace console {

enum ExitCode { success = 0, failure = 1, wrongUsage = 2 };

struct Conversion {
    QString format; // pdf, png or text
    QString input;  // "-": standard input
    QString output; // "": the document's name in the current directory; "-": standard output
    QString presentation{}; // "": the class's first
};

[[nodiscard]] int convert(const Conversion& conversion);

} // namespace console
