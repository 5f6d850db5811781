// How properties that report events (contacts that began, impacts) are gathered over a frame of several
// parts, so that an observer that reads once per frame misses none.
#pragma once

#include "runtime/property/description.hpp"

#include <concepts>
#include <string_view>

namespace trembler {

/// The place of a part in its frame.
struct PartSpan {
    bool first = true; ///< the first part of the frame in which the property was written
    double begin = 0;  ///< s after the frame's beginning
    double share = 1;  ///< its share of the frame's length
};

/// A resolver or derived property that reports not only a state but also news: events since its last update.
/// Components read it part by part. From outside, World::find() returns the news of a whole frame. For this
/// the property has
///
///     static void gather(P& frame, P const& part, PartSpan span);
///
/// It adds the news of a part to those of the frame's earlier parts, in order. For the first part `frame` has
/// its initial value. In a frame of one part it is not called.
template <class P>
concept ReportsNews = requires(P& frame, P const& part, PartSpan span) {
    P::gather(frame, part, span);
};

/// A resolver or derived property that reports a state, not events: the value of the last part is the value
/// of the frame. It states this with
///
///     static constexpr std::string_view standing = "the state, or why no part's news is lost";
template <class P>
concept ReportsState = requires {
    { P::standing } -> std::convertible_to<std::string_view>;
};

namespace detail {

/// Refuses a property that a component offers if it states neither gather() nor `standing`. One instance per
/// property, so the compiler names the property beside the message.
template <class P>
struct DeclaresNewsOrState {
    static constexpr bool value = true;
    static_assert(
        ReportsNews<P> != ReportsState<P>,
        "an offered property must have exactly one of 'static void gather(P& frame, P const& part, PartSpan "
        "span)', for news, and 'static constexpr std::string_view standing = why', for a state");
};

template <class List>
inline constexpr bool allDeclareNewsOrState = false;
template <template <class...> class List, class... P>
inline constexpr bool allDeclareNewsOrState<List<P...>> = (DeclaresNewsOrState<P>::value && ...);

template <class List>
inline constexpr bool anyReportsNews = false;
template <template <class...> class List, class... P>
inline constexpr bool anyReportsNews<List<P...>> = (ReportsNews<P> || ...);

} // namespace detail

} // namespace trembler
