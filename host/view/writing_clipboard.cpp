// The clipboard of a view that is written, and what is dropped on it.
#include "view/writing.h"

#include "authoring/images.h"
#include "clipboard/copying.h"
#include "clipboard/pasted_html.h"
#include "clipboard/pictures_in.h"
#include "view/document_view.h"

#include <QMimeData>
#include <QUuid>

namespace view {

void Writing::cut() {
    if (view_.chosen()) {
        figure_.copy();
        figure_.erase();
    } else if (hand_.copy()) {
        cutAway();
    }
}

void Writing::cutAway() {
    perform([](const authoring::Manuscript& in, authoring::Selection at) {
        return authoring::erase(in, at, authoring::Direction::forward);
    });
}

bool Writing::paste(const QMimeData& data) { return paste(data, {}); }

// Our own bytes keep the structure, and HTML most of it; where that may not stand, the text comes
// alone.
bool Writing::paste(const QMimeData& data, const QString& group) {
    // Each picture in a figure, where the class has figures; all are one step.
    if (holdsPictures(data)) {
        const Pictures pictures =
            taken(data, session::PictureHome(view_.document().document().fileName()));
        const QString step = group.isEmpty() ? QUuid::createUuid().toString() : group;
        bool done = false;
        for (const std::string& source : pictures.sources) {
            const auto put = [&](const authoring::Manuscript& in, authoring::Selection at) {
                return authoring::insertImage(in, at, {.file = source});
            };
            done = perform(put, step) || done;
        }
        if (!pictures.fault.isEmpty())
            Q_EMIT refused(pictures.fault);
        return done;
    }
    std::string fragment = data.data(fragmentFormat).toStdString();
    const std::string text = data.text().toStdString();
    const authoring::Grammar* grammar = grammars_.of(view_.document().document().className());
    if (fragment.empty() && data.hasHtml() && grammar)
        fragment = fragmentOf(data.html(), *grammar);
    if (fragment.empty() && text.empty()) {
        Q_EMIT refused(tr("The clipboard holds no text."));
        return false;
    }
    return perform(
        [&](const authoring::Manuscript& in, authoring::Selection at) {
            if (fragment.empty())
                return authoring::pasteText(in, at, text);
            authoring::Result result = authoring::paste(in, at, fragment);
            const bool isRefused = std::holds_alternative<authoring::Refusal>(result);
            return isRefused && !text.empty() ? authoring::pasteText(in, at, text) : result;
        },
        group);
}

// Moved text goes first, so that it keeps its IDs; it is back where nothing of it may come in.
void Writing::drop(const QMimeData& data, QPointF at, std::optional<text::Range> moved) {
    const std::optional<places::Caret> caret = hand_.caretAt(at);
    if (!caret)
        return;
    const std::optional<document::Selection> before = hand_.cursor().selection();
    view_.choose(document::noSubdocument);
    hand_.moveTo(*caret);
    if (!moved) {
        (void)paste(data);
        return;
    }
    document::Document& document = view_.document().document();
    document::Tracker tracker(document);
    const std::size_t place = hand_.cursor().selection()->caret;
    const auto target = tracker.track(place, text::Gravity::behind);
    hand_.cursor().set(*before);
    if (moved->from <= place && place <= moved->to)
        return; // dropped on itself
    const QString group = QUuid::createUuid().toString();
    const bool isTaken = perform(
        [](const authoring::Manuscript& in, authoring::Selection all) {
            return authoring::erase(in, all, authoring::Direction::forward);
        },
        group);
    if (!isTaken)
        return;
    hand_.cursor().set({target->offset, target->offset});
    if (!paste(data, group))
        document.undo();
}

} // namespace view
