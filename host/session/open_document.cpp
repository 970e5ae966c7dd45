#include "session/open_document.h"

#include <QFileInfo>
#include <algorithm>

namespace session {

namespace {

sgml::Edits toSgml(const std::vector<ipc::TextEdit>& edits) {
    sgml::Edits result;
    for (const ipc::TextEdit& edit : edits)
        result.push_back(
            {{static_cast<std::size_t>(edit.from), static_cast<std::size_t>(edit.to)}, edit.text});
    return result;
}

std::vector<ipc::TextEdit> toIpc(const sgml::Edits& edits) {
    std::vector<ipc::TextEdit> result;
    for (const sgml::Edit& edit : edits)
        result.push_back({static_cast<ipc::Integer>(edit.range.from),
                          static_cast<ipc::Integer>(edit.range.to), edit.text});
    return result;
}

ListedFault listed(const sgml::Fault& fault) {
    return {fault.position, fault.severity == sgml::Severity::error,
            QString::fromStdString(fault.message), document::noSubdocument};
}

} // namespace

OpenDocument::OpenDocument(std::unique_ptr<document::Document> document,
                           const document::Schemas& schemas, media::LiveMedia& media)
    : document_(std::move(document)), schemas_(schemas), media_(media) {
    readSubdocuments();
    document::Document* watched = document_.get();
    connect(watched, &document::Document::textChanged, this,
            [this](document::SubdocumentId id, const sgml::Edits& edits, int,
                   const QString& label) { textChanged(id, edits, label); });
    connect(watched, &document::Document::subdocumentsChanged, this, [this] {
        onlyText_ = false;
        readSubdocuments();
    });
    connect(watched, &document::Document::changed, this, &OpenDocument::documentChanged);
    connect(watched, &document::Document::fileNameChanged, this, &OpenDocument::nameSubdocuments);
}

OpenDocument::~OpenDocument() = default;

Unsaved& OpenDocument::keepUnsavedIn(const std::string& folder) {
    unsaved_ = std::make_unique<Unsaved>(*this, folder);
    return *unsaved_;
}

void OpenDocument::readSubdocuments() {
    const std::vector<document::SubdocumentId> there = document_->subdocuments();
    std::erase_if(live_, [&](const auto& one) {
        return std::find(there.begin(), there.end(), one.first) == there.end();
    });
    for (const document::SubdocumentId id : there) {
        const document::Subdocument* subdocument = document_->subdocument(id);
        if (!subdocument || !subdocument->hasText || live_.contains(id))
            continue;
        const QString className = QString::fromStdString(subdocument->className);
        std::unique_ptr<media::LiveSubdocument> made = media_.create(className);
        if (!made || made->manifest().storage.toStdString() != subdocument->storage)
            continue;
        made->setText(QByteArray::fromStdString(document_->text(id)));
        made->setPoster(subdocument->poster);
        made->onChange(
            [this, id](const ipc::SubdocumentChanged& change) { return applyChange(id, change); });
        connect(made.get(), &media::LiveSubdocument::diagnosticsChanged, this,
                &OpenDocument::faultsChanged);
        connect(made.get(), &media::LiveSubdocument::windowsChanged, this,
                &OpenDocument::draftsChanged);
        connect(made.get(), &media::LiveSubdocument::keptStateChanged, this,
                &OpenDocument::draftsChanged);
        connect(made.get(), &media::LiveSubdocument::message, this, &OpenDocument::message);
        connect(made.get(), &media::LiveSubdocument::undoRequested, document_.get(),
                &document::Document::undo);
        connect(made.get(), &media::LiveSubdocument::redoRequested, document_.get(),
                &document::Document::redo);
        live_[id] = std::move(made);
    }
    nameSubdocuments();
}

// The file, and which of several it is: by the author's name for it, else counted.
void OpenDocument::nameSubdocuments() {
    const QString file = document_->fileName().isEmpty()
                             ? tr("untitled")
                             : QFileInfo(document_->fileName()).fileName();
    int number = 0;
    for (const document::SubdocumentId id : document_->subdocuments()) {
        const auto found = live_.find(id);
        if (found == live_.end())
            continue;
        ++number;
        const document::Subdocument* subdocument = document_->subdocument(id);
        if (!subdocument->name.empty())
            found->second->setTitle(
                tr("%1, %2").arg(file, QString::fromStdString(subdocument->name)));
        else if (live_.size() > 1)
            found->second->setTitle(tr("%1, figure %2").arg(file).arg(number));
        else
            found->second->setTitle(file);
    }
}

QStringList OpenDocument::drafts() const {
    QStringList names;
    for (const auto& [id, subdocument] : live_)
        if (subdocument->windows().drafts && !names.contains(subdocument->name()))
            names << subdocument->name();
    return names;
}

bool OpenDocument::takesDrafts() const {
    return std::ranges::all_of(live_, [](const auto& one) {
        return !one.second->windows().drafts || one.second->takesDrafts();
    });
}

void OpenDocument::takeDrafts() {
    for (const auto& [id, subdocument] : live_)
        if (subdocument->windows().drafts)
            subdocument->takeDrafts();
}

media::LiveSubdocument* OpenDocument::live(document::SubdocumentId id) const {
    const auto found = live_.find(id);
    return found == live_.end() ? nullptr : found->second.get();
}

QString OpenDocument::whyNotLive(document::SubdocumentId id) const {
    const document::Subdocument* subdocument = document_->subdocument(id);
    if (!subdocument || subdocument->className.empty())
        return tr("This subdocument cannot be read.");
    const QString name = QString::fromStdString(subdocument->className);
    const media::Manifest* manifest = media_.registry().forClass(name);
    if (!manifest)
        return tr("No medium for %1 is installed.").arg(name);
    return tr("%1 finds no text in this subdocument: it looks for <%2>{...}</%2>.")
        .arg(manifest->name, manifest->storage);
}

QSizeF OpenDocument::sizeOf(document::SubdocumentId id) const {
    const document::Subdocument* subdocument = document_->subdocument(id);
    const media::LiveSubdocument* of = live(id);
    QSizeF size = of && of->preferredSize() ? *of->preferredSize() : QSizeF(480, 320);
    if (subdocument && subdocument->width) {
        size *= *subdocument->width / size.width();
        if (subdocument->height)
            size.setHeight(*subdocument->height);
    } else if (subdocument && subdocument->height) {
        size *= *subdocument->height / size.height();
    }
    return size.expandedTo({1, 1}).boundedTo({20'000, 20'000});
}

void OpenDocument::textChanged(document::SubdocumentId id, const sgml::Edits& edits,
                               const QString& label) {
    onlyText_ = true;
    if (media::LiveSubdocument* subdocument = live(id))
        subdocument->edit(toIpc(edits), label);
}

void OpenDocument::documentChanged() {
    if (!std::exchange(onlyText_, false))
        Q_EMIT structureChanged();
    Q_EMIT faultsChanged();
}

std::optional<QString> OpenDocument::applyChange(document::SubdocumentId id,
                                                 const ipc::SubdocumentChanged& change) {
    const document::Subdocument* subdocument = document_->subdocument(id);
    if (!subdocument)
        return tr("The subdocument is no longer there.");
    const QString group = change.group.empty()
                              ? QString()
                              : QStringLiteral("%1/%2").arg(id).arg(change.group.c_str());
    switch (document_->editText(id, subdocument->revision, toSgml(change.edits),
                                QString::fromStdString(change.label), group)) {
    case document::EditResult::applied:
    case document::EditResult::nothing:
        return std::nullopt;
    case document::EditResult::stale:
        return tr("The text has changed meanwhile.");
    case document::EditResult::invalid:
    case document::EditResult::unknown:
        break;
    }
    return tr("The document cannot make this change.");
}

std::vector<ListedFault> OpenDocument::faultsOf(document::SubdocumentId id) const {
    std::vector<ListedFault> result;
    const media::LiveSubdocument* subdocument = live(id);
    if (!subdocument)
        return result;
    for (const ipc::DiagnosticItem& item : subdocument->diagnostics().items) {
        constexpr ipc::Integer most = 1'000'000'000;
        const sgml::Position inText{static_cast<int>(std::min(item.line, most)),
                                    static_cast<int>(std::min(item.column, most))};
        const document::Subdocument* in = document_->subdocument(id);
        sgml::Position place =
            in ? document_->tree().position(document_->tree().node(in->element).range.from)
               : sgml::Position{};
        if (inText.line > 0)
            place = document_->filePosition(id, inText);
        result.push_back({place, item.severity == ipc::Severity::error,
                          QString::fromStdString(item.message), id});
    }
    return result;
}

std::vector<ListedFault> OpenDocument::faults() const {
    std::vector<ListedFault> result;
    for (const sgml::Fault& fault : document_->faults())
        result.push_back(listed(fault));
    QStringList classes;
    for (const media::Manifest& manifest : media_.registry().media())
        classes << manifest.documentClass;
    for (const sgml::Fault& fault : document::structureFaults(*document_, schemas_, classes))
        result.push_back(listed(fault));
    for (const auto& [id, subdocument] : live_) {
        const std::vector<ListedFault> ofIt = faultsOf(id);
        result.insert(result.end(), ofIt.begin(), ofIt.end());
    }
    std::stable_sort(result.begin(), result.end(), [](const ListedFault& a, const ListedFault& b) {
        return a.position < b.position;
    });
    return result;
}

} // namespace session
