#include "script/locate.h"

namespace script {

void locate(const text::Places& places, scene::Diagnostic& diagnostic) {
    if (!diagnostic.range.known())
        return;
    const text::Position from = places.at(diagnostic.range.from);
    const text::Position to = places.at(diagnostic.range.to);
    diagnostic.line = from.line;
    diagnostic.column = from.column;
    diagnostic.endLine = to.line;
    diagnostic.endColumn = to.column;
}

} // namespace script
