// Documents for tests, made from a seed: sound ones, and ones that a byte, a tag or a brace was
// changed in. The same seed makes the same document on every machine (std::mt19937_64; no
// std::distribution, whose results are not laid down).
#pragma once

#include <cstdint>
#include <random>
#include <string>

namespace sgml {

class RandomDocument {
public:
    explicit RandomDocument(std::uint64_t seed) : random_(seed) {}

    [[nodiscard]] std::string sound();
    [[nodiscard]] std::string mutated(std::string document);
    // Text as authors and scenes have it: braces, backslashes, line ends, characters of any length.
    [[nodiscard]] std::string text(std::size_t longest);
    // As `text` is spelled between braces, partly with bare balanced braces.
    [[nodiscard]] std::string spelling(int depth);
    [[nodiscard]] std::size_t below(std::size_t bound) {
        return static_cast<std::size_t>(random_() % bound);
    }

private:
    std::string blanks();
    std::string attributes();
    std::string element(int depth);
    std::string nestedDocument(int depth);
    std::string mutatedOnce(std::string document);

    std::mt19937_64 random_;
};

} // namespace sgml
