// Unsaved text of an open document outlives this program: each change goes to the user's
// journal, with the text typed in windows of media, and the next start after the program was
// killed offers it. A save, an undo to the saved text, or giving up removes it from the
// journal. The text is taken a few times a second while one types, not at each key.
#pragma once

#include "files/journal_writer.h"

#include <QObject>
#include <QTimer>

namespace session {

class OpenDocument;

class Unsaved : public QObject {
    Q_OBJECT

public:
    static constexpr int soonMs = 100; // after the first change that is not taken yet

    Unsaved(OpenDocument& document, const std::string& folder); // which outlives it
    // Text that is neither saved nor given up stays in the journal.
    ~Unsaved() override;

    // The content of `left` is this document's, which gets that text as one change; its media open
    // the windows again that had drafts.
    void adopt(files::LeftBehind left);
    void giveUp(); // closed by choice
    void finish(); // returns when all of it is on the disk

    // How often the text was taken.
    [[nodiscard]] int taken() const { return taken_; }

Q_SIGNALS:
    void failed(const QString& sentence); // changes cannot be kept; once, until they can

private:
    // By the subdocument's place among all, from "0" on.
    using Drafts = std::map<std::string, std::string>;

    void changed();
    void take();
    void takeIfChanged();
    [[nodiscard]] Drafts drafts(bool& any) const;

    OpenDocument& document_;
    Drafts recovered_; // drafts that its media were given, and perhaps have not opened yet
    files::JournalWriter writer_;
    QTimer soon_;
    int taken_ = 0;
};

} // namespace session
