// The player's deeds, as steps of a story.
#pragma once

#include "insight/ablation/needs.hpp"
#include "insight/why/story/story.hpp"

#include <optional>
#include <span>
#include <vector>

namespace trembler::insight {

/// Whether a step is something that the player did: laid, connected, took hold of, cut or removed.
[[nodiscard]] bool isDeed(StepKind kind);

/// Finds the deeds in the solution that belong to a story's steps by hand. Each deed belongs to one step
/// only.
class DeedFinder {
public:
    /// The solution must outlive it.
    explicit DeedFinder(Solution const& solution);

    /// The deed of a step of kind grabbed, cut or removed, which belongs to no earlier step; nullptr if there
    /// is none.
    [[nodiscard]] Deed const* find(Step const& step);
    /// The deeds that were not found so far, with a step for each, in their order.
    [[nodiscard]] std::vector<Step> others() const;

private:
    [[nodiscard]] Step stepOf(Deed const& deed) const;

    Solution const& solution_;
    std::vector<Deed> deeds_;
    std::vector<bool> found_;
};

/// A story with a step for everything that the player did up to the moment that was asked about. What the
/// trace does not connect with it has no effects there, and `Step::traced` is false; what the trace does say
/// of its consequences is in the story as well, as bridges: to the magnets and motors that it switched, and
/// to a current through one of the asked objects, see bridgesFrom(). `events` is the trace of the story.
[[nodiscard]] Story withDeeds(Story const& story, Solution const& solution, SceneFacts const& facts,
                              std::span<Event const> events);

} // namespace trembler::insight
