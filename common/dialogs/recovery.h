// The question about a text that was not saved before a program ended.
#pragma once

#include "files/journal.h"

#include <QDateTime>
#include <QString>

class QWidget;

namespace dialogs {

struct Asking {
    QString program; // that ended: "Ensemble"
    QString unnamed; // what a text without a file is called: "A document without a name"
    QString drafts;  // the sentence about windows in which somebody was typing
};

enum class Recovery { recover, discard, later };

// "memo.ens was not saved before Ensemble stopped at 14:03. Recover it?"
[[nodiscard]] QString questionAbout(const files::Kept& kept, const Asking& asking,
                                    const QDateTime& now);
// Whether the file is another by now, and the sentence about drafts where there are some.
[[nodiscard]] QString adviceAbout(const files::Kept& kept, const Asking& asking);

// Return and Escape leave the text where it is: they may have been meant for another window.
[[nodiscard]] Recovery askAbout(QWidget* over, const files::Kept& kept, const Asking& asking);

} // namespace dialogs
