#include "physics/dynamics/properties/contacts.hpp"

#include <algorithm>
#include <iterator>

namespace trembler {
namespace {

using Pairs = std::vector<TouchingPair>;

Pairs both(Pairs const& a, Pairs const& b) {
    Pairs all;
    std::set_union(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(all));
    return all;
}
Pairs without(Pairs const& a, Pairs const& b) {
    Pairs rest;
    std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(rest));
    return rest;
}

} // namespace

void Contacts::gather(Contacts& frame, Contacts const& part, PartSpan span) {
    if (span.first) {
        frame = part;
        return;
    }
    // The pairs that touched at the frame's beginning, with the events with which these contacts began or
    // ended, and the pairs that have touched at any time since.
    Pairs const ended = both(frame.ended, part.ended);
    Pairs const begun = both(frame.begun, part.begun);
    Pairs const atFirst = both(without(frame.current, frame.begun), frame.ended);
    Pairs const since = both(both(frame.brief, part.brief), begun);
    frame.current = part.current;
    frame.begun = without(part.current, atFirst);
    frame.ended.clear();
    std::set_intersection(ended.begin(), ended.end(), atFirst.begin(), atFirst.end(),
                          std::back_inserter(frame.ended));
    frame.ended = without(frame.ended, part.current);
    frame.brief = without(without(since, atFirst), part.current);
}

} // namespace trembler
