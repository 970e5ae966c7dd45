#include "offers/edit_preview.h"

#include "element_edits/preview.h"

namespace views {

namespace {

QString escaped(const std::string& s) { return QString::fromStdString(s).toHtmlEscaped(); }

QString marked(const std::string& s, std::size_t from, std::size_t to) {
    return escaped(s.substr(0, from)) + "<b>" + escaped(s.substr(from, to - from)) + "</b>" +
           escaped(s.substr(to));
}

} // namespace

QString previewOf(const std::string& text, const text::Edits& edits) {
    QString shown;
    for (const editing::LineChange& line : editing::changedLines(text, edits))
        shown +=
            QStringLiteral("<div><span style='color:#888'>%1&nbsp; </span>"
                           "<code style='color:#a05048'>%2</code></div><div><code>%3</code></div>")
                .arg(line.line)
                .arg(marked(line.before, line.from, line.beforeTo),
                     marked(line.after, line.from, line.afterTo));
    return shown;
}

} // namespace views
