// At which tolerances is the accuracy kept, and how far off is the motion then?
//
//     Tightening search(accuracy, bodies)
//     loose = run at search.loose()
//     repeat
//         tight = run at search.tight()
//         search.judge(differences of the two, islands of the tight run, errors)
//         loose = tight
//     while search.goesOn()
//     search.prove(differences of the tight run and one at search.proof(), errors), where wanted;
//     repeat if it goes on then
//     the motion is that of the tight run, and `errors` are its
//
// The difference of two runs is the error of the looser one. The tighter one's is less by as much
// as errors follow tolerances, but no tolerance counts for less than what rounding does in a step.
// An island is settled when that estimate is well below the accuracy, or when tightening does not
// help any more: then the rest is rounding, or motion that amplifies it.
#pragma once

#include "accuracy/accuracy.h"

#include <optional>
#include <vector>

namespace simulation {

class Tightening {
public:
    static constexpr std::size_t fewSteps = 24; // whose errors follow no tolerance
    Tightening(double accuracy, std::size_t bodies);

    // The relative error that one step may have, by body.
    [[nodiscard]] const std::vector<double>& loose() const { return loose_; }
    [[nodiscard]] const std::vector<double>& tight() const { return tight_; }

    // By body: is its next run another than the one at loose()? If not, that says all.
    [[nodiscard]] std::vector<bool> runsAgain() const;

    // A body that is not integrated moves the same at any tolerance, but for how expressions that
    // hold it are fitted: it keeps the first one.
    void leaveExact(const Run& run);
    // Equal runs: their tolerances were both below what rounding does. Then roughen() makes loose()
    // of such bodies large enough for a run that differs.
    [[nodiscard]] bool needsRougher(const std::vector<IslandError>& differences) const;
    void roughen(const std::vector<IslandError>& differences);
    // Takes the differences between the runs at loose() and tight(), by body, writes the errors of
    // the tighter one where they are known now, and says which tolerances to compare next: then
    // loose() is what tight() was.
    void judge(const std::vector<IslandError>& differences, const std::vector<std::size_t>& island,
               std::vector<BodyError>& errors);
    [[nodiscard]] bool goesOn() const;

    // By body: its errors follow no tolerance, or two runs may agree by chance. Then they are
    // measured: of a motion of so few steps, and of one that amplifies errors, by a run that is
    // tighter still; of one that leapt to the tolerance of rounding by one that is a little looser.
    [[nodiscard]] std::vector<bool> unproven() const;
    [[nodiscard]] std::vector<double> proof() const;
    // What proof() will be if all bodies settle with the run at tight() and want a proof. None
    // where some are settled before: nobody knows then.
    [[nodiscard]] std::optional<std::vector<double>> tighter() const;
    // A settled body is worth a tighter run for another reason, where there is one.
    void doubt(std::size_t body);
    // By body, of its island: what errors are scaled by.
    [[nodiscard]] std::vector<double> sizes() const;
    // Takes the differences between the runs at tight() and proof(), and writes these errors. Where
    // they are larger than the accuracy the search goes on, or the horizon is written.
    void prove(const std::vector<IslandError>& differences, std::vector<BodyError>& errors);
    [[nodiscard]] std::vector<bool> unsettled() const; // by body

private:
    enum class Proof { none, tighter, looser };
    struct Body {
        double before = -1; // the difference of the runs compared before; negative: none were
        double looser = 0;  // the tolerance of the looser of them
        double beyondBefore = 0;
        double size = 0;
        int failures = 0; // to come closer
        bool isSettled = false;
        Proof proof = Proof::none;
    };
    struct Outlook { // for the tighter run
        double order = 0, gain = 0, estimate = 0;
        bool isMeasured = false; // the order, by two pairs of runs
    };
    [[nodiscard]] bool isEqual(std::size_t b, const IslandError& difference) const;
    [[nodiscard]] Outlook outlook(std::size_t b, const IslandError& difference,
                                  double rounding) const;
    [[nodiscard]] bool isKept(const IslandError& difference, const Outlook& outlook) const;
    [[nodiscard]] double next(std::size_t b, const IslandError& difference, BodyError& error);
    void settle(std::size_t b, const IslandError& difference, double estimate, double factor,
                BodyError& error);
    [[nodiscard]] Proof proofFor(std::size_t b, const IslandError& difference,
                                 double rounding) const;
    void proveByLooser(std::size_t b, const IslandError& difference, BodyError& error);
    void share(const std::vector<std::size_t>& island);

    double accuracy_;
    std::vector<double> loose_, tight_;
    std::vector<Body> bodies_;
};

} // namespace simulation
