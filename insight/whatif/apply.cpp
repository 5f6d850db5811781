#include "insight/whatif/apply.hpp"

#include "insight/whatif/moved_joints.hpp"
#include "insight/whatif/pieces.hpp"
#include "insight/whatif/settable.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace trembler::insight {
namespace {

char const* const changedWhy = "something was changed to see what becomes of it";

/// Moves and turns all pieces of a part together, about the object's origin, and what holds them to the world.
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

void feed(LevelRun& run, Change const& change) {
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
        run.feed({Kind::grab, object, {}, change.at, static_cast<std::uint8_t>(1)});
    }
}

void leaveOut(World& world, std::string const& interaction) {
    try {
        world.setPeriod(interaction, 0);
    } catch (std::invalid_argument const&) { // there is none of that title
    }
}

} // namespace

void apply(Registry const& registry, LevelRun& run, WhatIf const& whatIf) {
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
            feed(run, change);
        }
    }
}

std::vector<RecordedInput> inputsOfGrabs(WhatIf const& whatIf) {
    std::vector<RecordedInput> all;
    for (Change const& change : whatIf.changes) {
        if (change.kind != Change::Kind::grab) {
            continue;
        }
        RecordedInput input;
        input.object = change.object;
        input.at = change.to;
        input.hand = 1;
        input.kind = PlayerInput::Kind::move;
        input.frame = whatIf.frame + 2;
        all.push_back(input);
        input.kind = PlayerInput::Kind::release;
        input.frame = whatIf.frame + 1 + std::max<std::uint64_t>(change.frames, 1);
        all.push_back(input);
    }
    return all;
}

std::vector<RecordedInput> inputsLeft(std::span<RecordedInput const> inputs, WhatIf const& whatIf) {
    std::set<std::size_t> gone;
    for (Change const& change : whatIf.changes) {
        if (change.kind == Change::Kind::input && change.index < inputs.size() &&
            inputs[change.index].frame > whatIf.frame) {
            gone.insert(change.index);
        }
    }
    std::vector<RecordedInput> left;
    bool released[2] = {false, false}; // hands whose grab is left out
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        RecordedInput const& input = inputs[i];
        bool const ofHand = input.kind == PlayerInput::Kind::grab || input.kind == PlayerInput::Kind::move ||
                            input.kind == PlayerInput::Kind::release;
        bool& without = released[input.hand == 1 ? 1 : 0];
        if (input.kind == PlayerInput::Kind::grab) {
            without = gone.count(i) > 0;
        }
        if (gone.count(i) == 0 && !(ofHand && without)) {
            left.push_back(input);
        }
    }
    return left;
}

} // namespace trembler::insight
