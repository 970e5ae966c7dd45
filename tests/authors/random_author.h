// Somebody who writes at random: documents made from a seed, and commands at random places.
#pragma once

#include "authoring/authoring.h"
#include "manuscript/places.h"
#include "sgml/random_document.h"

#include <string>
#include <utility>

namespace authors {

using namespace authoring; // whose commands these are
using manuscript::place, manuscript::placeBeside, manuscript::widened;

class RandomAuthor {
public:
    explicit RandomAuthor(std::uint64_t seed) : random_(seed) {}
    explicit RandomAuthor(sgml::RandomDocument::Numbers numbers) : random_(std::move(numbers)) {}

    // A memo or a report in which the class's schema finds no fault.
    [[nodiscard]] std::string document();

    // `count` commands on one new document. After each one the structure is as valid as before, no
    // letter outside of the selection is lost, and the new selection stands at places of a caret.
    // At the end all of it is undone, which gives the first bytes, and done again. What went wrong,
    // or "".
    [[nodiscard]] std::string write(std::size_t count);
    // The same on a given document; where that has faults, only that all of it is undone and done
    // again.
    [[nodiscard]] std::string write(std::size_t count, const std::string& first);
    // A document with any elements in any order, perhaps a broken one.
    [[nodiscard]] std::string anyDocument();

    struct Tally {
        std::size_t steps = 0, refusals = 0, replaced = 0; // bytes
    };
    [[nodiscard]] const Tally& tally() const { return tally_; }

private:
    std::string element(const std::string& name, const std::string& inside);
    std::string text();
    std::string line(int depth);
    std::string inlined(int depth);
    std::string blocks(int depth);
    std::string block(int depth);
    std::string list(int depth);
    std::string table(int depth);
    std::string cell(const std::string& inside);
    std::string section(int depth);
    std::string animation();
    std::string gap();
    [[nodiscard]] std::size_t below(std::size_t bound) { return random_.below(bound); }

    struct Try {
        std::string what;
        Result result;
        bool keepsLetters = true; // outside of the selection
        bool keepsAll = false;    // those of the whole document
    };
    Try tryCommand(const Manuscript& manuscript, Selection selection);
    Try tryTable(const Manuscript& manuscript, Selection selection);
    Selection randomSelection(const Manuscript& manuscript, Selection last);

    sgml::RandomDocument random_;
    std::size_t ids_ = 0;
    Tally tally_;
};

} // namespace authors
