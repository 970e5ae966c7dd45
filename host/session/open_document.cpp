#include "session/open_document.h"

#include "session/picture_home.h"
#include "session/presented.h"

#include <QFileInfo>
#include <algorithm>
#include <numeric>

namespace session {

namespace {

ListedFault listed(const sgml::Fault& fault, document::SubdocumentId id = document::noSubdocument) {
    return {fault.position,
            fault.severity == sgml::Severity::error,
            QString::fromStdString(fault.message),
            id,
            {}};
}

sgml::Fault warningAt(text::Range range, std::string message) {
    sgml::Fault fault;
    fault.severity = sgml::Severity::warning;
    fault.range = range;
    fault.message = std::move(message);
    return fault;
}

bool isBefore(const sgml::Fault& a, const sgml::Fault& b) { return a.range.from < b.range.from; }

// A sentence while a medium has failed.
QString failureOf(const media::LiveSubdocument& live) {
    return live.condition() == media::Condition::failed ? live.reason() : QString();
}

} // namespace

OpenDocument::OpenDocument(std::unique_ptr<document::Document> document,
                           const schemas::Schemas& schemas, media::LiveMedia& media)
    : document_(std::move(document)), schemas_(schemas), media_(media), uses_(*document_, schemas) {
    readSubdocuments();
    images_.setDocument(document_->fileName());
    connect(&images_, &Images::ready, this, [this] {
        if (images_.hasFaults())
            Q_EMIT faultsChanged();
    });
    document::Document* watched = document_.get();
    connect(watched, &document::Document::edited, this, [this](const sgml::Change& change) {
        uses_.follow(change);
        if (judged_)
            judged_->follow(change);
    });
    connect(watched, &document::Document::textChanged, this,
            [this](document::SubdocumentId id, const text::Edits& edits, int,
                   const QString& label) { textChanged(id, edits, label); });
    connect(watched, &document::Document::subdocumentsChanged, this, [this] {
        onlyText_ = false;
        readSubdocuments();
    });
    connect(watched, &document::Document::changed, this, &OpenDocument::documentChanged);
    // Saved elsewhere, the document takes its pictures with it.
    connect(watched, &document::Document::fileNameChanged, this,
            [this, from = PictureHome(document_->fileName()).folder()]() mutable {
                const PictureHome home(document_->fileName());
                std::vector<std::string> sources;
                for (const document::ImageUse& use : uses_.images())
                    sources.push_back(use.source);
                for (const QString& fault : home.bring(sources, std::exchange(from, home.folder())))
                    Q_EMIT message(fault);
            });
    connect(watched, &document::Document::fileNameChanged, this, [this] {
        images_.setDocument(document_->fileName());
        nameSubdocuments();
        Q_EMIT resized(); // of pictures
    });
    // Behind the connections above: a medium has a text before it is asked for its values.
    values_ = std::make_unique<Values>(*this, [this] { return placedValues(); });
    connect(values_.get(), &Values::faultsChanged, this, &OpenDocument::faultsChanged);
}

OpenDocument::~OpenDocument() = default;

FileFollower& OpenDocument::followFile() {
    if (!file_) {
        file_ = std::make_unique<FileFollower>(*document_);
        connect(file_.get(), &FileFollower::told, this, &OpenDocument::message);
    }
    return *file_;
}

Unsaved& OpenDocument::keepUnsavedIn(const std::string& folder) {
    unsaved_ = std::make_unique<Unsaved>(*this, folder);
    return *unsaved_;
}

void OpenDocument::presentAnew() {
    Q_EMIT presentedAnew();
    Q_EMIT faultsChanged(); // of the files
}

std::shared_ptr<Presented> OpenDocument::presented(const QString& presentation) {
    std::shared_ptr<Presented> known = presented_[presentation].lock();
    if (!known) {
        known = std::make_shared<Presented>(*this, presentation);
        presented_[presentation] = known;
    }
    return known;
}

void OpenDocument::readSubdocuments() {
    const std::vector<document::SubdocumentId> there = document_->subdocuments();
    std::erase_if(live_, [&](const auto& one) { return !document_->subdocument(one.first); });
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
        made->setPresentation(subdocument->presentation);
        made->onChange(
            [this, id](const ipc::SubdocumentChanged& change) { return applyChange(id, change); });
        connectLive(id, *made);
        live_[id] = std::move(made);
    }
    driven_.clear();
    for (const document::SliderUse& use : uses_.sliders())
        driven_.insert(use.subdocument);
    placed_.clear();
    nameSubdocuments();
}

