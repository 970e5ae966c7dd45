// The templates of new documents: those of the program, and the user's own, which are documents in
// a folder.
#pragma once

#include <QString>

#include <string>
#include <vector>

namespace filing {

struct Template {
    QString name; // as the menu says it, and of the file
    QString file; // of the disk, or of the program

    struct Read {
        std::string bytes;
        QString failure{}; // "": none
    };
    // One of the program says the language then, as documents do; "": none.
    [[nodiscard]] Read readIn(const QString& language) const;
    [[nodiscard]] Read read() const; // in the desktop's
};

// $XDG_DATA_HOME/ensemble/templates
[[nodiscard]] QString templateFolder();
// The program's own first, the memo before all; a user's of the same name takes the place of one.
[[nodiscard]] std::vector<Template> templates();

} // namespace filing
