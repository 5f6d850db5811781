// Where the events of a traced run happened, at their moments.
#pragma once

#include "runtime/trace/event.hpp"
#include "runtime/world/world.hpp"

#include <cstddef>
#include <map>

namespace trembler::insight {

/// Follows a run frame by frame. Not thread-safe.
class StepPlaces {
public:
    /// To be called after every frame of a world that is traced.
    void look(World const& world);

    /// Of an event that a step may describe (kindOf()), m, in the world: of a contact, the middle between the
    /// two objects where they were nearest to each other at the end of the frame; else where its first object
    /// was. `otherwise` if that is not known, as of an object that is gone.
    [[nodiscard]] Vec2 of(EventId event, Vec2 otherwise) const;

private:
    std::size_t seen_ = 0; // events of the trace
    std::map<EventId, Vec2> places_;
};

} // namespace trembler::insight
