// The text of a subdocument, as its document has it, and the messages that keep its medium in step.
//
// Each change makes a revision. A change that the medium asks for must be of the newest one; the
// document makes it, or refuses it.
#pragma once

#include "ipc/messages.h"

#include <QByteArray>
#include <QString>
#include <functional>
#include <optional>
#include <variant>

namespace media {

// An edit that the medium asks for: {} when it was applied, else why not.
using ChangeHandler = std::function<std::optional<QString>(const ipc::SubdocumentChanged& change)>;

class SubdocumentText {
public:
    [[nodiscard]] const QByteArray& bytes() const { return bytes_; }
    void set(const QByteArray& bytes);
    // The message that tells it. None: more than one message tells, so that it is loaded anew.
    [[nodiscard]] std::optional<ipc::SubdocumentEdit> edit(const text::Edits& edits,
                                                           const QString& label);
    void setTitle(const QString& title) { title_ = title; } // for the medium's own windows
    [[nodiscard]] ipc::SubdocumentLoad load() const;

    // No message holds it: no medium can be sent it.
    [[nodiscard]] bool isTooLong() const;
    [[nodiscard]] QString whyTooLong(const QString& medium) const;

    // --- the medium asks
    void onChange(ChangeHandler handler) { handler_ = std::move(handler); }
    // The document makes it by edit(); meanwhile isChangedByMedium().
    [[nodiscard]] std::variant<ipc::Revised, ipc::Error>
    change(const ipc::SubdocumentChanged& change);
    [[nodiscard]] bool isChangedByMedium() const { return changedByMedium_; }

private:
    [[nodiscard]] std::optional<ipc::Error> fault(const ipc::SubdocumentChanged& change) const;

    QByteArray bytes_;
    QString title_;
    ipc::Integer revision_ = 1;
    ChangeHandler handler_;
    bool changedByMedium_ = false;
};

} // namespace media
