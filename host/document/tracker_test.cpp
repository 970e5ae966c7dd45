#include "document/tracker.h"
#include "sgml/random_document.h"

#include <gtest/gtest.h>

namespace document {

// A place beside a byte that outlives all edits is beside it in the end, and after all is undone.
TEST(Tracker, PlacesFollowEditsUndoAndRedo) {
    sgml::RandomDocument random(60);
    for (int round = 0; round < 50; ++round) {
        Document document(random.sound() + "|||" + random.sound());
        const std::size_t mark = document.bytes().find("|||") + 1;
        Tracker tracker(document);
        const auto before = tracker.track(mark, text::Gravity::before),
                   behind = tracker.track(mark, text::Gravity::behind);
        for (int step = 0; step < 30; ++step) {
            const std::size_t size = document.bytes().size(), kind = random.below(4);
            const std::size_t now = document.bytes().find("|||");
            std::size_t from = random.below(size + 1), to = std::min(from + random.below(9), size);
            if (from < now + 3 && to > now)
                to = from = now;
            if (kind == 0)
                document.undo();
            else if (kind == 1)
                document.redo();
            else
                (void)document.edit({{{from, to}, random.text(3)}}, "Edit");
            ASSERT_EQ(document.bytes().substr(before->offset - 1, 3), "|||");
            ASSERT_EQ(behind->offset, before->offset);
        }
        while (document.canUndo())
            document.undo();
        EXPECT_EQ(before->offset, mark);
    }
}

// Undone, a deletion brings places back among its bytes; redone, what was typed does.
TEST(Tracker, PlacesInWhatWasDeletedComeBackWithIt) {
    sgml::RandomDocument random(61);
    for (int round = 0; round < 30; ++round) {
        Document document(random.sound() + random.sound());
        Tracker tracker(document);
        std::vector<std::shared_ptr<const Tracker::Place>> places;
        const auto offsets = [&] {
            std::vector<std::size_t> all;
            for (const auto& place : places)
                all.push_back(place->offset);
            return all;
        };
        std::vector<std::vector<std::size_t>> states; // before each step
        for (int step = 0; step < 20; ++step) {
            const std::size_t size = document.bytes().size(), from = random.below(size + 1),
                              to = std::min(from + random.below(40), size);
            for (const text::Gravity gravity : {text::Gravity::before, text::Gravity::behind})
                places.push_back(tracker.track(random.below(size + 1), gravity));
            states.push_back(offsets());
            if (document.edit({{{from, to}, random.text(5)}}, "Edit") != EditResult::applied) {
                states.pop_back();
                places.resize(places.size() - 2);
            }
        }
        const std::vector<std::size_t> last = offsets();
        for (std::size_t step = states.size(); step-- > 0;) {
            document.undo();
            std::vector<std::size_t> now = offsets();
            now.resize(states[step].size());
            ASSERT_EQ(now, states[step]);
        }
        while (document.canRedo())
            document.redo();
        EXPECT_EQ(offsets(), last);
    }
}

TEST(Tracker, AWordKeepsItsEndsWhileItIsWritten) {
    Document document("DOCUMENT A\n<A>{one two}</A>");
    Tracker tracker(document);
    const std::size_t at = document.bytes().find("two");
    const auto from = tracker.track(at, text::Gravity::before),
               to = tracker.track(at + 3, text::Gravity::behind);
    const auto word = [&] {
        return document.bytes().substr(from->offset, to->offset - from->offset);
    };
    (void)document.edit({{{at + 3, at + 3}, "nd"}}, "Type");
    EXPECT_EQ(word(), "twond");
    (void)document.edit({{{at, at}, "x"}}, "Type");
    EXPECT_EQ(word(), "xtwond");
    document.undo();
    document.undo();
    EXPECT_EQ(word(), "two");
    EXPECT_EQ(tracker.size(), 2u);
    (void)tracker.track(0, text::Gravity::behind);
    EXPECT_EQ(tracker.size(), 2u) << "nobody holds the third";
}

} // namespace document
