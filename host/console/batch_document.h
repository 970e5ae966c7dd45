// A document and its media for a command that ends: confined media in batch mode, no windows.
#pragma once

#include "session/open_document.h"

#include <QEventLoop>

namespace console {

class BatchDocument {
public:
    // Null document when it cannot be read; then failure() says why.
    explicit BatchDocument(const QString& input);

    [[nodiscard]] bool isOpen() const { return document_ != nullptr; }
    [[nodiscard]] const QString& failure() const { return failure_; }
    [[nodiscard]] session::OpenDocument& document() { return *document_; }
    [[nodiscard]] media::LiveMedia& media() { return media_; }
    [[nodiscard]] const schemas::Schemas& schemas() const { return schemas_; }
    // Waits until its media have told the values that stand in its text, or have said why not.
    void settleValues();

private:
    schemas::Schemas schemas_;
    media::PipeThread pipes_;
    media::LiveMedia media_;
    QString failure_;
    std::unique_ptr<session::OpenDocument> document_;
};

// "file:line:column: error: text" on standard error.
void complain(const QString& text);

} // namespace console
