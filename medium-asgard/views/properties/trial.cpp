#include "properties/trial.h"

#include <algorithm>
#include <utility>

namespace views {

Trial::Trial(SceneDocument& document, QObject* parent) : QObject(parent), document_(document) {
    connect(&document_, &SceneDocument::diagnosticsChanged, this, [this] { look(true); });
    connect(&document_, &SceneDocument::sceneChanged, this, [this] { look(false); });
    connect(&document_, &SceneDocument::opened, this, [this] { told_ = nullptr; });
}

// A window that is destroyed with its trial would hear of the text while half of it is gone.
Trial::~Trial() {
    if (told_)
        QMetaObject::invokeMethod(
            &document_,
            [&document = document_, before = before_, label = label_, since = since_,
             hand = hand_] { document.finishPreview(before, label, since, hand.get()); },
            Qt::QueuedConnection);
}

void Trial::start(const std::string& text, const QString& label, Told told) {
    if (told_)
        end(before_, overtaken());
    before_ = document_.text();
    text_ = text;
    label_ = label;
    since_ = document_.revision();
    if (text == before_)
        return told({});
    told_ = std::move(told);
    hand_ = std::make_shared<const char>();
    document_.preview(text, since_, hand_.get(), Unfinished::none);
    if (told_ && document_.text() != text) // a host that takes no previews
        end(text, {});
}

void Trial::look(bool isRead) {
    if (!told_)
        return;
    if (!document_.mayGoOn(since_) || document_.text() != text_)
        return end(document_.text(), overtaken());
    if (document_.sceneIsCurrent())
        return end(text_, {});
    if (!isRead || !document_.hasErrors())
        return;
    const auto fault = std::ranges::find(document_.diagnostics(), scene::Severity::error,
                                         &scene::Diagnostic::severity);
    const QString hint = QString::fromStdString(fault->suggestion);
    end(before_, QString::fromStdString(fault->message) +
                     (hint.isEmpty() ? QString() : QStringLiteral(" – ") + hint));
}

void Trial::end(const std::string& text, const QString& why) {
    const Told told = std::exchange(told_, nullptr);
    if (text == text_ || text == before_)
        document_.finishPreview(text, label_, since_, hand_.get());
    told(why);
}

QString Trial::overtaken() {
    return tr("The text was changed meanwhile. Return tries the value again.");
}

} // namespace views
