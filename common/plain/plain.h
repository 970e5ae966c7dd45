// Texts on widgets, shown as they are written: never as HTML, whose pictures Qt would read from any
// file, nor with marks for keys.
#pragma once

#include <QLabel>
#include <QMessageBox>

namespace plain {

// A label that shows any text as it is.
[[nodiscard]] QLabel* label(const QString& text = {}, QWidget* parent = nullptr);

// A label of our own markup. The caller escapes texts of others (toHtmlEscaped()).
[[nodiscard]] QLabel* markupLabel(QWidget* parent = nullptr);

// For setToolTip(), setWhatsThis() and QToolTip::showText().
[[nodiscard]] QString tip(const QString& text);

// For what takes "&" for the mark of a key: actions, menus, buttons, boxes, docks. In one line: the
// rest behind a tab would be taken for the keys of a menu's entry.
[[nodiscard]] QString caption(const QString& text);

// For setWindowTitle(), which takes "[*]" for the place of the mark of changes.
[[nodiscard]] QString title(const QString& text);

// Words of our own, with a mark for a key perhaps, that come from a table or a parameter: as they
// are. Says to tests/layering/check_texts.py that nobody else wrote them.
[[nodiscard]] inline QString ours(const QString& words) { return words; }

// A message in a window of its own, and a question.
class Message : public QMessageBox {
public:
    Message(Icon icon, const QString& title, const QString& text, StandardButtons buttons,
            QWidget* parent);
    // Below the text, in smaller letters.
    void setSecondText(const QString& text);
    // Markup of our own, in place of the text.
    void setMarkup(const QString& markup);

    static void tell(Icon icon, QWidget* parent, const QString& title, const QString& text);
    [[nodiscard]] static StandardButton ask(Icon icon, QWidget* parent, const QString& title,
                                            const QString& text, StandardButtons buttons,
                                            StandardButton byDefault = NoButton);

private:
    void giveKeys();
};

} // namespace plain
