// Interaction functions (5.4) as typed calls: an interaction records a call, the resolver carries it out in
// its next advance. Every call states the algebra that makes the order of calls irrelevant (5.7.2).
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/object/object_id.hpp"
#include "runtime/property/state_hash.hpp"
#include "runtime/trace/event.hpp"

#include <algorithm>
#include <concepts>
#include <cstdint>
#include <deque>
#include <memory>
#include <span>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace trembler {

/// What a call does to those beside it. There is none in which the last writer wins.
enum class Algebra {
    sumOfRates,   ///< held: contributions add up for as long as the interaction stands by them (forces)
    sumOfAmounts, ///< once: contributions add up (impulses)
    anyOf,        ///< held: true while anybody says so
    least,        ///< held: the smallest value counts
    greatest,     ///< held: the largest value counts
    countedSet, ///< once: +1 or -1 on a key, counted for each caller by itself (CallerCounts); the key is in
                ///< the set while any count is above zero
    create,     ///< once: equal keys create one object
    destroy,    ///< once: destroying twice is destroying once
    sequence,   ///< once, from outside the world only: carried out in the order in which they came. There is
                ///< one who calls, so there is no other order that could matter
};

/// Held calls stand until the interaction is applied again, so one whose inputs did not change can sleep and
/// still pull. The others are carried out once.
[[nodiscard]] constexpr bool isHeld(Algebra a) {
    return a == Algebra::sumOfRates || a == Algebra::anyOf || a == Algebra::least || a == Algebra::greatest;
}
[[nodiscard]] std::string_view nameOf(Algebra a);

struct CallText {
    std::string_view name;
    std::string_view arguments;
    std::string_view meaning;
};

/// A call: plain data with `text`, `algebra` and objects(), plus what its algebra needs: key() for the keyed
/// ones, delta() for a counted set. Held sums may have magnitude() (the trace leaves out the negligible).
template <class C>
concept InteractionCall = std::is_trivially_copyable_v<C> && requires(C const& c) {
    { C::text } -> std::convertible_to<CallText>;
    { C::algebra } -> std::convertible_to<Algebra>;
    {c.objects()};
} &&(C::algebra == Algebra::sumOfRates || C::algebra == Algebra::sumOfAmounts ||
     C::algebra == Algebra::sequence || requires(C const& c) { {c.key()}; }) &&
    (C::algebra != Algebra::countedSet ||
     requires(C const& c) {
         { c.delta() } -> std::convertible_to<int>;
     }) &&
    ((C::algebra != Algebra::least && C::algebra != Algebra::greatest) ||
     requires(C const& c) { {c.value()}; });

namespace detail {

/// Says in words what a call lacks; InteractionCall alone would only say that it is none.
template <class C>
constexpr bool checkCall() {
    static_assert(std::is_trivially_copyable_v<C>,
                  "a call is plain data: it is recorded by copying its bytes");
    static_assert(
        requires {
            { C::text } -> std::convertible_to<CallText>;
        },
        "a call has its words: CallText text");
    static_assert(
        requires(C const& c) { {c.objects()}; }, "a call says which objects it is about: objects()");
    constexpr bool states = requires {
        { C::algebra } -> std::convertible_to<Algebra>;
    };
    static_assert(states, "a call states its algebra, by which the order of calls does not matter (5.7.2)");
    if constexpr (states) {
        constexpr Algebra a = C::algebra;
        static_assert(
            a == Algebra::sumOfRates || a == Algebra::sumOfAmounts || a == Algebra::sequence ||
                requires(C const& c) { {c.key()}; },
            "a call whose algebra is not a sum says what it is about: key()");
        static_assert(
            a != Algebra::countedSet ||
                requires(C const& c) {
                    { c.delta() } -> std::convertible_to<int>;
                },
            "a call on a counted set says whether it adds or takes away: delta() (5.7.2)");
        static_assert((a != Algebra::least && a != Algebra::greatest) ||
                          requires(C const& c) { {c.value()}; },
                      "a call of which the least or the greatest counts has a value()");
    }
    return true;
}

} // namespace detail

/// The interaction functions of a role.
template <class... C>
struct CallList {
    static_assert((detail::checkCall<C>() && ...));
};

namespace detail {
template <class List>
inline constexpr bool anySequence = false;
template <class... C>
inline constexpr bool anySequence<CallList<C...>> = ((C::algebra == Algebra::sequence) || ...);

template <class R>
constexpr bool checkRole() {
    static_assert(
        !anySequence<typename R::Calls> ||
            requires {
                { R::fedBy } -> std::convertible_to<std::string_view>;
            },
        "calls in sequence come from outside the world: a role with such calls says who feeds it, fedBy");
    return true;
}
} // namespace detail

/// The interface of a resolver to the interaction layer: `name` and `Calls`. Resolvers of one role swap.
template <class R>
concept ResolverRole = requires {
    { R::name } -> std::convertible_to<std::string_view>;
    requires sizeof(typename R::Calls) > 0; // looks into the list, so that it is checked
    requires detail::checkRole<R>();
};

/// A role that is called from outside the world too, as by the player: `fedBy` names who does, and
/// World::feed() is the way in. Such calls are recorded, drained and ordered like those of an interaction
/// that is registered before all others.
template <class R>
concept FedFromOutside = ResolverRole<R> && requires {
    { R::fedBy } -> std::convertible_to<std::string_view>;
};

