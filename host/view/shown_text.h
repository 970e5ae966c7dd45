// All text that a model shows as one string, for those who read it without looking, and the places
// of the document that its letters are at.
#pragma once

#include "document/document.h"
#include "model/selected.h"

#include <QString>

namespace view {

class ShownText {
public:
    // Block by block, each on a line of its own, cells apart by tabs, footnotes at the end.
    ShownText(const document::Document& document, std::shared_ptr<const model::Model> model);

    [[nodiscard]] const QString& text() const { return text_; }
    [[nodiscard]] bool isOf(const std::shared_ptr<const model::Model>& model) const {
        return model == model_;
    }
    // The place of the document before a letter; of what is generated that of the next text.
    [[nodiscard]] std::optional<std::size_t> placeOf(int letter) const;
    // The letter behind a place, the nearest one where it is not shown.
    [[nodiscard]] int letterAt(std::size_t place) const;

private:
    struct Part { // a run of the document's text
        int from = 0, to = 0;
        const model::Run* run = nullptr;
    };
    void add(const model::Blocks& blocks);
    void add(const model::Block& block);

    const document::Document& document_;
    std::shared_ptr<const model::Model> model_;
    QString text_;
    std::vector<Part> parts_; // in order
};

} // namespace view
