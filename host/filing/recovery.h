// The question about a text that was not saved before a program ended.
#pragma once

#include "files/journal.h"

#include <QDateTime>
#include <QString>

class QWidget;

namespace filing {

enum class Answer { open, discard, later };

// "memo.ens was not saved before Ensemble stopped at 14:03. Open the recovered text?" Without a
// file the title, which may be empty, stands for its name.
[[nodiscard]] QString questionAbout(const files::Kept& kept, const QString& title,
                                    const QDateTime& now);
// Advice for the answer: whether the file is another by now.
[[nodiscard]] QString adviceAbout(const files::Kept& kept);
[[nodiscard]] Answer askAbout(QWidget* over, const files::Kept& kept, const QString& title);

// Says it and goes on: nothing waits until it is read.
void tell(QWidget* over, const QString& sentence);

} // namespace filing
