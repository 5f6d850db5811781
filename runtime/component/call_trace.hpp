// Decides which calls of an interaction are events.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/trace/tracer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <utility>
#include <vector>

namespace trembler {

/// A held call is an event only when it is new: "this will be done for every frame from now on and will not
/// be mentioned again" (6.8.3). Later equal calls have the first one's id. Used while a trace is recorded, by
/// one thread at a time for each chunk.
class CallTrace {
public:
    /// Call at the beginning of an apply.
    void begin() { newHeld_.assign(1, {}); }
    /// Makes room for this number of chunks of the apply.
    void widen(std::size_t chunks) { newHeld_.resize(std::max(chunks, newHeld_.size())); }
    /// Call at the end of an apply: its held calls replace those of the last apply.
    void end() {
        held_.clear();
        for (auto& chunk : newHeld_) {
            held_.merge(chunk);
        }
    }
    /// Call instead of end() if the apply has failed: nothing is held, and what will be is new.
    void forget() {
        held_.clear();
        newHeld_.clear();
    }
    /// The event of a call: a new one, or that of the same call in the last apply, or none.
    template <InteractionCall C>
    EventId record(C const& c, EventId cause, EventSink& sink, std::size_t chunk) {
        auto const objects = c.objects();
        if constexpr (isHeld(C::algebra)) {
            if constexpr (requires { c.magnitude(); }) {
                if (!(c.magnitude() > C::negligible)) {
                    return {};
                }
            }
            HeldKey key{C::text.name, {objects.begin(), objects.end()}};
            EventId id;
            if (auto const known = held_.find(key); known != held_.end()) {
                id = known->second;
            } else if (auto const here = newHeld_[chunk].find(key); here != newHeld_[chunk].end()) {
                id = here->second;
            } else {
                id = sink.record(C::text.name, objects, std::array{cause});
            }
            newHeld_[chunk].emplace(std::move(key), id);
            return id;
        } else {
            return sink.record(C::text.name, objects, std::array{cause});
        }
    }

private:
    using HeldKey = std::pair<std::string_view, std::vector<ObjectId>>;

    std::map<HeldKey, EventId> held_; // held calls of the last apply
    std::vector<std::map<HeldKey, EventId>> newHeld_;
};

} // namespace trembler