void OpenDocument::connectLive(document::SubdocumentId id, media::LiveSubdocument& live) {
    using media::LiveSubdocument;
    const auto askForParameters = [this, id, &live] {
        if (hasSliders(id))
            live.askForParameters();
    };
    connect(&live, &LiveSubdocument::diagnosticsChanged, this, [this, id, askForParameters] {
        placed_.erase(id);
        askForParameters();
        Q_EMIT faultsChanged();
    });
    connect(&live, &LiveSubdocument::conditionChanged, this,
            [this, id, &live, last = failureOf(live)]() mutable {
                const QString before = std::exchange(last, failureOf(live));
                if (before == last)
                    return;
                placed_.erase(id);
                Q_EMIT faultsChanged();
            });
    connect(&live, &LiveSubdocument::loaded, this, askForParameters);
    connect(&live, &LiveSubdocument::parametersChanged, this, &OpenDocument::faultsChanged);
    connect(&live, &LiveSubdocument::presentationsChanged, this, &OpenDocument::faultsChanged);
    connect(&live, &LiveSubdocument::preferredSizeChanged, this, &OpenDocument::resized);
    connect(&live, &LiveSubdocument::windowsChanged, this, &OpenDocument::draftsChanged);
    connect(&live, &LiveSubdocument::keptStateChanged, this, &OpenDocument::draftsChanged);
    connect(&live, &LiveSubdocument::message, this,
            [this, id](const QString& text) { Q_EMIT figureSaid(id, text); });
    connect(&live, &LiveSubdocument::undoRequested, document_.get(), &document::Document::undo);
    connect(&live, &LiveSubdocument::redoRequested, document_.get(), &document::Document::redo);
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

QString OpenDocument::emptyNotice(document::SubdocumentId id) const {
    const media::Manifest* manifest =
        document_->isBlank(id) ? media_.registry().forClass(
                                     QString::fromStdString(document_->subdocument(id)->className))
                               : nullptr;
    return manifest ? tr("%1: still empty").arg(manifest->title) : QString();
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

void OpenDocument::textChanged(document::SubdocumentId id, const text::Edits& edits,
                               const QString& label) {
    onlyText_ = true;
    if (media::LiveSubdocument* subdocument = live(id))
        subdocument->edit(edits, label);
}

void OpenDocument::documentChanged() {
    placed_.clear();
    if (!std::exchange(onlyText_, false)) {
        for (const auto& [id, subdocument] : live_)
            subdocument->setPresentation(document_->subdocument(id)->presentation);
        Q_EMIT structureChanged();
    }
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
    switch (document_->editText(id, subdocument->revision, change.edits,
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

// --- faults ------------------------------------------------------------------------------------

// With their places as bytes: lines and columns are counted for all of them at once.
std::vector<sgml::Fault> OpenDocument::saidBy(document::SubdocumentId id) const {
    const media::LiveSubdocument* subdocument = live(id);
    const document::Subdocument* in = document_->subdocument(id);
    if (!subdocument || !in)
        return {};
    std::vector<text::Position> places;
    for (const ipc::DiagnosticItem& item : subdocument->diagnostics().items) {
        constexpr ipc::Integer most = 1'000'000'000;
        places.push_back({static_cast<int>(std::clamp(item.line, ipc::Integer{0}, most)),
                          static_cast<int>(std::clamp(item.column, ipc::Integer{0}, most))});
    }
    const std::vector<std::size_t> offsets = document_->fileOffsets(id, places);
    const std::size_t start = document_->tree().node(in->element).range.from;
    std::vector<sgml::Fault> result;
    if (const QString failure = failureOf(*subdocument); !failure.isEmpty()) {
        result.push_back(warningAt({start, start}, failure.toStdString()));
        result.back().severity = sgml::Severity::error;
    }
    for (std::size_t i = 0; i < places.size(); ++i) {
        const ipc::DiagnosticItem& item = subdocument->diagnostics().items[i];
        const std::size_t at = places[i].line > 0 ? offsets[i] : start;
        result.push_back(warningAt({at, at}, item.message));
        if (item.severity == ipc::Severity::error)
            result.back().severity = sgml::Severity::error;
    }
    return result;
}

const std::vector<ListedFault>& OpenDocument::faultsOf(document::SubdocumentId id) const {
    const auto [known, isNew] = placed_.try_emplace(id);
    if (isNew) {
        std::vector<sgml::Fault> said = saidBy(id);
        std::stable_sort(said.begin(), said.end(), isBefore);
        sgml::placeFaults(said, document_->tree());
        for (const sgml::Fault& fault : said)
            known->second.push_back(listed(fault, id));
    }
    return known->second;
}

std::vector<sgml::Fault> OpenDocument::ofDocument() {
    if (!judged_) {
        QStringList classes;
        for (const media::Manifest& manifest : media_.registry().media())
            classes << manifest.documentClass;
        judged_ = std::make_unique<document::Faults>(*document_, schemas_, classes);
    }
    return judged_->list();
}

std::vector<sgml::Fault> OpenDocument::ofImages() {
    std::map<std::string, std::string> known; // by source
    std::vector<sgml::Fault> result;
    for (const document::ImageUse& use : uses_.images()) {
        const auto [fault, isNew] = known.try_emplace(use.source);
        if (isNew)
            fault->second = images_.fault(use.source).toStdString();
        if (!fault->second.empty())
            result.push_back(warningAt(use.range, fault->second));
        const sgml::NodeId image = document_->tree().innermostAt(use.range.from);
        if (image != sgml::noNode && !document_->tree().attribute(image, "ALT"))
            result.push_back(
                warningAt(use.range,
                          "the image has no alternative text (ALT): words for who does not see it, "
                          "or ALT=\"\" where it says nothing"));
    }
    return result;
}

// LIMIT: a medium is asked only when it runs.
std::vector<sgml::Fault> OpenDocument::ofSliders() const {
    std::vector<sgml::Fault> result;
    for (const document::SliderUse& use : uses_.sliders()) {
        const media::LiveSubdocument* of = live(use.subdocument);
        if (!of || !of->parameters() || std::ranges::count(*of->parameters(), use.parameter) > 0)
            continue;
        const auto& said = of->diagnostics().items;
        const bool faulty = std::ranges::any_of(
            said, [](const auto& item) { return item.severity == ipc::Severity::error; });
        if (!faulty) // what cannot be read has no parameters
            result.push_back(
                warningAt(use.range, "the subdocument of this slider has no parameter \"" +
                                         use.parameter + "\""));
    }
    return result;
}

// LIMIT: a medium is asked only when it runs.
std::vector<sgml::Fault> OpenDocument::ofPresentations() const {
    std::vector<sgml::Fault> result;
    for (const auto& [id, subdocument] : live_) {
        const document::Subdocument* of = document_->subdocument(id);
        const auto& offered = subdocument->presentations();
        const auto isIt = [&](const ipc::Presentation& one) { return one.id == of->presentation; };
        if (of->presentation.empty() || offered.empty() || std::ranges::any_of(offered, isIt))
            continue;
        std::string names;
        for (const ipc::Presentation& one : offered)
            names += (names.empty() ? "" : ", ") + one.id;
        result.push_back(warningAt(document_->tree().node(of->classElement).startTag,
                                   subdocument->name().toStdString() + " has no presentation \"" +
                                       of->presentation + "\"; it has: " + names));
    }
    return result;
}

std::vector<sgml::Fault> OpenDocument::ofFormulas() {
    std::vector<sgml::Fault> result;
    for (const sgml::NodeId content : uses_.formulas())
        formulas_.add(document_->tree(), content, result);
    return result;
}

std::vector<ListedFault> OpenDocument::valueFaults() const {
    std::vector<sgml::Fault> faults = values_->faults();
    sgml::placeFaults(faults, document_->tree());
    std::vector<ListedFault> result;
    result.reserve(faults.size());
    for (const sgml::Fault& fault : faults)
        result.push_back(listed(fault));
    return result;
}

// Of elements, and of parts of formulas.
std::vector<PlacedValue> OpenDocument::placedValues() {
    std::vector<PlacedValue> result;
    const sgml::Tree& tree = document_->tree();
    for (const sgml::NodeId element : uses_.values())
        result.push_back({document::valueUse(tree, element), tree.node(element).startTag});
    for (const sgml::NodeId content : uses_.formulas()) {
        if (tree.text(tree.node(content).range).find("value") == std::string_view::npos)
            continue;
        const sgml::Unescaped spelling = tree.unescaped(content);
        for (const formulas::ValueCall& call : formulas_.valuesIn(spelling.text()))
            result.push_back(
                {.use = document::valueUse(call.of, call.expression, call.options),
                 .range = {spelling.fileOffset(call.offset), spelling.fileOffset(call.end)},
                 .isElement = false});
    }
    return result;
}

// Of the classes that are in the document.
std::vector<ListedFault> OpenDocument::ofSchemas() const {
    QStringList classes{QStringLiteral("COMMON"), QString::fromStdString(document_->className())};
    for (const document::SubdocumentId id : document_->subdocuments())
        classes << QString::fromStdString(document_->subdocument(id)->className);
    std::vector<ListedFault> result;
    for (const schemas::Schemas::FileFault& fault : schemas_.faults())
        if (classes.contains(QFileInfo(fault.file).fileName().section(QLatin1Char('.'), 0, 0))) {
            result.push_back(listed(fault.fault));
            result.back().file = fault.file;
        }
    return result;
}

std::vector<ListedFault> OpenDocument::faults() {
    std::vector<sgml::Fault> all = ofDocument();
    std::vector<document::SubdocumentId> by(all.size(), document::noSubdocument);
    const auto add = [&](std::vector<sgml::Fault> more, document::SubdocumentId id) {
        all.insert(all.end(), std::make_move_iterator(more.begin()),
                   std::make_move_iterator(more.end()));
        by.resize(all.size(), id);
    };
    add(ofImages(), document::noSubdocument);
    add(ofSliders(), document::noSubdocument);
    add(ofPresentations(), document::noSubdocument);
    add(ofFormulas(), document::noSubdocument);
    add(values_->faults(), document::noSubdocument);
    for (const auto& [id, subdocument] : live_)
        add(saidBy(id), id);
    std::vector<std::size_t> order(all.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_sort(order.begin(), order.end(),
                     [&](std::size_t a, std::size_t b) { return isBefore(all[a], all[b]); });
    std::vector<std::size_t> offsets;
    offsets.reserve(order.size());
    for (const std::size_t i : order)
        offsets.push_back(all[i].range.from);
    const std::vector<text::Position> places = document_->tree().positions(offsets);
    std::vector<ListedFault> result = ofSchemas();
    for (std::size_t i = 0; i < order.size(); ++i) {
        result.push_back(listed(all[order[i]], by[order[i]]));
        result.back().position = places[i];
    }
    return result;
}

} // namespace session
