#include "paragraphs/materials.h"

#include "paragraphs/measure.h"
#include "paragraphs/typeface.h"

#include <QFontMetricsF>
#include <algorithm>
#include <utility>

namespace paragraphs {

const schemas::TextStyle& Looks::style(std::uint32_t index) const {
    static const schemas::TextStyle plain;
    return styles_ && index < styles_->size() ? (*styles_)[index] : plain;
}

Looks::Look Looks::lookOf(const schemas::TextStyle& style) {
    const QFont font = fontOf(style);
    const QFontMetricsF metrics(font);
    return {font, formatOf(style), metrics.horizontalAdvance(QChar(' ')),
            metrics.horizontalAdvance(QChar('-'))};
}

const Looks::Look& Looks::look(std::uint32_t index) {
    static const Look plain = lookOf({});
    if (!styles_ || index >= styles_->size())
        return plain;
    looks_.resize(styles_->size());
    std::optional<Look>& known = looks_[index];
    if (!known)
        known = lookOf(style(index));
    return *known;
}

const QFont& Looks::font(std::uint32_t index) { return look(index).font; }
const QTextCharFormat& Looks::format(std::uint32_t index) { return look(index).format; }
double Looks::blank(std::uint32_t index) { return look(index).blank; }
double Looks::hyphen(std::uint32_t index) { return look(index).hyphen; }

void Sizes::follow(Objects objects) {
    objects_ = std::move(objects);
    ++rounds_;
    const auto askAll = [this](auto& all) {
        for (auto& [name, asked] : all)
            if (std::exchange(asked.size, ask(name)) != asked.size)
                asked.changed = rounds_;
    };
    askAll(subdocuments_);
    askAll(images_);
}

Sizes::Changed Sizes::changedSince(std::size_t round) const {
    Changed changed;
    for (const auto& [id, asked] : subdocuments_)
        if (asked.changed > round)
            changed.subdocuments.insert(id);
    for (const auto& [source, asked] : images_)
        if (asked.changed > round)
            changed.images.insert(source);
    return changed;
}

QSizeF Sizes::ask(document::SubdocumentId id) const {
    return objects_.subdocumentSize ? objects_.subdocumentSize(id) : QSizeF(0, 0);
}

QSize Sizes::ask(const std::string& source) const {
    return objects_.imageSize ? objects_.imageSize(source) : QSize();
}

QSizeF Sizes::subdocument(document::SubdocumentId id) {
    const auto [known, isNew] = subdocuments_.try_emplace(id);
    if (isNew)
        known->second.size = ask(id);
    return known->second.size;
}

QSize Sizes::image(const std::string& source) {
    const auto [known, isNew] = images_.try_emplace(source);
    if (isNew)
        known->second.size = ask(source);
    return known->second.size;
}

QSizeF Sizes::picture(const model::Picture& picture) {
    constexpr QSizeF unknown(320, 120);
    const QSize pixels = image(picture.source);
    QSizeF size = pixels.isEmpty() ? unknown : QSizeF(pixels);
    const auto &width = picture.width, &height = picture.height;
    if (width)
        size.scale(*width, height ? *height : size.height() * *width,
                   height ? Qt::IgnoreAspectRatio : Qt::KeepAspectRatio);
    else if (height)
        size.scale(size.width() * *height, *height, Qt::KeepAspectRatio);
    return fromPixels(size);
}

QSizeF fitted(QSizeF size, double width, double height) {
    return size * std::min({1.0, width / size.width(), height / size.height()});
}

} // namespace paragraphs
