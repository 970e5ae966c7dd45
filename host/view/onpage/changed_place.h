// The place at which a document was changed last: undo and redo lead there.
#pragma once

#include "document/document.h"

namespace view {

class ChangedPlace : public QObject {
    Q_OBJECT

public:
    // The document outlives it.
    explicit ChangedPlace(const document::Document& document) {
        connect(&document, &document::Document::edited, this,
                [this](const sgml::Change&, const text::Edits& back) {
                    if (!back.empty())
                        range_ = {back.front().range.from, back.back().range.to};
                });
    }

    // In the bytes as they are since then. Both ends belong to it.
    [[nodiscard]] bool holds(std::size_t place) const {
        return range_.from <= place && place <= range_.to;
    }
    [[nodiscard]] std::size_t from() const { return range_.from; }

private:
    text::Range range_;
};

} // namespace view
