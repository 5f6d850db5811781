// Runs without the things that may be causes.
#pragma once

#include "insight/why/candidates.hpp"
#include "insight/why/question_target.hpp"

#include <vector>

namespace trembler::insight {

/// Tests candidates by leaving them out and running again. Not thread-safe.
class SecondRuns {
public:
    /// All must outlive it.
    SecondRuns(LevelRuns const& runs, Solution const& solution, Target const& target,
               AskOptions const& options);

    /// How well each step of the story is known. Each candidate is left out by itself. If what was asked
    /// about happens without any one of some of them, but not without all of these, several would have
    /// sufficed: then a smallest set of them without which it does not happen is found by halving (delta
    /// debugging, Zeller and Hildebrandt 2002). A step that is no candidate is confirmed if it did not happen
    /// either in a run without one of its causes in which what was asked about did not happen.
    [[nodiscard]] std::vector<Proof> test(std::vector<Candidate> const& candidates);

    [[nodiscard]] std::size_t runs() const { return done_; }
    [[nodiscard]] bool complete() const { return complete_; }

private:
    struct Outcome {
        bool happens = true;
        std::vector<bool> steps; ///< which steps of the story happen; empty if it was not looked
    };
    [[nodiscard]] Outcome without(std::vector<Candidate> const& candidates,
                                  std::vector<std::size_t> const& left);
    [[nodiscard]] std::vector<std::size_t> smallestOf(std::vector<Candidate> const& candidates,
                                                      std::vector<std::size_t> set);
    void noteRun(std::size_t planned);
    /// Confirms the steps between a candidate and the end that vanished with it.
    void noteVanished(std::vector<Proof>& proofs, std::vector<std::size_t> const& from,
                      Outcome const& outcome, Proof proof) const;

    LevelRuns const& runs_;
    Solution const& solution_;
    Target const& target_;
    AskOptions const& options_;
    std::uint64_t horizon_;
    std::size_t done_ = 0;
    bool complete_ = true;
};

} // namespace trembler::insight
