// Which of the calls that an interaction makes are events.
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
/// be mentioned again" (6.8.3). Later ones carry the first one's id. Used while a trace is recorded; one
/// thread at a time for each chunk.
class CallTrace {
public:
    /// An apply begins.
    void begin() { fresh_.assign(1, {}); }
    /// There are at least so many chunks in it.
    void widen(std::size_t chunks) { fresh_.resize(std::max(chunks, fresh_.size())); }
    /// The apply is done: its held calls are known from now on, and those that it did not make are not.
    void end() {
        told_.clear();
        for (auto& chunk : fresh_) {
            told_.merge(chunk);
        }
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
            Key key{C::text.name, {objects.begin(), objects.end()}};
            EventId id;
            if (auto const known = told_.find(key); known != told_.end()) {
                id = known->second;
            } else if (auto const here = fresh_[chunk].find(key); here != fresh_[chunk].end()) {
                id = here->second;
            } else {
                id = sink.record(C::text.name, objects, std::array{cause});
            }
            fresh_[chunk].emplace(std::move(key), id);
            return id;
        } else {
            return sink.record(C::text.name, objects, std::array{cause});
        }
    }

private:
    using Key = std::pair<std::string_view, std::vector<ObjectId>>;

    std::map<Key, EventId> told_; // held calls of the last apply
    std::vector<std::map<Key, EventId>> fresh_;
};

} // namespace trembler
