// The target of a document's link, in a form that a reader can trust.
#pragma once

#include <QUrl>
#include <optional>

namespace window {

struct Link {
    QUrl url;
    // Scheme and host as the browser will understand them, such as "https://example.org"; a host
    // with letters beyond ASCII as punycode, since some look like others. For mail, the address.
    QString place;
};

// None for what is no address of the web or of mail, or leads nowhere.
[[nodiscard]] std::optional<Link> linkTo(const QString& target);

} // namespace window
