#include "media/subdocument_text.h"

#include "ipc/bounds.h"
#include "text/edit.h"

namespace media {

void SubdocumentText::set(const QByteArray& bytes) {
    bytes_ = bytes;
    ++revision_;
}

std::optional<ipc::SubdocumentEdit> SubdocumentText::edit(const text::Edits& edits,
                                                          const QString& label) {
    const std::string_view before(bytes_.constData(), static_cast<std::size_t>(bytes_.size()));
    bytes_ = QByteArray::fromStdString(text::applied(before, edits));
    ++revision_;
    std::size_t typed = 0;
    for (const text::Edit& edit : edits)
        typed += edit.text.size();
    if (edits.size() > ipc::mostEdits.most || typed > ipc::longestText.most)
        return std::nullopt;
    return ipc::SubdocumentEdit{revision_, edits, label.toStdString()};
}

ipc::SubdocumentLoad SubdocumentText::load() const {
    return {bytes_.toStdString(), revision_, title_.toStdString()};
}

bool SubdocumentText::isTooLong() const {
    return static_cast<std::size_t>(bytes_.size()) > ipc::longestText.most;
}

QString SubdocumentText::whyTooLong(const QString& medium) const {
    return QStringLiteral("%1 is not started: this text has %2 MiB, and it may "
                          "have %3 MiB at "
                          "most. Make it shorter.")
        .arg(medium)
        .arg(static_cast<double>(bytes_.size()) / (1 << 20), 0, 'f', 1)
        .arg(ipc::longestText.most >> 20);
}

// Before the document is asked.
std::optional<ipc::Error> SubdocumentText::fault(const ipc::SubdocumentChanged& change) const {
    if (change.base != revision_)
        return ipc::Error{ipc::ErrorCode::staleBase,
                          "the text is at revision " + std::to_string(revision_)};
    auto length = static_cast<std::size_t>(bytes_.size());
    if (!text::areOrdered(change.edits, length))
        return ipc::Error{ipc::ErrorCode::invalidParameters,
                          "the edits must ascend, not overlap and lie in the text"};
    for (const text::Edit& edit : change.edits)
        length = length - edit.range.size() + edit.text.size();
    if (length > ipc::longestText.most)
        return ipc::Error{ipc::ErrorCode::notPossible, "the text would be too long"};
    return std::nullopt;
}

std::variant<ipc::Revised, ipc::Error>
SubdocumentText::change(const ipc::SubdocumentChanged& change) {
    if (auto wrong = fault(change))
        return *std::move(wrong);
    changedByMedium_ = true;
    const std::optional<QString> refused =
        handler_ ? handler_(change) : QStringLiteral("the document cannot be edited");
    changedByMedium_ = false;
    if (refused)
        return ipc::Error{ipc::ErrorCode::notPossible, refused->toStdString()};
    return ipc::Revised{revision_};
}

} // namespace media
