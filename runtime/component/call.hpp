// Interaction functions (5.4) as typed calls: an interaction records a call, the resolver executes it in its
// next advance. Every call states the algebra that makes the order of calls irrelevant (5.7.2).
#pragma once

#include "runtime/object/object_id.hpp"

#include <concepts>
#include <string_view>
#include <type_traits>

namespace trembler {

/// How a call combines with other calls. No algebra lets the last call win.
enum class Algebra {
    sumOfRates,   ///< held: contributions add up for as long as the interaction holds them (forces)
    sumOfAmounts, ///< once: contributions add up (impulses)
    anyOf,        ///< held: true while any call states true
    least,        ///< held: the smallest value counts
    greatest,     ///< held: the largest value counts
    countedSet, ///< once: +1 or -1 on a key, counted for each caller by itself (CallerCounts); the key is in
                ///< the set while any count is above zero
    create,     ///< once: equal keys create one object
    destroy,    ///< once: destroying twice is destroying once
    sequence,   ///< once, from outside the world only: executed in the order of the calls. They have one
                ///< caller, so their order is well defined
};

/// Held calls stay in effect until the interaction is applied again. So the forces of an interaction that
/// sleeps because its inputs do not change continue to act. Other calls are executed once.
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
/// ones, delta() for a counted set. Held sums may have magnitude() (the trace leaves out negligible calls).
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

/// Refuses a type that is no call with a message that names the missing part; InteractionCall alone would not
/// name it.
template <class C>
constexpr bool checkCall() {
    static_assert(std::is_trivially_copyable_v<C>,
                  "a call must be trivially copyable: it is recorded by copying its bytes");
    static_assert(
        requires {
            { C::text } -> std::convertible_to<CallText>;
        },
        "a call must have 'static constexpr CallText text'");
    static_assert(
        requires(C const& c) { {c.objects()}; },
        "a call must return the objects that it concerns: objects()");
    constexpr bool states = requires {
        { C::algebra } -> std::convertible_to<Algebra>;
    };
    static_assert(states, "a call must have 'static constexpr Algebra algebra', which makes the result "
                          "independent of the order of calls (5.7.2)");
    if constexpr (states) {
        constexpr Algebra a = C::algebra;
        static_assert(
            a == Algebra::sumOfRates || a == Algebra::sumOfAmounts || a == Algebra::sequence ||
                requires(C const& c) { {c.key()}; },
            "a call whose algebra is neither a sum nor a sequence must return the key by which calls are "
            "combined: key()");
        static_assert(
            a != Algebra::countedSet ||
                requires(C const& c) {
                    { c.delta() } -> std::convertible_to<int>;
                },
            "a call on a counted set must return the change of the count: delta() (5.7.2)");
        static_assert((a != Algebra::least && a != Algebra::greatest) ||
                          requires(C const& c) { {c.value()}; },
                      "a call whose algebra is least or greatest must return the compared number: value()");
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
        "calls with Algebra::sequence come from outside the world: a role with such calls must name their "
        "source in fedBy");
    return true;
}
} // namespace detail

/// The interface of a resolver to the interaction layer: `name` and `Calls`. Resolvers of one role can
/// replace each other.
template <class R>
concept ResolverRole = requires {
    { R::name } -> std::convertible_to<std::string_view>;
    requires sizeof(typename R::Calls) > 0; // instantiates the list, so that it is checked
    requires detail::checkRole<R>();
};

/// A role that is called from outside the world too: `fedBy` names the caller, for example the player, and
/// World::feed() makes the calls. Such calls are recorded, drained and ordered like those of an interaction
/// that is registered before all others.
template <class R>
concept FedFromOutside = ResolverRole<R> && requires {
    { R::fedBy } -> std::convertible_to<std::string_view>;
};

} // namespace trembler
