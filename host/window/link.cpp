#include "window/link.h"

namespace window {

namespace {

constexpr qsizetype longest = 120; // characters of a mail address that are shown

} // namespace

std::optional<Link> linkTo(const QString& target) {
    const QUrl url(target);
    if (!url.isValid())
        return std::nullopt;
    if (url.scheme() == "mailto") {
        const QString to = QUrl(url).adjusted(QUrl::RemoveQuery).path(QUrl::FullyEncoded);
        if (to.isEmpty())
            return std::nullopt;
        return Link{url, "mailto:" + (to.size() <= longest ? to : to.left(longest) + "…")};
    }
    if ((url.scheme() != "http" && url.scheme() != "https") || url.host().isEmpty())
        return std::nullopt;
    const QString port = url.port() < 0 ? QString() : ':' + QString::number(url.port());
    return Link{url, url.scheme() + "://" + url.host(QUrl::FullyEncoded) + port};
}

} // namespace window
