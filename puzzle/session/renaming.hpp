// The new names of placed objects, which are numbered in the order of places, when the placements change.
#pragma once

#include "runtime/level/model/level.hpp"

#include <map>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// Names of placed objects and of pieces of them: pieces of composite parts follow their part, as "scale 2
/// pan".
class Renaming {
public:
    /// All names stay.
    Renaming() = default;
    /// `own`: the names of the level's own objects, which keep them.
    explicit Renaming(std::set<std::string> own) : own_(std::move(own)) {}

    /// A placed object's name before and now; "" now: it is gone.
    void add(std::string const& before, std::string const& now);
    /// Whether no name changes.
    [[nodiscard]] bool empty() const { return names_.empty(); }

    /// The new name of an object or of a piece of it, "" if it is gone; nullopt if the name stays.
    [[nodiscard]] std::optional<std::string> newName(std::string const& before) const;
    /// The inverse; nullopt if the name has not changed.
    [[nodiscard]] std::optional<std::string> oldName(std::string const& now) const;

private:
    std::map<std::string, std::string> names_; // of those whose names differ
    std::set<std::string> own_;
};

/// Names in the order in which placements are stated; `sorted`: in that of canonicalOrder(), as
/// placementNames() returns them.
[[nodiscard]] std::vector<std::string> namesAsStated(std::span<Placement const> placements,
                                                     std::vector<std::string> const& sorted);

} // namespace trembler
