// The parts that the player has placed: the list, its undo and redo, and the remaining parts of the toolbox.
#pragma once

#include "puzzle/session/history.hpp"
#include "runtime/level/model/level.hpp"
#include "runtime/level/model/part_library.hpp"
#include "runtime/world/world.hpp"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace trembler {

/// A part that the player placed. The number identifies it for the session's life, through undo and redo.
struct PlacedPart {
    int number = 0;
    Placement placement;
};

/// One compartment of the toolbox.
struct ToolboxSlot {
    std::string part;
    int total = 0; ///< may be unlimitedCount, as `left` is then
    int left = 0;
};

/// Whether a part may be placed somewhere; if not, why, in words for the player.
struct Verdict {
    bool ok = true;
    std::string why;
};

/// An edit has two steps: with(), moved(), without() and those() return the edited list, and keep() makes it
/// the current one. In between, the caller checks that a world can be built from the list. Not thread-safe.
class Placements {
public:
    using List = std::vector<PlacedPart>;

    /// Both must outlive it.
    Placements(LevelFile const& level, PartLibrary const& parts);

    [[nodiscard]] List const& now() const { return history_.now(); }
    /// The place of a part in now(); nothing if it is not placed.
    [[nodiscard]] std::optional<std::size_t> indexOf(int number) const;
    [[nodiscard]] std::vector<ToolboxSlot> toolbox() const;

    /// Whether a part may be placed there: the level must allow it, it must lie wholly in the areas for
    /// placing (whyItSticksOut()), and it must not overlap anything in `world`, which was built from now().
    /// If a placed part is being moved there, `moved` is its number and `ignored` are its objects, which are
    /// not checked for overlap.
    [[nodiscard]] Verdict check(Placement const& placement, World const& world, std::optional<int> moved = {},
                                std::span<ObjectId const> ignored = {}) const;

    /// now() with one more part at the end, with a new number.
    [[nodiscard]] List with(Placement placement);
    /// The same with several more.
    [[nodiscard]] List withAll(std::span<Placement const> added);
    /// now() with that part at another place (m, rad), mirrored or not, or as it was if that is not stated;
    /// nothing if it is not placed.
    [[nodiscard]] std::optional<List> moved(int number, Vec2 at, double angle,
                                            std::optional<bool> flipped = {}) const;
    /// now() without that part; nothing if it is not placed.
    [[nodiscard]] std::optional<List> without(int number) const;
    /// The solution's placements only, with new numbers. Throws InputError, with their places in the file, if
    /// the level does not allow them. The centres of parts count, see whyItSticksOut().
    [[nodiscard]] List those(Solution const& solution);

    /// Makes `next` the current list; undo() returns to the previous one.
    void keep(List next) { history_.change(std::move(next)); }
    /// Forgets the oldest lists beyond `most` that undo() can return to.
    void forgetBefore(std::size_t most) { history_.forgetBefore(most); }
    [[nodiscard]] bool canUndo() const { return history_.canUndo(); }
    [[nodiscard]] bool canRedo() const { return history_.canRedo(); }
    bool undo() { return history_.undo(); }
    bool redo() { return history_.redo(); }

private:
    LevelFile const& level_;
    PartLibrary const& parts_;
    History<List> history_;
    int nextNumber_ = 1;
};

/// The placements of a list, in its order.
[[nodiscard]] std::vector<Placement> placementsOf(Placements::List const& placed);

} // namespace trembler
