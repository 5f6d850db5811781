// Decides which calls of an interaction are events.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/trace/tracer.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

namespace trembler {

/// A held call is an event only when it is new: "this will be done for every frame from now on and will not
/// be mentioned again" (6.8.3). Later equal calls have the first one's id. Used while a trace is recorded, by
/// one thread at a time for each chunk.
///
/// Most interactions hold the same calls in the same order in every apply, so each call is first compared
/// with the one that followed in the last apply. As long as these are equal nothing is written; from the
/// first one that differs, the calls are listed, and searched for.
class CallTrace {
public:
    /// Call at the beginning of an apply.
    void begin() {
        now_.resize(1);
        for (Chunk& chunk : now_) {
            chunk.clear();
        }
    }
    /// Makes room for this number of chunks of the apply.
    void widen(std::size_t chunks) { now_.resize(std::max(chunks, now_.size())); }
    /// Call at the end of an apply: its held calls replace those of the last apply.
    void end() {
        for (std::size_t i = 0; i < std::min(last_.size(), now_.size()); ++i) {
            if (now_[i].same) {
                std::swap(now_[i].held, last_[i].held);
                now_[i].held.resize(now_[i].next);
            }
        }
        std::swap(last_, now_);
    }
    /// Call instead of end() if the apply has failed: nothing is held any more, so every later held call is
    /// an event.
    void forget() {
        last_.clear();
        now_.clear();
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
            Key key;
            key.call = C::text.name;
            static_assert(std::tuple_size_v<std::remove_const_t<decltype(objects)>> <= mostObjects);
            std::copy(objects.begin(), objects.end(), key.objects.begin());
            Chunk& now = now_[chunk];
            if (Held const* const expected = expectedNext(chunk);
                expected != nullptr && expected->key == key) {
                ++now.next;
                if (!now.same) {
                    now.held.push_back(*expected);
                }
                return expected->id;
            }
            if (std::exchange(now.same, false) && now.next > 0) {
                auto const first = last_[chunk].held.begin();
                now.held.assign(first, first + static_cast<std::ptrdiff_t>(now.next));
            }
            EventId id = find(key, chunk);
            if (id == EventId{}) {
                id = sink.record(C::text.name, objects, std::array{cause});
                now.fresh.emplace(key, id);
            }
            now.held.push_back({key, id});
            return id;
        } else {
            return sink.record(C::text.name, objects, std::array{cause});
        }
    }

private:
    static constexpr std::size_t mostObjects = 3; // named by one call

    struct Key {
        std::string_view call;
        std::array<ObjectId, mostObjects> objects{};

        friend bool operator==(Key const& a, Key const& b) {
            return a.objects == b.objects && a.call.size() == b.call.size() &&
                   (a.call.data() == b.call.data() || a.call == b.call);
        }
        friend bool operator<(Key const& a, Key const& b) {
            return a.objects != b.objects ? a.objects < b.objects : a.call < b.call;
        }
    };
    struct Held {
        Key key;
        EventId id;
    };
    struct Chunk {
        std::vector<Held> held;       // the held calls, in order; none while `same`
        std::map<Key, EventId> fresh; // those held calls that are events of this apply
        std::vector<Held> known;      // calls of the last apply, sorted; filled by the first search
        bool searched = false;
        bool same = true;     // so far its calls are the first `next` ones of the last apply
        std::size_t next = 0; // index in the last apply of the call expected next

        void clear() {
            held.clear();
            fresh.clear();
            known.clear();
            searched = false;
            same = true;
            next = 0;
        }
    };

    [[nodiscard]] Held const* expectedNext(std::size_t chunk) const {
        bool const any = chunk < last_.size() && now_[chunk].next < last_[chunk].held.size();
        return any ? &last_[chunk].held[now_[chunk].next] : nullptr;
    }

    /// The event of an equal call in the last apply, or in this chunk; none if it is new.
    EventId find(Key const& key, std::size_t chunk) {
        Chunk& now = now_[chunk];
        auto const before = [](Held const& held, Key const& sought) { return held.key < sought; };
        if (!std::exchange(now.searched, true)) {
            for (Chunk const& each : last_) {
                now.known.insert(now.known.end(), each.held.begin(), each.held.end());
            }
            std::stable_sort(now.known.begin(), now.known.end(),
                             [](Held const& a, Held const& b) { return a.key < b.key; });
        }
        auto const known = std::lower_bound(now.known.begin(), now.known.end(), key, before);
        if (known != now.known.end() && known->key == key) {
            ++now.next; // as if it had been the expected call, so that the following calls may still match
            return known->id;
        }
        auto const here = now.fresh.find(key);
        return here == now.fresh.end() ? EventId{} : here->second;
    }

    std::vector<Chunk> last_; // held calls of the last apply
    std::vector<Chunk> now_;
};

} // namespace trembler
