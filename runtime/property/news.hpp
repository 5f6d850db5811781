// What a frame in several parts makes of a property that tells what happened: whoever looks once a frame is
// told of all of its parts.
#pragma once

#include "runtime/property/description.hpp"

#include <concepts>
#include <string_view>

namespace trembler {

/// Where a part lies in its frame.
struct PartSpan {
    bool first = true; ///< the first part of the frame that has something to tell
    double begin = 0;  ///< s after the frame's beginning
    double share = 1;  ///< its share of the frame's length
};

/// A resolver or derived property that tells what happened since its last update, and not only how things
/// stand. Components read it part by part. From outside, World::find() shows what this makes of a frame:
///
///     static void gather(P& frame, P const& part, PartSpan span);
///
/// adds what a part tells to what the frame's earlier parts told, in order; in the first, `frame` is
/// as new. A frame of one part is not gathered.
template <class P>
concept TellsNews = requires(P& frame, P const& part, PartSpan span) {
    P::gather(frame, part, span);
};

/// A resolver or derived property of which the last part's value is the frame's, as it tells how things
/// stand:
///
///     static constexpr std::string_view standing = "what stands, or why no part's news is lost";
template <class P>
concept TellsWhatStands = requires {
    { P::standing } -> std::convertible_to<std::string_view>;
};

namespace detail {

/// Refuses a property that a component offers if it does not say what a frame makes of its parts. One
/// instance per property, so the compiler names the property beside the message.
template <class P>
struct SaysWhatAFrameMakes {
    static constexpr bool value = true;
    static_assert(
        TellsNews<P> != TellsWhatStands<P>,
        "a property that is offered either tells news, 'static void gather(P& frame, P const& part, "
        "PartSpan span)', or what stands, 'static constexpr std::string_view standing = why'");
};

template <class List>
inline constexpr bool allSayWhatAFrameMakes = false;
template <template <class...> class List, class... P>
inline constexpr bool allSayWhatAFrameMakes<List<P...>> = (SaysWhatAFrameMakes<P>::value && ...);

template <class List>
inline constexpr bool anyTellsNews = false;
template <template <class...> class List, class... P>
inline constexpr bool anyTellsNews<List<P...>> = (TellsNews<P> || ...);

} // namespace detail

} // namespace trembler
