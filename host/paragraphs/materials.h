// The materials of paragraphs: the looks of a model's text styles, and the sizes of objects that
// are not letters. Each is asked for once, and kept from one layout to the next.
#pragma once

#include "model/model.h"

#include <QFont>
#include <QSize>
#include <QSizeF>
#include <QTextCharFormat>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace paragraphs {

// The sizes of objects that are not letters, which the layout must be told.
struct Objects {
    std::function<QSizeF(document::SubdocumentId)> subdocumentSize; // in twips
    // In pixels, of 1/96 inch; empty: there is no such picture.
    std::function<QSize(const std::string& source)> imageSize;
};

class Looks {
public:
    using Styles = std::shared_ptr<const schemas::TextStyles>;
    explicit Looks(Styles styles) : styles_(std::move(styles)) {}
    [[nodiscard]] const Styles& styles() const { return styles_; } // may grow
    [[nodiscard]] const schemas::TextStyle& style(std::uint32_t index) const;
    [[nodiscard]] const QFont& font(std::uint32_t index);
    [[nodiscard]] const QTextCharFormat& format(std::uint32_t index);
    [[nodiscard]] double blank(std::uint32_t index);  // how wide it is, in twips
    [[nodiscard]] double hyphen(std::uint32_t index); // and a hyphen

private:
    struct Look {
        QFont font;
        QTextCharFormat format;
        double blank = 0, hyphen = 0;
    };
    [[nodiscard]] static Look lookOf(const schemas::TextStyle& style);
    const Look& look(std::uint32_t index);

    Styles styles_;
    std::vector<std::optional<Look>> looks_; // of those that were asked for
};

class Sizes {
public:
    // Objects whose sizes are no longer those that were answered.
    struct Changed {
        std::set<document::SubdocumentId> subdocuments;
        std::set<std::string> images;
        [[nodiscard]] bool empty() const { return subdocuments.empty() && images.empty(); }
    };
    // Asks again for all that were asked for: a round.
    void follow(Objects objects);
    [[nodiscard]] std::size_t rounds() const { return rounds_; }
    // The subdocuments and images whose sizes changed in later rounds than that one.
    [[nodiscard]] Changed changedSince(std::size_t round) const;
    [[nodiscard]] QSizeF subdocument(document::SubdocumentId id);
    [[nodiscard]] QSize image(const std::string& source);
    // In twips, as its author wants it, else as its file is.
    [[nodiscard]] QSizeF picture(const model::Picture& picture);

private:
    [[nodiscard]] QSizeF ask(document::SubdocumentId id) const;
    [[nodiscard]] QSize ask(const std::string& source) const;

    template <class Size> struct Asked {
        Size size{};
        std::size_t changed = 0; // the last round in which it has
    };

    Objects objects_;
    std::size_t rounds_ = 0;
    std::map<document::SubdocumentId, Asked<QSizeF>> subdocuments_;
    std::map<std::string, Asked<QSize>> images_;
};

struct Materials {
    explicit Materials(Looks::Styles styles) : looks(std::move(styles)) {}
    Looks looks;
    Sizes sizes{};
    double pictureHeight = 1e9; // the most of a picture, in twips
};

// No larger than that, in its own proportions.
[[nodiscard]] QSizeF fitted(QSizeF size, double width, double height);

} // namespace paragraphs
