// The values of a subdocument, as its medium tells them.
#include "media/live_subdocument.h"

namespace media {

void LiveSubdocument::watch(std::vector<std::string> expressions) {
    const ValueWatch::Commands commands = watched_.watch(std::move(expressions));
    if (!isReady())
        return; // the next process is asked
    if (commands.end)
        process().request(*commands.end);
    if (commands.begin)
        process().request(*commands.begin);
}

void LiveSubdocument::listValues(std::function<void(const std::vector<ipc::ValueOffer>&)> done) {
    if (!isReady())
        return done({});
    process().request(ipc::ValueList{}, [done = std::move(done)](auto outcome) {
        const auto* offers = std::get_if<ipc::ValueOffers>(&outcome);
        done(offers ? offers->items : std::vector<ipc::ValueOffer>());
    });
}

void LiveSubdocument::readValues(const std::vector<std::string>& expressions,
                                 std::optional<double> time,
                                 std::function<void(Outcome<ipc::Values>)> done) {
    QString why;
    if (!isReady())
        why = reason_.isEmpty() ? name() + " is not ready." : reason_;
    else if (expressions.size() > ipc::mostExpressions.most)
        why = QStringLiteral("So many values cannot be asked for at once.");
    if (!why.isEmpty()) { // later, as every answer comes
        const ipc::Error error{static_cast<ipc::Integer>(ipc::ErrorCode::notPossible),
                               why.toStdString()};
        QTimer::singleShot(0, this, [done = std::move(done), error] { done(error); });
        return;
    }
    process().request(ipc::ValueRead{expressions, time},
                      [done = std::move(done), count = expressions.size()](auto outcome) {
                          const auto* read = std::get_if<ipc::Values>(&outcome);
                          const bool isWrong =
                              read && (read->values.size() != count ||
                                       (!read->faults.empty() && read->faults.size() != count));
                          if (isWrong)
                              done(ipc::Error{ipc::ErrorCode::internalError,
                                              "the medium told more or fewer values than it was "
                                              "asked for"});
                          else
                              done(std::move(outcome));
                      });
}

} // namespace media
