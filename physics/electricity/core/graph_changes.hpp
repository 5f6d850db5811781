// The changes of the electricity graph, for derived property sets that depend on it.
#pragma once

#include "runtime/object/object_id.hpp"
#include "runtime/property/coverage.hpp"
#include "runtime/property/description.hpp"
#include "runtime/trace/event.hpp"

#include <cstdint>
#include <vector>

namespace trembler {

/// A numbered journal of changes, so that a reader that does not run in every frame, or was just constructed,
/// can find the changes that it missed.
struct GraphChanges {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Changes of G_E", "graph_changes",
        "The vertices of the electricity graph that recently gained or lost a connection, appeared, "
        "disappeared or changed their part in a network."};
    static constexpr std::string_view standing =
        "a numbered journal, from which each reader takes the entries that it has missed";
    static constexpr Coverage coverage = leftOut(
        "a journal of changes of G_E, only to save work: a reader that missed entries reads all of G_E, "
        "with the same result");
    struct Touched {
        ObjectId object;          ///< may no longer exist
        EventId event;            ///< "connected" or "disconnected"; none without tracing
        std::uint64_t number = 0; ///< of the change
    };
    std::uint64_t number = 0; ///< of the latest change; increases with every advance that changed the graph
    std::uint64_t forgotten = 0;  ///< the journal has only the changes with a higher number
    std::vector<Touched> journal; ///< ascending by number

    /// Whether the journal contains all changes after `seen`, the number of the latest change that a reader
    /// has read. If not, any part of the graph may have changed.
    [[nodiscard]] bool remembers(std::uint64_t seen) const { return seen >= forgotten && seen <= number; }
};

} // namespace trembler
