// Documents for tests, made from a seed: sound ones, and ones that a byte, a tag or a brace was
// changed in. The same seed makes the same document on every machine (std::mt19937_64; no
// std::distribution, whose results are not laid down). A fuzzer gives numbers of its own.
#pragma once

#include <cstdint>
#include <functional>
#include <random>
#include <string>
#include <utility>

namespace sgml {

class RandomDocument {
public:
    using Numbers = std::function<std::uint64_t()>;
    explicit RandomDocument(std::uint64_t seed) : numbers_(std::mt19937_64(seed)) {}
    explicit RandomDocument(Numbers numbers) : numbers_(std::move(numbers)) {}

    [[nodiscard]] std::string sound();
    [[nodiscard]] std::string mutated(std::string document);
    // Text as authors and scenes have it: braces, backslashes, line ends, characters of any length.
    [[nodiscard]] std::string text(std::size_t longest);
    // As `text` is spelled between braces, partly with bare balanced braces.
    [[nodiscard]] std::string spelling(int depth);
    [[nodiscard]] std::size_t below(std::size_t bound) {
        return static_cast<std::size_t>(numbers_() % bound);
    }

private:
    std::string blanks();
    std::string attributes();
    std::string element(int depth);
    std::string nestedDocument(int depth);
    std::string mutatedOnce(std::string document);

    Numbers numbers_;
};

} // namespace sgml
