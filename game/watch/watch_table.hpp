// Watched fields over time, as a table.
#pragma once

#include "game/watch/watch.hpp"

#include <cstdint>
#include <iosfwd>
#include <string>
#include <vector>

namespace trembler::watch {

/// Rows of comma-separated values (RFC 4180): frame, time in s, and a column per number. The first line names
/// the columns with their units; what is not known is an empty cell. Numbers have as many digits as tell them
/// apart. What is watched is computed, for as long as the table lives, even if nobody else reads it, and that
/// changes nothing else. Not thread-safe.
class WatchTable {
public:
    /// Writes the first line. `what` are "OBJECT.FIELD"; see find(), which throws. `world` must be at its
    /// start. `every` is at least 1: frames between rows.
    WatchTable(Registry const& registry, World const& world, std::vector<std::string> const& what,
               std::uint64_t every, std::ostream& out);
    /// To be called at the start and after every frame: writes a row if it is its turn.
    void look(World const& world);

private:
    std::vector<Watch> watches_;
    std::vector<Subscription> subscriptions_;
    std::uint64_t every_;
    std::ostream& out_;
};

} // namespace trembler::watch
