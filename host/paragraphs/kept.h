// A store of what paragraphs can make again: their letters, and lines as Qt laid them out. Of all
// paragraphs together it keeps what was asked for last. Letters and lines have a room each: the
// many lines of a long text do not push out the letters that they are made of. LIMIT: one thread
// lays out and paints.
#pragma once

#include <cstddef>
#include <list>

namespace paragraphs {

class Kept {
public:
    class Owner {
    public:
        virtual void forget(int item) const = 0; // it is kept no longer
    protected:
        ~Owner() = default;
    };
    struct Item {
        const Owner* of = nullptr;
        int item = 0;
        std::size_t letters = 0;
    };
    using Place = std::list<Item>::iterator;

    // So many letters in each room: those of some fifty pages. The last few are kept, however long
    // they are: a long text stays while its page's header is painted, too.
    static constexpr std::size_t most = 200'000, fewest = 8;

    // Never destroyed: paragraphs may live as long as the program.
    [[nodiscard]] static Kept& texts();
    [[nodiscard]] static Kept& lines();

    [[nodiscard]] Place add(const Owner& of, int item, int letters);
    void use(Place place, int letters); // it was asked for, and has so many letters now
    void remove(Place place);
    [[nodiscard]] std::size_t letters() const { return letters_; }

private:
    std::list<Item> items_; // what was asked for last is in front
    std::size_t letters_ = 0;
};

} // namespace paragraphs
