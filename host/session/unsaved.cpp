#include "session/unsaved.h"

#include "session/open_document.h"

namespace session {

Unsaved::Unsaved(OpenDocument& document, const std::string& folder)
    : document_(document),
      writer_(files::FileSystem::real(), folder, [this](const std::string& sentence) {
          Q_EMIT failed(QString::fromStdString(sentence)); // queued: the receiver has its thread
      }) {
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &Unsaved::take);
    const document::Document* watched = &document.document();
    connect(watched, &document::Document::changed, this, &Unsaved::changed);
    connect(watched, &document::Document::modifiedChanged, this, &Unsaved::take);
    connect(watched, &document::Document::fileNameChanged, this, &Unsaved::take);
    connect(&document, &OpenDocument::draftsChanged, this, &Unsaved::changed);
}

Unsaved::~Unsaved() { takeIfChanged(); }

// The state that a medium keeps of its windows, drafts among it or none. A medium that is not
// installed any more, or has not opened its windows yet, has still what was left behind.
Unsaved::Drafts Unsaved::drafts(bool& any) const {
    Drafts result;
    int place = 0;
    for (const document::SubdocumentId id : document_.document().subdocuments()) {
        const std::string key = std::to_string(place++);
        const media::LiveSubdocument* live = document_.live(id);
        const auto left = recovered_.find(key);
        const bool isLeft =
            left != recovered_.end() && (!live || live->keptState() == left->second);
        if (isLeft || (live && !live->keptState().empty()))
            result[key] = isLeft ? left->second : live->keptState();
        any = any || isLeft || (live && live->windows().drafts && !live->keptState().empty());
    }
    return result;
}

void Unsaved::changed() {
    if (!soon_.isActive())
        soon_.start(soonMs);
}

void Unsaved::takeIfChanged() {
    if (soon_.isActive())
        take();
}

void Unsaved::finish() {
    takeIfChanged();
    writer_.finish();
}

void Unsaved::take() {
    soon_.stop();
    ++taken_;
    const document::Document& of = document_.document();
    bool any = of.isModified();
    Drafts typed = drafts(any);
    if (any)
        writer_.keep({.file = of.knownFile(), .text = of.bytes(), .drafts = std::move(typed)});
    else
        writer_.forget();
}

void Unsaved::adopt(files::LeftBehind left) {
    writer_.adopt(std::move(left.place)); // before the text changes: else it is kept twice
    document_.document().recoverText(left.kept.file, left.kept.text);
    recovered_ = std::move(left.kept.drafts);
    int place = 0;
    for (const document::SubdocumentId id : document_.document().subdocuments()) {
        const auto state = recovered_.find(std::to_string(place++));
        media::LiveSubdocument* live = document_.live(id);
        if (!live || state == recovered_.end())
            continue;
        live->makeStill(); // the next process opens them
        live->setKeptState(state->second);
        live->start();
    }
    take();
}

void Unsaved::giveUp() {
    disconnect(&document_, nullptr, this, nullptr);
    disconnect(&document_.document(), nullptr, this, nullptr);
    soon_.stop();
    writer_.forget();
}

} // namespace session
