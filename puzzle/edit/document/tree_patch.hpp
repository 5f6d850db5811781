// The difference between two trees, small enough to keep one for every step of a history.
#pragma once

#include "puzzle/edit/document/command.hpp"

#include <cstddef>
#include <string>
#include <variant>
#include <vector>

namespace trembler::edit {

/// The places where two trees differ, with both values. Applied forwards and backwards any number of times it
/// gives exactly the two trees, the order of keys included.
class TreePatch {
public:
    TreePatch() = default;
    /// The changes that lead from one tree to the other. Takes time in proportion to the trees, memory to the
    /// difference. Numbers that are equal and only spelt in another way, as 1 and 1.0, are no difference:
    /// `after` gets those of `before`, so that it is exactly the result of apply().
    [[nodiscard]] static TreePatch between(Json const& before, Json& after);

    [[nodiscard]] bool empty() const { return changes_.empty(); }
    /// Turns the tree `before` into `after`, and back. The tree must be that one.
    void apply(Json& tree) const;
    void revert(Json& tree) const;
    /// Of memory, roughly.
    [[nodiscard]] std::size_t bytes() const;

private:
    using Path = std::vector<std::size_t>; // of positions, in lists and in objects
    struct Value {                         // one value is another
        Path path;
        Json before;
        Json after;
    };
    struct Entries { // of a list or an object: some entries in a row are others
        Path path;
        std::size_t first = 0;
        Json before; // a list or an object of these entries
        Json after;
    };
    using Change = std::variant<Value, Entries>;

    void compare(Path& path, Json const& before, Json& after);

    std::vector<Change> changes_;
};

} // namespace trembler::edit
