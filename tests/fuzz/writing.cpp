// Any bytes are a document in which somebody writes: each command leaves a structure as valid as it
// was and loses no letter outside of the selection; all undone gives the first bytes.
#include "input.h"
#include "require.h"

#include "authors/random_author.h"

#include <cstdio>
#include <random>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    fuzz::Input input(data, size);
    // The last third says which commands, and where; behind its end they follow from a seed.
    const std::string_view script = input.last(size / 3);
    const std::string first(input.rest());
    fuzz::Input steps(reinterpret_cast<const std::uint8_t*>(script.data()), script.size());
    std::mt19937_64 further(1);
    authors::RandomAuthor author(
        [&] { return steps.atEnd() ? further() : std::uint64_t{steps.below(1 << 16)}; });
    const std::string wrong = author.write(1 + script.size() / 8, first);
    if (!wrong.empty())
        std::fprintf(stderr, "%s\n", wrong.c_str());
    FUZZ_REQUIRE(wrong.empty());
    return 0;
}