/// The calls of one kind by one chunk of one interaction. Written by one thread at a time; no locks.
template <InteractionCall C>
class CallBuffer {
public:
    void push(C const& call) { calls_.push_back(call); }
    /// Of the call that was pushed last. There must be one.
    void setCauseOfLast(EventId cause) {
        causes_.resize(calls_.size());
        causes_.back() = cause;
    }
    void clear() {
        calls_.clear();
        causes_.clear();
    }
    [[nodiscard]] std::span<C const> calls() const { return calls_; }
    [[nodiscard]] EventId cause(std::size_t i) const { return i < causes_.size() ? causes_[i] : EventId{}; }

private:
    std::vector<C> calls_;
    std::vector<EventId> causes_; // shorter than calls_ while nobody traces
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

/// All that one interaction has said to its resolver, by chunk of its work.
template <ResolverRole Role>
struct CallSource {
    using Buffers = typename detail::BuffersOf<typename Role::Calls>::Type;

    CallerId caller; ///< whose calls they are
    /// Chunks never depend on the number of threads. A deque, as callers hold on to theirs while more are
    /// added.
    std::deque<Buffers> chunks = std::deque<Buffers>(1);
    std::uint64_t version = 1; ///< counts up with every apply, but for those that say nothing after nothing

    void clearHeld() { clearWhere(true); }
    void clearOnce() { clearWhere(false); }
    /// Whether no call stands or waits.
    [[nodiscard]] bool empty() const {
        return std::all_of(chunks.begin(), chunks.end(), [](Buffers const& chunk) {
            return std::apply([](auto const&... buffer) { return (buffer.calls().empty() && ...); }, chunk);
        });
    }

    void hash(StateHash& hash) const {
        for (Buffers const& chunk : chunks) {
            std::apply([&](auto const&... buffer) { (hash.members(buffer.calls()), ...); }, chunk);
        }
    }

private:
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

/// Who calls, told to the resolver beside each call.
struct CallOrigin {
    CallerId caller;
    EventId cause; ///< what made it call; none while nobody traces
};

class ChannelBase {
public:
    virtual ~ChannelBase() = default;
    [[nodiscard]] virtual std::uint64_t version() const = 0;
    virtual void clearOnce() = 0;
    virtual void clearSources() = 0;
};

/// What connects the interactions of one role to its resolver: their sources in registration order, which is
/// the order in which calls are drained. What is fed from outside comes before them.
template <ResolverRole Role>
class Channel final : public ChannelBase {
public:
    void add(CallSource<Role>* source) {
        sources_.push_back(source);
        callers_.push_back(source->caller);
        ++changes_;
    }
    /// Says that there is a resolver, which takes what is fed.
    void attachResolver() { resolverThere_ = true; }
    void clearSources() override {
        sources_.clear();
        callers_.clear();
        resolverThere_ = false;
        ++changes_;
        if (outside_) {
            add(outside_.get());
        }
    }
    [[nodiscard]] std::span<CallSource<Role>* const> sources() const { return sources_; }
    /// Who may call at present: ascending if they were added in registration order.
    [[nodiscard]] std::span<CallerId const> callers() const { return callers_; }

    /// Opens the way in for whoever is outside, under that identity. Once, before any source is added.
    void openToOutside(CallerId caller) requires FedFromOutside<Role> {
        outside_ = std::make_unique<CallSource<Role>>();
        outside_->caller = caller;
        add(outside_.get());
    }
    /// Records a call from outside for the next advance. Between frames only. Without a resolver, or if the
    /// way in is not open, it is lost.
    template <InteractionCall C>
    void feed(C const& call) requires FedFromOutside<Role> {
        static_assert(detail::callListed<C, typename Role::Calls>, "not a call of this role");
        if (resolverThere_ && outside_) {
            std::get<CallBuffer<C>>(outside_->chunks.front()).push(call);
            ++outside_->version;
        }
    }
    /// Whether any call stands or waits.
    [[nodiscard]] bool empty() const {
        return std::all_of(sources_.begin(), sources_.end(),
                           [](CallSource<Role> const* source) { return source->empty(); });
    }

    /// Differs whenever any source has said anything, or taken anything back, or the set of sources is
    /// another one. The two must not be added up: a source that goes takes its count along, and the sum could
    /// come out as before.
    [[nodiscard]] std::uint64_t version() const override {
        std::uint64_t sum = changes_ << 40U;
        for (CallSource<Role> const* source : sources_) {
            sum += source->version;
        }
        return sum;
    }
    void clearOnce() override {
        for (CallSource<Role>* source : sources_) {
            source->clearOnce();
        }
    }
    /// Hashes every call that stands or waits, by who makes it, whatever the order of registration.
    void hash(StateHash& hash) const {
        std::vector<CallSource<Role> const*> sorted(sources_.begin(), sources_.end());
        std::sort(sorted.begin(), sorted.end(),
                  [](auto const* a, auto const* b) { return a->caller.name() < b->caller.name(); });
        for (CallSource<Role> const* source : sorted) {
            if (!source->empty()) {
                hash.value(std::string(source->caller.name()));
                source->hash(hash);
            }
        }
    }
    /// Calls f(call, origin) for every call of kind C, in drain order.
    template <InteractionCall C, class F>
    void forCalls(F&& f) const {
        for (CallSource<Role> const* source : sources_) {
            CallerId const caller = source->caller;
            for (auto const& chunk : source->chunks) {
                auto const& buffer = std::get<CallBuffer<C>>(chunk);
                std::span<C const> const calls = buffer.calls();
                for (std::size_t i = 0; i < calls.size(); ++i) {
                    f(calls[i], CallOrigin{caller, buffer.cause(i)});
                }
            }
        }
    }

private:
    std::vector<CallSource<Role>*> sources_;
    std::vector<CallerId> callers_; // theirs
    std::unique_ptr<CallSource<Role>> outside_;
    bool resolverThere_ = false;
    std::uint64_t changes_ = 1;
};

} // namespace trembler
