// write_at_length COUNT SEED [FILE | -]: COUNT random commands, 100 on each new document, or on
// that of the file, or (-) on any documents, with or without faults, from a seed on. Ends with 1 at
// the first that leaves a fault, loses a letter or is not undone; the same checks as the test, at
// any size.
#include "authors/random_author.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string_view>

int main(int count, char** arguments) {
    if (count != 3 && count != 4) {
        std::fprintf(stderr, "usage: write_at_length COUNT SEED [FILE | -]\n");
        return 2;
    }
    std::ostringstream file;
    const bool isAny = count == 4 && std::string_view(arguments[3]) == "-";
    if (count == 4 && !isAny)
        file << std::ifstream(arguments[3], std::ios::binary).rdbuf();
    const unsigned long long commands = std::strtoull(arguments[1], nullptr, 10);
    const unsigned long long first = std::strtoull(arguments[2], nullptr, 10);
    authors::RandomAuthor::Tally all;
    for (unsigned long long done = 0; done < commands; done += 100) {
        authors::RandomAuthor author(first + done / 100);
        const auto write = [&] {
            if (count == 3)
                return author.write(100);
            return author.write(100, isAny ? author.anyDocument() : file.str());
        };
        if (const std::string wrong = write(); !wrong.empty()) {
            std::printf("seed %llu: %s\n", first + done / 100, wrong.c_str());
            return 1;
        }
        all.steps += author.tally().steps;
        all.refusals += author.tally().refusals;
        all.replaced += author.tally().replaced;
    }
    std::printf("%zu steps, %zu refusals, %zu bytes replaced, from seed %llu: nothing wrong\n",
                all.steps, all.refusals, all.replaced, first);
    return 0;
}
