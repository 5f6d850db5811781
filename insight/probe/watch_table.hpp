// Writes watched fields over time as a table.
#pragma once

#include "insight/probe/watch.hpp"

#include <cstdint>
#include <iosfwd>
#include <span>
#include <string>
#include <vector>

namespace trembler::watch {

/// The first line of a table: frame, time, and a column for each number.
[[nodiscard]] std::string csvHeader(std::span<Watch const> watches);
/// A row, without its end.
[[nodiscard]] std::string csvRow(std::uint64_t frame, std::span<Cell const> cells);

/// Rows of comma-separated values (RFC 4180): frame, time in s, and a column per number. The first line names
/// the columns with their units; an unknown value is an empty cell. Numbers have as many digits as are needed
/// to read them back exactly. While the table lives, watched derived properties are computed even if nothing
/// else reads them; nothing else in the run changes. The registry must outlive it. Not thread-safe.
class WatchTable {
public:
    /// Writes the first line. `what` lists "OBJECT.FIELD" texts; throws as find() does. `world` must be at
    /// its start. `every`, at least 1, is the number of frames between rows.
    WatchTable(Registry const& registry, World const& world, std::vector<std::string> const& what,
               std::uint64_t every, std::ostream& out);
    /// Call at the start and after every frame: writes a row if one is due.
    void look(World const& world);
    /// A sentence for each watch that had no value in any row so far, with the detail levels that compute it
    /// if the present one does not.
    [[nodiscard]] std::vector<std::string> withoutValue(World const& world) const;

private:
    [[nodiscard]] std::string whyEmpty(World const& world, PropertyInfo const& property) const;

    Registry const& registry_;
    std::vector<Watch> watches_;
    std::vector<bool> filled_; // for each watch: whether it had a value
    std::vector<Subscription> subscriptions_;
    std::uint64_t every_;
    std::ostream& out_;
};

} // namespace trembler::watch
