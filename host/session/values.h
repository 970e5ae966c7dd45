// The values of subdocuments that stand in a document's texts and formulas: what their media are
// asked for, what is known, and what is out of date.
//
// A value at the time that its subdocument shows follows it: its medium tells it as it plays. All
// others are asked for once for each text of the subdocument. For a value that is not known a
// process starts, behind the scenes and few at a time; when it has answered, it rests as others do,
// and the value stays true as long as text and time stay. A number of an older text is out of date
// when its medium takes long to say the new one, or cannot.
// A value at a fixed time follows a slider of its figure, too: it is read again when the medium
// knows a motion after it did not, or tells that its motion is another one. LIMIT: at most 1000
// values for one time of a figure, and 100 fixed times: the others are faults.
#pragma once

#include "document/subdocument.h"
#include "ipc/messages.h"
#include "media/live_subdocument.h"
#include "model/value_text.h"
#include "session/placed_value.h"

#include <QObject>
#include <QPointer>
#include <QTimer>
#include <deque>
#include <functional>
#include <map>
#include <set>

namespace session {

class OpenDocument;

class Values : public QObject, public model::ValueSource {
    Q_OBJECT

public:
    // Reads which values there are when the document has changed; both outlive it.
    Values(OpenDocument& document, std::function<std::vector<PlacedValue>()> placed);
    ~Values() override;

    [[nodiscard]] model::ValueNow valueNow(const document::ValueUse& use) const override;
    // No answer is awaited.
    [[nodiscard]] bool isSettled() const;
    // Asks for all that is not known, and says so when it is or cannot be: settled(), never inside
    // this call, at the latest after mostMs.
    void settle();
    // Why there is no number, at each place: without positions.
    [[nodiscard]] std::vector<sgml::Fault> faults() const;

    static constexpr int mostMs = 120'000;        // for the answer of one medium
    static constexpr int betweenMs = 80;          // from one change of numbers to the next
    static constexpr int soonMs = 200;            // after an edit
    static constexpr int lateMs = 700;            // a number that old is marked
    static constexpr std::size_t atOnce = 2;      // processes that start for values alone
    static constexpr std::size_t mostTimes = 100; // fixed ones of one figure

    // Of a value: its number, or why there is none.
    struct Known {
        std::optional<double> number{};
        std::string fault{};
        bool operator==(const Known&) const = default;
    };

Q_SIGNALS:
    void changed(); // some numbers, at most every betweenMs
    void faultsChanged();
    void settled();

private:
    struct Figure {
        QPointer<media::LiveSubdocument> live; // null: it has no medium
        std::vector<std::string> moving;       // at the time that it shows
        std::map<double, std::vector<std::string>> fixed;
        std::map<std::pair<std::string, std::optional<double>>, Known> known;
        unsigned text = 1;                // grows when its values may be others
        unsigned asked = 0, answered = 0; // of which text
        unsigned question = 0;            // the last one; answers to others are late
        int awaited = 0;                  // answers to it
        std::string refusal{};            // a sentence: it tells nothing of this text
        bool isLate = false;
        bool hasMotion = false, isPlaying = false; // as it was told last
        ipc::Integer motion = 0;                   // its number, of the last that was known
        std::optional<double> shown{};
    };

    void gather();
    void follow(document::SubdocumentId id, Figure& figure);
    void ask(document::SubdocumentId id);
    void read(document::SubdocumentId id, const std::vector<std::string>& expressions,
              std::optional<double> time);
    void answered(document::SubdocumentId id);
    void refuse(Figure& figure, const ipc::Error& error);
    void take(Figure& figure, const std::string& expression, std::optional<double> time,
              Known known);
    void takeTold(document::SubdocumentId id);
    void takeTime(document::SubdocumentId id);
    void expectOthers(Figure& figure);
    void textChanged(document::SubdocumentId id);
    void markLate();
    void want(document::SubdocumentId id);
    void startWanted();
    void giveUp(document::SubdocumentId id);
    void release(document::SubdocumentId id);
    void tell();
    void tellSettled();
    void giveUpSettling();
    [[nodiscard]] static bool isDone(const Figure& figure);

    OpenDocument& document_;
    std::function<std::vector<PlacedValue>()> placed_;
    std::map<std::string, document::SubdocumentId, std::less<>> names_;
    std::map<document::SubdocumentId, Figure> figures_; // that have values somewhere
    std::deque<document::SubdocumentId> wanted_;        // that need a process
    std::map<document::SubdocumentId, QTimer*> held_;   // whose process is kept
    QTimer gather_, tell_, late_, settleBy_;
    bool hasAny_ = false; // values
    bool hasChanged_ = false, haveFaultsChanged_ = false, isSettling_ = false;
};

} // namespace session
