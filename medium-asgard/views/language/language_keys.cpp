#include "language/language_keys.h"

#include <QObject>

namespace views {

QString languageKeys() {
    const auto row = [](const QString& keys, const QString& what) {
        return QStringLiteral("<tr><td style=\"padding:2px 16px 2px 0; white-space:nowrap\">"
                              "<b>%1</b></td><td style=\"padding:2px 0\">%2</td></tr>")
            .arg(keys, what);
    };
    const auto tr = [](const char* text) { return QObject::tr(text); };
    return QStringLiteral("<table width=\"620\">") +
           row(tr("Ctrl+Return"), tr("Update: the draft becomes the scene's text, in every view")) +
           row(tr("Ctrl+S"), tr("Update, and write the file")) +
           row(tr("Ctrl+Shift+R"), tr("Revert: back to the text that was saved last")) +
           row(tr("Ctrl+Z, Ctrl+Shift+Z"), tr("take back what was typed; without a draft, the "
                                              "scene's last change, and bring it again")) +
           row(tr("Ctrl+Space"), tr("what can be written here: commands, options, names")) +
           row(tr("F8, Shift+F8"), tr("the next message's place, the one before")) +
           row(tr("Ctrl+F, Ctrl+H"), tr("find, replace; F3 and Shift+F3 go on")) +
           row(tr("Alt+Up, Alt+Down"), tr("increase or decrease the number at the caret; with "
                                          "Shift by ten times as much")) +
           row(tr("Alt and drag"),
               tr("the same with the pointer, as the grip below a number; Escape brings it back")) +
           row(tr("Ctrl+E, right button"), tr("show or hide a long list of points")) +
           row(tr("Ctrl+Shift+E"), tr("hide all long lists of points")) +
           row(tr("F7, Ctrl+Shift+M, Ctrl+Shift+T"),
               tr("the next place that was changed here and elsewhere; keep mine; take the "
                  "scene's")) +
           row(tr("Ctrl+G"), tr("go to a line")) +
           row(tr("Ctrl+Plus, Ctrl+Minus, Ctrl+0"), tr("larger, smaller, as it was")) +
           row(tr("Ctrl+L, Ctrl+N"), tr("another language viewer, another graphical one")) +
           row(tr("Escape"), tr("close the list or the find bar; select nothing")) +
           row(tr("Ctrl+W"), tr("Dismiss: close this viewer")) + QStringLiteral("</table>");
}

} // namespace views
