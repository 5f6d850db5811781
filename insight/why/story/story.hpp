// The events that led to an event, without the calls between components: the events that a person would name.
#pragma once

#include "insight/why/story/scene_facts.hpp"
#include "insight/why/story/step.hpp"

#include <cstddef>
#include <map>
#include <span>
#include <vector>

namespace trembler::insight {

/// An event and all that led to it, in the order of the trace, placements first.
struct Story {
    std::vector<Step> steps;
    std::size_t asked = 0; ///< the step that was asked about: the last
    /// Of a deed that is not traced the last step of each of its bridges, in the order in which they are to
    /// be tried.
    std::map<std::size_t, std::vector<std::size_t>> bridges{};

    [[nodiscard]] Step const& askedStep() const { return steps[asked]; }
};

/// The story of an event of a trace, which must be in it. A current's causes are not only the connection that
/// came last, but all contacts that close circuits at that time, and those of one that ends by a new contact
/// are also the other contacts of what touched, as of a bar that short-circuits it; what moves an object to a
/// place of a goal is also what last touched or pulled it, and that it dips into a liquid, or something that
/// joints tie it to does. What a magnet's force led to follows from the main pulls and pushes on the body at
/// that time (`SceneFacts::pulls`), wherever on it they act. A contact of a placed object, and a pull on it
/// or by it, has its placement as a cause. No step is caused by a later one.
[[nodiscard]] Story storyOf(std::span<Event const> events, EventId asked, SceneFacts const& facts);

} // namespace trembler::insight
