// Where an interaction records its calls: a buffer for each type of call and each chunk of its work.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/component/caller_id.hpp"
#include "runtime/property/state_hash.hpp"
#include "runtime/trace/event.hpp"

#include <algorithm>
#include <cstdint>
#include <deque>
#include <span>
#include <string>
#include <tuple>
#include <type_traits>
#include <vector>

namespace trembler {

/// Records the calls of one type that one chunk of an interaction's work makes. Written by one thread at a
/// time; no locks.
template <InteractionCall C>
class CallBuffer {
public:
    void push(C const& call) { calls_.push_back(call); }
    /// Sets the cause of the call that was recorded last. There must be one.
    void setCauseOfLast(EventId cause) {
        causes_.resize(calls_.size());
        causes_.back() = cause;
    }
    void clear() {
        calls_.clear();
        causes_.clear();
    }
    /// The calls recorded from here on are those of a new turn.
    void startTurn() { turnFrom_ = calls_.size(); }
    /// Removes the calls of the current turn.
    void withdrawTurn() {
        if (turnFrom_ < calls_.size()) {
            calls_.erase(calls_.begin() + static_cast<std::ptrdiff_t>(turnFrom_), calls_.end());
            causes_.resize(std::min(causes_.size(), turnFrom_));
        }
    }
    [[nodiscard]] std::span<C const> calls() const { return calls_; }
    [[nodiscard]] EventId cause(std::size_t i) const { return i < causes_.size() ? causes_[i] : EventId{}; }

private:
    std::vector<C> calls_;
    std::vector<EventId> causes_; // shorter than calls_ without a trace
    std::size_t turnFrom_ = 0;
};

namespace detail {
template <class List>
struct BuffersOf;
template <class... C>
struct BuffersOf<CallList<C...>> {
    using Type = std::tuple<CallBuffer<C>...>;
};
template <class C, class List>
inline constexpr bool callListed = false;
template <class C, class... D>
inline constexpr bool callListed<C, CallList<D...>> = (std::is_same_v<C, D> || ...);
} // namespace detail

/// The records of all calls of one interaction (or of the caller outside), in one CallBuffer per call type
/// for each chunk of its work.
template <ResolverRole Role>
struct CallSource {
    using Buffers = typename detail::BuffersOf<typename Role::Calls>::Type;

    CallerId caller; ///< the interaction that makes the calls
    /// Chunks never depend on the number of threads. A deque, as references to chunks must stay valid while
    /// more are added.
    std::deque<Buffers> chunks = std::deque<Buffers>(1);
    /// Increases with every apply that makes calls or withdraws held calls.
    std::uint64_t version = 1;

    /// Call before a turn: its held calls replace those of the last one.
    void startTurn() {
        for (Buffers& chunk : chunks) {
            std::apply(
                [](auto&... buffer) {
                    (clearIf(buffer, true), ...);
                    (buffer.startTurn(), ...);
                },
                chunk);
        }
    }
    /// Removes the calls of a turn that has failed, so that it has made none. Calls of earlier turns that
    /// wait to be executed stay.
    void withdrawTurn() {
        for (Buffers& chunk : chunks) {
            std::apply([](auto&... buffer) { (buffer.withdrawTurn(), ...); }, chunk);
        }
    }
    void clearHeld() { clearWhere(true); }
    void clearOnce() { clearWhere(false); }
    /// Whether it has neither a held call nor a call that waits to be executed.
    [[nodiscard]] bool empty() const {
        return std::all_of(chunks.begin(), chunks.end(), [](Buffers const& chunk) {
            return std::apply([](auto const&... buffer) { return (buffer.calls().empty() && ...); }, chunk);
        });
    }

    void hash(StateHash& hash) const {
        for (Buffers const& chunk : chunks) {
            std::apply([&](auto const&... buffer) { (hashBuffer(buffer, hash), ...); }, chunk);
        }
    }

private:
    /// A call that a role was given later declares `static constexpr bool hashedOnlyIfMade = true`: while
    /// no interaction makes it, worlds keep the hashes that they had before there was such a call.
    template <class C>
    static void hashBuffer(CallBuffer<C> const& buffer, StateHash& hash) {
        if constexpr (requires { C::hashedOnlyIfMade; }) {
            if (buffer.calls().empty()) {
                return;
            }
            hash.value(std::string(C::text.name));
        }
        hash.members(buffer.calls());
    }
    void clearWhere(bool held) {
        for (Buffers& chunk : chunks) {
            std::apply([&](auto&... buffer) { (clearIf(buffer, held), ...); }, chunk);
        }
    }
    template <class C>
    static void clearIf(CallBuffer<C>& buffer, bool held) {
        if (isHeld(C::algebra) == held) {
            buffer.clear();
        }
    }
};

/// The caller and the cause of a call, which the resolver receives with the call.
struct CallOrigin {
    CallerId caller;
    EventId cause; ///< the event that led to the call; none without a trace
};

} // namespace trembler
