#include "source/letters.h"

#include <QTextCursor>

namespace source {

QString lettersOf(QTextDocument& text, int from, int to) {
    QTextCursor cursor(&text);
    cursor.setPosition(from);
    cursor.setPosition(to, QTextCursor::KeepAnchor);
    return cursor.selectedText().replace(QChar::ParagraphSeparator, QLatin1Char('\n'));
}

QString lettersOf(QTextDocument& text) { return lettersOf(text, 0, text.characterCount() - 1); }

} // namespace source
