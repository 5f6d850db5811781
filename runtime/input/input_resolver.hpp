// The player's hand and commands, as resolver properties that other components read.
#pragma once

#include "runtime/component/resolver.hpp"
#include "runtime/input/player_input.hpp"
#include "runtime/placement.hpp"
#include "runtime/property/news.hpp"

#include <vector>

namespace trembler {

/// The object in the player's hand.
struct Hand {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Hand", "hand", "The object that the player holds, and the point to which it is pulled."};
    static constexpr Coverage coverage = hashed;
    static constexpr std::string_view standing = "the held object, and the point to which it is pulled";

    ObjectId object; ///< invalid: the hand is empty
    Vec2 localPoint; ///< m, the point where it is held, in the object's own frame
    Vec2 target;     ///< m, in the world
    EventId event;   ///< the grab

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "held object"}, self.object);
        visit(FieldInfo{.key = "local_point", .unit = "m", .meaning = "held point, in the object's frame"},
              self.localPoint);
        visit(FieldInfo{.key = "target", .unit = "m", .meaning = "point to which it is pulled"}, self.target);
    }
};

/// The object in the player's second hand, which may be that of another player. It is a property of its own,
/// so that runs with one hand have the same hashes as before there were two.
struct SecondHand {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{"Second hand", "second_hand",
                                       "The object that the second hand holds, and the point to which it is "
                                       "pulled."};
    static constexpr Coverage coverage = leftOut("the player hashes it while the hand holds something");
    static constexpr std::string_view standing = "the held object, and the point to which it is pulled";

    Hand grip;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        Hand::describe(self.grip, visit);
    }
};

/// The player's commands (cut, remove) since the last frame, present in the first part of a frame.
struct PlayerCommands {
    static constexpr PropertyKind kind = PropertyKind::resolver;
    static constexpr PropertyText text{
        "Player commands", "player_commands",
        "Wires that the player cut and objects that the player removed in this frame."};
    static constexpr Coverage coverage = hashed;
    struct Cut {
        ObjectId a;
        ObjectId b;
        EventId event;
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "a", .unit = "", .meaning = "one end of the wire"}, self.a);
            visit(FieldInfo{.key = "b", .unit = "", .meaning = "its other end"}, self.b);
        }
    };
    struct Removal {
        ObjectId object;
        EventId event;
        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            visit(FieldInfo{.key = "object", .unit = "", .meaning = "that was removed"}, self.object);
        }
    };
    std::vector<Cut> cuts;
    std::vector<Removal> removals;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "cuts", .unit = "", .meaning = "wires that were cut"}, self.cuts);
        visit(FieldInfo{.key = "removals", .unit = "", .meaning = "objects that were removed"},
              self.removals);
    }

    static void gather(PlayerCommands& frame, PlayerCommands const& part, PartSpan) {
        frame.cuts.insert(frame.cuts.end(), part.cuts.begin(), part.cuts.end());
        frame.removals.insert(frame.removals.end(), part.removals.begin(), part.removals.end());
    }
};

/// Executes the input that was fed since the last frame.
class InputResolver final : public Resolver<InputResolver, PlayerRole, Reads<Position, Rotation>, Writes<>,
                                            Provides<Hand, SecondHand, PlayerCommands>> {
public:
    static constexpr ComponentText text{
        .name = "Player",
        .effect = "player",
        .level = "",
        .work = "Applies the player's inputs since the last frame: the held object, the point to which it is "
                "pulled, cut wires and removed objects."};
    using Activation = NeedsAll<>;

    [[nodiscard]] bool restless() const { return isCalled() || commandsStand_; }
    /// Only fed input gives it work: the hand does not depend on how objects move.
    [[nodiscard]] bool hasWork() const override { return restless(); }
    void advance(Access& access);
    /// The second hand, while it holds something. Whether there are Player commands follows from these.
    void hashMemory(StateHash& hash) const {
        if (second_.object.valid()) {
            hash.value(second_);
        }
    }

private:
    void useHand(Access& access, PlayerInput const& input);

    Hand second_;                // as provided
    bool commandsStand_ = false; // PlayerCommands still has the commands of the last turn, to be cleared
};

} // namespace trembler
