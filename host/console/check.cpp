#include "console/check.h"

#include "console/batch_document.h"
#include "console/convert.h"
#include "terminal/terminal.h"

namespace console {

namespace {

// A medium answers a load at once; what is wrong with the text follows.
constexpr int mostMsForDiagnostics = 30'000;

// Runs every medium until it has said what is wrong with its text, a few at a time.
class Examination {
public:
    explicit Examination(BatchDocument& batch) : batch_(batch) {}

    void run() {
        for (const document::SubdocumentId id : batch_.document().document().subdocuments())
            if (media::LiveSubdocument* live = batch_.document().live(id))
                examine(id, *live);
    }
    // A fault for each medium that has said nothing in time.
    [[nodiscard]] const std::vector<session::ListedFault>& silent() const { return silent_; }

private:
    void examine(document::SubdocumentId id, media::LiveSubdocument& live) {
        QEventLoop loop;
        bool answered = false;
        const auto look = [&] {
            const bool parametersKnown = !batch_.document().hasSliders(id) || live.parameters();
            if ((answered && live.hasLoaded() && parametersKnown) ||
                live.condition() == media::Condition::failed)
                loop.quit();
        };
        QObject::connect(&live, &media::LiveSubdocument::diagnosticsChanged, &loop, [&] {
            answered = true;
            look();
        });
        QObject::connect(&live, &media::LiveSubdocument::loaded, &loop, look);
        QObject::connect(&live, &media::LiveSubdocument::parametersChanged, &loop, look);
        QObject::connect(&live, &media::LiveSubdocument::conditionChanged, &loop, look);
        QTimer::singleShot(mostMsForDiagnostics, &loop, &QEventLoop::quit);
        live.start();
        loop.exec();
        if (!answered && live.condition() != media::Condition::failed)
            silent_.push_back(
                {placeOf(id), true,
                 live.name() + QStringLiteral(" did not say whether the text is right."), id});
        live.makeStill();
    }

    text::Position placeOf(document::SubdocumentId id) const {
        const document::Document& of = batch_.document().document();
        const document::Subdocument* subdocument = of.subdocument(id);
        return subdocument ? of.tree().position(of.tree().node(subdocument->element).range.from)
                           : text::Position{};
    }

    BatchDocument& batch_;
    std::vector<session::ListedFault> silent_;
};

} // namespace

int check(const QString& input) {
    BatchDocument batch(input);
    if (!batch.isOpen()) {
        complain(batch.failure());
        return failure;
    }
    Examination examination(batch);
    examination.run();
    batch.settleValues();
    std::vector<session::ListedFault> faults = batch.document().faults();
    faults.insert(faults.end(), examination.silent().begin(), examination.silent().end());
    std::stable_sort(faults.begin(), faults.end(), [](const auto& a, const auto& b) {
        return std::pair(a.file.isEmpty(), a.position) < std::pair(b.file.isEmpty(), b.position);
    });
    bool errors = false;
    for (const session::ListedFault& fault : faults) {
        errors |= fault.isError;
        terminal::say(sgml::formatted(
            {.severity = fault.isError ? sgml::Severity::error : sgml::Severity::warning,
             .position = fault.position,
             .message = fault.message.toStdString()},
            (fault.file.isEmpty() ? input : fault.file).toStdString()));
    }
    return errors ? failure : success;
}

} // namespace console
