// Help about one thing: a short page, with the manual behind it; and what the program is.
#pragma once

#include <QString>

#include <optional>

class QWidget;

namespace views {

// Gives a widget, with everything in it, its page: a heading of docs/help.md.
void setHelp(QWidget& widget, const QString& topic);
// Of the widget, or of the nearest one around it that has one; "" where there is none.
[[nodiscard]] QString helpOf(const QWidget* widget);

struct HelpPage {
    QString words;   // Markdown
    QString chapter; // of the manual
    bool operator==(const HelpPage&) const = default;
};
[[nodiscard]] std::optional<HelpPage> helpPage(const QString& topic);

// In a small window beside the pointer; one at a time. Without a page it is the manual.
void showHelp(const QString& topic);

void showAbout(QWidget* over);

} // namespace views
