// What a frame in several parts makes of a property that tells what happened: whoever looks once a frame is
// told of all of its parts.
#pragma once

#include "runtime/property/description.hpp"

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

} // namespace trembler
