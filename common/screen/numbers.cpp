#include "screen/numbers.h"

#include <clocale>
#include <cstdlib>
#include <string>

namespace screen {

void keepNumbersC() {
    // LC_ALL would hold for numbers, too: it is spread over the other categories.
    if (const char* all = std::getenv("LC_ALL"); all && *all) {
        const std::string language = all;
        for (const char* category :
             {"LANG", "LC_CTYPE", "LC_TIME", "LC_COLLATE", "LC_MONETARY", "LC_MESSAGES", "LC_PAPER",
              "LC_NAME", "LC_ADDRESS", "LC_TELEPHONE", "LC_MEASUREMENT", "LC_IDENTIFICATION"})
            setenv(category, language.c_str(), 1);
        unsetenv("LC_ALL");
    }
    setenv("LC_NUMERIC", "C", 1);
    std::setlocale(LC_NUMERIC, "C");
}

} // namespace screen
