// Runs without the things that may be causes.
#pragma once

#include "insight/why/runs/candidates.hpp"
#include "insight/why/runs/question_target.hpp"

#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <vector>

namespace trembler::insight {

/// Tests candidates by leaving them out and running again, several at the same time. The results depend on
/// neither the number of threads nor their order. One thread at a time may use it.
class SecondRuns {
public:
    /// All must outlive it.
    SecondRuns(LevelRuns const& runs, Solution const& solution, Target const& target, SceneFacts const& facts,
               AskOptions const& options);

    struct Tested {
        std::vector<Proof> proofs; ///< how well each step of the story is known
        /// Of the steps that are known, but not traced, or of the last step of the bridge from there: the
        /// first step of the story that did not happen without them, which is the asked one at the latest.
        std::map<std::size_t, std::size_t> effects;
    };
    /// Leaves out each candidate by itself. If what was asked about happens without any one of some of them,
    /// but not without all of these, several would have sufficed: then a smallest set of them without which
    /// it does not happen is found by halving (delta debugging, Zeller and Hildebrandt 2002). The same is
    /// done with the player's deeds alone if no single one of them is known by then. A step that is no
    /// candidate is confirmed if it did not happen either in a run without one of its causes in which what
    /// was asked about did not happen.
    [[nodiscard]] Tested test(std::vector<Candidate> const& candidates);

    /// The number of runs whose results were needed.
    [[nodiscard]] std::size_t runs() const { return done_; }
    [[nodiscard]] bool complete() const { return complete_; }

private:
    struct Outcome {
        enum class Kind : std::uint8_t {
            unknown,   ///< it cannot be run, or was stopped
            happens,   ///< what was asked about happens all the same
            prevented, ///< it does not
        };
        Kind kind = Kind::unknown;
        std::vector<bool> steps; ///< if it is prevented: which steps of the story happen
    };
    using Set = std::vector<std::size_t>; ///< of candidates
    /// One run. It ends as soon as what was asked about happens.
    [[nodiscard]] Outcome without(std::vector<Candidate> const& candidates, Set const& left);
    /// Runs without each of the sets. `note`: whether each run is counted.
    [[nodiscard]] std::vector<Outcome> without(std::vector<Candidate> const& candidates,
                                               std::vector<Set> const& sets, bool note);
    /// A smallest set within one without which it is prevented, and the outcome of the run without it.
    void makeSmallest(std::vector<Candidate> const& candidates, Set& set, Outcome& outcome);
    /// The first of the sets without which it is prevented; the number of sets if there is none.
    [[nodiscard]] std::size_t firstPreventing(std::vector<Candidate> const& candidates,
                                              std::vector<Set> const& sets, Outcome& outcome);
    /// Counts a run; returns false without counting it if no further runs are wanted.
    bool noteRun(std::size_t planned);
    [[nodiscard]] bool stops();
    /// The end of the first bridge from a deed that did not happen in the run without the deed, and by which
    /// the deed acted: without what its device does, what was asked about does not happen either. All other
    /// bridges of the deed are refuted. Nothing if there is none.
    [[nodiscard]] std::optional<std::size_t> bridgeFor(Tested& tested, std::size_t deed, std::size_t effect,
                                                       Outcome const& outcome);
    /// Whether what was asked about does not happen if a device does not do what this step of a bridge
    /// switches; of a current through anything else it is taken for granted.
    [[nodiscard]] bool mediates(Step const& end);
    /// Marks the steps of candidates without which it is prevented, finds the effects of those that are not
    /// traced, and confirms what vanished between them and the end.
    void note(Tested& tested, std::vector<std::size_t> const& steps, Outcome const& outcome, Proof proof);
    void noteVanished(Tested& tested, std::vector<std::size_t> const& from, Outcome const& outcome,
                      Proof proof) const;
    /// If what was asked about does not happen without all of these candidates: a smallest set of them.
    void testTogether(Tested& tested, std::vector<Candidate> const& candidates, Set some);

    LevelRuns const& runs_;
    Solution const& solution_;
    Target const& target_;
    SceneFacts const& facts_;
    AskOptions const& options_;
    std::uint64_t horizon_;
    int threads_;
    std::mutex noting_;
    std::size_t done_ = 0;
    std::atomic<bool> complete_ = true;
};

} // namespace trembler::insight
