#include "insight/whatif/apply.hpp"

#include "insight/whatif/moved_joints.hpp"
#include "insight/whatif/pieces.hpp"
#include "insight/whatif/settable.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <stdexcept>
#include <utility>

namespace trembler::insight {
namespace {

char const* const changedWhy = "something was changed to see what becomes of it";

/// Moves and turns all pieces of a part together, about the object's origin, and the joints that hold them to
/// the world.
void place(World& world, Change const& change) {
    Store& store = world.store();
    ObjectId const object = store.find(change.object);
    auto& positions = store.column<Position>();
    if (!positions.has(object) || !isFinite(change.at) || !std::isfinite(change.angle)) {
        return;
    }
    auto& rotations = store.column<Rotation>();
    Vec2 const from = positions[object].value;
    Rotation const* const rotation = rotations.find(object);
    double const turn = change.angle - (rotation == nullptr ? 0 : rotation->angle);
    if (from == change.at && turn == 0) {
        return;
    }
    PartMotion const motion{from, change.at, turn};
    std::vector<ObjectId> const pieces = piecesWith(store, object);
    for (ObjectId const piece : pieces) {
        if (Position const* const before = positions.find(piece)) {
            positions.set(piece, {motion.point(before->value)});
        }
        if (Rotation const* const before = rotations.find(piece); before != nullptr && turn != 0) {
            rotations.set(piece, {piece == object ? change.angle : before->angle + turn});
        }
    }
    moveJoints(store, pieces, motion);
}

void feed(LevelRun& run, Change const& change, int hand) {
    Store const& store = run.world().store();
    ObjectId const object = store.find(change.object);
    if (!object.valid()) {
        return;
    }
    using Kind = PlayerInput::Kind;
    if (change.kind == Change::Kind::remove) {
        for (ObjectId const piece : piecesWith(store, object)) {
            run.feed({Kind::remove, piece, {}, {}});
        }
    } else if (change.kind == Change::Kind::cut) {
        if (ObjectId const other = store.find(change.other); other.valid()) {
            run.feed({Kind::cut, object, other, {}});
        }
    } else {
        run.feed({Kind::grab, object, {}, change.at, static_cast<std::uint8_t>(hand)});
    }
}

void leaveOut(World& world, std::string const& interaction) {
    try {
        world.setPeriod(interaction, 0);
    } catch (std::invalid_argument const&) { // no interaction has that title
    }
}

/// The grab of a what-if, which has one at most, or nullptr.
Change const* grabOf(WhatIf const& whatIf) {
    auto const at = std::find_if(whatIf.changes.begin(), whatIf.changes.end(),
                                 [](Change const& change) { return change.kind == Change::Kind::grab; });
    return at == whatIf.changes.end() ? nullptr : &*at;
}

/// The frame in which it lets go.
std::uint64_t endOf(Change const& grab, WhatIf const& whatIf) {
    return whatIf.frame + 1 + std::max<std::uint64_t>(grab.frames, 1);
}

bool isOfHand(RecordedInput const& input) {
    return input.kind == PlayerInput::Kind::grab || input.kind == PlayerInput::Kind::move ||
           input.kind == PlayerInput::Kind::release;
}

} // namespace

int handOfGrab(std::span<RecordedInput const> inputs, WhatIf const& whatIf) {
    Change const* const grab = grabOf(whatIf);
    if (grab == nullptr) {
        return 1;
    }
    std::array<bool, 2> holds{};             // at the moment
    std::array<bool, 2> resting{true, true}; // later, as long as the grab lasts
    for (RecordedInput const& input : inputs) {
        if (!isOfHand(input) || input.frame > endOf(*grab, whatIf)) {
            continue;
        }
        std::size_t const hand = input.hand == 1 ? 1 : 0;
        if (input.frame <= whatIf.frame) {
            holds[hand] = input.kind == PlayerInput::Kind::grab ||
                          (input.kind == PlayerInput::Kind::move && holds[hand]);
        } else {
            resting[hand] = resting[hand] && input.kind != PlayerInput::Kind::grab;
        }
    }
    for (bool const throughout : {true, false}) {
        for (std::size_t const hand : {std::size_t{1}, std::size_t{0}}) {
            if (!holds[hand] && (resting[hand] || !throughout)) {
                return static_cast<int>(hand);
            }
        }
    }
    return 1;
}

void apply(Registry const& registry, LevelRun& run, WhatIf const& whatIf, int hand) {
    run.alter(changedWhy, [&](World& world) {
        for (Change const& change : whatIf.changes) {
            if (change.kind == Change::Kind::place) {
                place(world, change);
            } else if (change.kind == Change::Kind::field) {
                setField(world, registry.rules(), world.store().find(change.object), change.property,
                         change.field, change.amount);
            } else if (change.kind == Change::Kind::interaction) {
                leaveOut(world, change.object);
            }
        }
    });
    for (Change const& change : whatIf.changes) {
        if (change.kind == Change::Kind::remove || change.kind == Change::Kind::cut ||
            change.kind == Change::Kind::grab) {
            feed(run, change, hand);
        }
    }
}

std::vector<RecordedInput> inputsOfGrabs(WhatIf const& whatIf, int hand) {
    Change const* const grab = grabOf(whatIf);
    if (grab == nullptr) {
        return {};
    }
    RecordedInput move;
    move.kind = PlayerInput::Kind::move;
    move.object = grab->object;
    move.at = grab->to;
    move.hand = hand;
    move.frame = whatIf.frame + 2;
    RecordedInput release = move;
    release.kind = PlayerInput::Kind::release;
    release.frame = endOf(*grab, whatIf);
    return {move, release};
}

std::vector<RecordedInput> inputsLeft(std::span<RecordedInput const> inputs, WhatIf const& whatIf, int hand) {
    std::set<std::size_t> gone;
    for (Change const& change : whatIf.changes) {
        if (change.kind == Change::Kind::input && change.index < inputs.size() &&
            inputs[change.index].frame > whatIf.frame) {
            gone.insert(change.index);
        }
    }
    Change const* const grab = grabOf(whatIf);
    std::vector<RecordedInput> left;
    std::array<bool, 2> without{}; // hands whose grab is left out
    bool taken = false;            // the hand has been needed for the grab of the what-if
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        RecordedInput const& input = inputs[i];
        bool const own = grab != nullptr && isOfHand(input) && input.hand == hand;
        if (own && input.frame > whatIf.frame && !std::exchange(taken, true)) {
            without[hand == 1 ? 1 : 0] = true; // what it held, it let go of
        }
        bool const during = own && input.frame > whatIf.frame && input.frame <= endOf(*grab, whatIf);
        bool& released = without[input.hand == 1 ? 1 : 0];
        if (input.kind == PlayerInput::Kind::grab) {
            released = during || gone.count(i) > 0;
        }
        if (gone.count(i) == 0 && !(isOfHand(input) && released)) {
            left.push_back(input);
        }
    }
    return left;
}

} // namespace trembler::insight
