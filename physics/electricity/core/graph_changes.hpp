// The changes of the electricity graph, for derived property sets that follow from it.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <vector>

namespace trembler {

/// A journal of changes, numbered, so that a reader that does not run in every frame, or has just been
/// swapped in, knows which changes it missed.
struct GraphChanges {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Changes of G_E", "graph_changes",
        "The vertices of the electricity graph that lately gained or lost a "
        "connection, appeared, disappeared or changed their part in a network."};
    static constexpr std::string_view standing =
        "a numbered journal, from which each reader takes what it has missed";
    static constexpr Coverage coverage = leftOut(
        "a journal of changes of G_E, only to save work: a reader that missed entries reads all of G_E, "
        "with the same result");
    struct Touched {
        ObjectId object;          ///< may be gone
        EventId event;            ///< "connected" or "disconnected"; none without tracing
        std::uint64_t number = 0; ///< of the change
    };
    std::uint64_t number = 0;    ///< of the latest change; counts up with every advance that changed anything
    std::uint64_t forgotten = 0; ///< the journal has only the changes with a higher number
    std::vector<Touched> journal; ///< ascending by number

    /// Whether `seen`, the number of the latest change that a reader knows, is recent enough for the journal
    /// to have all later ones. If not, anything may have changed.
    [[nodiscard]] bool remembers(std::uint64_t seen) const { return seen >= forgotten && seen <= number; }
};

} // namespace trembler
