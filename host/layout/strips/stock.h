// The stock that one layout leaves for the next: paragraphs and the widths of tables' columns, by
// block. An entry lives as long as the pages that use it.
#pragma once

#include "paragraphs/paragraph.h"

#include <unordered_map>

namespace layout {

// Of a number, on both sides of the place of its point.
struct NumberWidths {
    double before = 0, behind = 0;
};

// The widths that a block in a cell would like, by so many of its letters, and how many were read
// for it.
struct Measured {
    paragraphs::BlockPointer block;
    paragraphs::Widths widths{};
    std::size_t letters = 0;
    std::optional<NumberWidths> number{}; // that it is
    bool isNoNumber = false;              // it is empty, or a dash
    [[nodiscard]] static bool isOf(const paragraphs::Sizes&) { return true; }
};

// The widths of a table's columns, and what they depend on beside the table.
struct Columns {
    paragraphs::BlockPointer block;
    std::vector<std::shared_ptr<const Measured>> cells{}; // for tables to come
    std::vector<double> widths;
    std::vector<std::optional<double>> points{}; // of columns of numbers, from the left of the cell
    document::TableGrid grid{};
    std::vector<std::size_t> bands{}; // the first row of each, and behind the last
    std::vector<std::pair<document::SubdocumentId, QSizeF>> sizes; // that were asked for

    [[nodiscard]] bool isOf(paragraphs::Sizes& sizesNow) const;
};

class Stock {
public:
    explicit Stock(paragraphs::Looks::Styles styles)
        : materials_(std::make_shared<paragraphs::Materials>(std::move(styles))) {}

    enum class Part { text, withMarker, marker };

    // One that is known, or a new one that has no lines yet. `make` makes it.
    template <class Make>
    [[nodiscard]] std::shared_ptr<paragraphs::Paragraph>
    paragraph(const paragraphs::BlockPointer& block, double width, Part part, Make make) {
        return found<paragraphs::Paragraph>(paragraphs_, {block.get(), width, part}, make);
    }
    template <class Make>
    [[nodiscard]] std::shared_ptr<Columns> columns(const paragraphs::BlockPointer& block,
                                                   double width, Make make) {
        return found<Columns>(columns_, {block.get(), width, Part::text}, make);
    }
    template <class Make>
    [[nodiscard]] std::shared_ptr<Measured> measured(const paragraphs::BlockPointer& block,
                                                     std::size_t letters, Make make) {
        return found<Measured>(measured_, {block.get(), static_cast<double>(letters), Part::text},
                               make);
    }
    [[nodiscard]] const std::shared_ptr<paragraphs::Materials>& materials() const {
        return materials_;
    }
    [[nodiscard]] paragraphs::Sizes& sizes() { return materials_->sizes; }
    [[nodiscard]] std::size_t paragraphsKnown() const { return paragraphs_->size(); }

private:
    struct Key {
        const model::Block* block = nullptr; // which its entry keeps alive
        double width = 0;
        Part part = Part::text;
        bool operator==(const Key&) const = default;
    };
    struct Hash {
        std::size_t operator()(const Key& key) const {
            return std::hash<const void*>()(key.block) * 31 + std::hash<double>()(key.width) * 7 +
                   static_cast<std::size_t>(key.part);
        }
    };
    template <class Thing> using Known = std::unordered_map<Key, std::weak_ptr<Thing>, Hash>;

    // The last one who uses it takes the entry away.
    template <class Thing, class Make>
    std::shared_ptr<Thing> found(const std::shared_ptr<Known<Thing>>& known, const Key& key,
                                 Make make) {
        std::weak_ptr<Thing>& entry = (*known)[key];
        std::shared_ptr<Thing> thing = entry.lock();
        if (thing && thing->isOf(sizes()))
            return thing;
        const auto forget = [key, all = std::weak_ptr(known)](Thing* of) {
            if (const auto from = all.lock()) {
                const auto at = from->find(key);
                if (at != from->end() && at->second.expired())
                    from->erase(at);
            }
            delete of;
        };
        thing = std::shared_ptr<Thing>(make().release(), forget);
        (*known)[key] = thing;
        return thing;
    }

    std::shared_ptr<paragraphs::Materials> materials_;
    std::shared_ptr<Known<paragraphs::Paragraph>> paragraphs_ =
        std::make_shared<Known<paragraphs::Paragraph>>();
    std::shared_ptr<Known<Columns>> columns_ = std::make_shared<Known<Columns>>();
    std::shared_ptr<Known<Measured>> measured_ = std::make_shared<Known<Measured>>();
};

} // namespace layout
