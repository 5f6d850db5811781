#include "insight/timeline/recorded_properties.hpp"

#include "audio/effect/properties/loudness.hpp"
#include "audio/effect/properties/sounds.hpp"
#include "insight/timeline/field_words.hpp"
#include "physics/buoyancy/properties/liquid_resistance.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/dynamics/properties/body.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "physics/dynamics/properties/engine_state.hpp"
#include "physics/dynamics/properties/force_lag.hpp"
#include "physics/dynamics/properties/force_rates.hpp"
#include "physics/dynamics/properties/impacts.hpp"
#include "physics/dynamics/properties/motion_causes.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/quantities.hpp"
#include "physics/electricity/properties/ratings.hpp"
#include "physics/gravity/properties.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/input/input_resolver.hpp"
#include "runtime/placement.hpp"

#include <algorithm>

namespace trembler::insight {
namespace {

/// The sounds without the data that only loudspeakers need: modes and their amplitudes would be the greater
/// part of a recording.
Sounds recordedPart(Sounds sounds) {
    for (Sounds::Body& body : sounds.bodies) {
        body.rings.clear();
    }
    for (Sounds::Impact& impact : sounds.impacts) {
        impact.first = impact.count = 0;
    }
    sounds.scrapes.clear();
    sounds.amplitudes.clear();
    return sounds;
}

template <Property P>
void writeSlot(Store const& store, WordWriter& out) {
    if (Slot<P> const* const slot = store.findSlot<P>()) {
        if constexpr (std::is_same_v<P, Sounds>) {
            out.members(recordedPart(slot->ofFrame()));
        } else {
            out.members(slot->ofFrame());
        }
    }
}

template <Property P>
void readSlot(Store& store, WordReader& in) {
    Slot<P>& slot = store.slot<P>();
    if (in.done()) { // there was no slot, or nothing had been written
        slot.value() = P{};
    } else {
        in.members(slot.value());
    }
    slot.touch();
}

template <Property... P>
std::vector<RecordedSlot> slotsOf() {
    std::vector<RecordedSlot> all{RecordedSlot{&propertyInfo<P>(), writeSlot<P>, readSlot<P>}...};
    std::sort(all.begin(), all.end(), [](RecordedSlot const& a, RecordedSlot const& b) {
        return a.info->text.key < b.info->text.key;
    });
    return all;
}

struct RecordedColumn {
    PropertyInfo const* info;
    void (*write)(ColumnBase const&, WordWriter&);
    void (*read)(ColumnBase&, WordReader&);
};

template <class P>
void writeValues(ColumnBase const& column, WordWriter& out) {
    for (P const& value : static_cast<Column<P> const&>(column).values()) {
        out.members(value);
    }
}

template <class P>
void readValues(ColumnBase& column, WordReader& in) {
    for (P& value : static_cast<Column<P>&>(column).values()) {
        in.members(value);
    }
}

/// The columns that resolvers write, which therefore change while the world runs.
template <ObjectProperty... P>
std::vector<RecordedColumn> columnsOf() {
    return {RecordedColumn{&propertyInfo<P>(), writeValues<P>, readValues<P>}...};
}

RecordedColumn const* typed(PropertyInfo const& info) {
    static std::vector<RecordedColumn> const all =
        columnsOf<Position, Rotation, Velocity, AngularVelocity, Magnet, ElectricityGraph, Fuse, Emf>();
    auto const at = std::find_if(all.begin(), all.end(),
                                 [&](RecordedColumn const& each) { return each.info->type == info.type; });
    return at == all.end() ? nullptr : &*at;
}

} // namespace

std::span<RecordedSlot const> recordedSlots() {
    static std::vector<RecordedSlot> const all =
        slotsOf<BuoyancyForce, CentreOfBuoyancy, Contacts, ContactPatches, ElectricalQuantities,
                ElectricalState, EngineState, ForceLag, ForceRates, FrameParts, GravityForce, Hand,
                Immersions, Impacts, JointForces, LinearGravityVector, LiquidResistance, Loudness,
                MagneticForce, OverloadedJoints, PlayerCommands, SecondHand, Sounds>();
    return all;
}

void writeColumn(ColumnBase const& column, WordWriter& out) {
    out.word(column.size());
    for (ObjectId const owner : column.owners()) {
        out.word(packed(owner));
    }
    if (RecordedColumn const* const known = typed(column.info())) {
        known->write(column, out);
        return;
    }
    Words values;
    FieldWriter fields(values);
    for (ObjectId const owner : column.owners()) {
        column.visitCopy(owner, fields);
    }
    for (std::uint64_t const word : values) {
        out.word(word);
    }
}

void readColumn(ColumnBase& column, WordReader& in) {
    std::vector<ObjectId> owners(static_cast<std::size_t>(in.word()));
    for (ObjectId& owner : owners) {
        owner = in.object();
    }
    if (!std::equal(owners.begin(), owners.end(), column.owners().begin(), column.owners().end())) {
        std::vector<ObjectId> gone;
        std::set_difference(column.owners().begin(), column.owners().end(), owners.begin(), owners.end(),
                            std::back_inserter(gone));
        column.removeAll(gone);
        for (ObjectId const owner : owners) {
            column.addDefault(owner);
        }
    }
    column.touch();
    if (RecordedColumn const* const known = typed(column.info())) {
        known->read(column, in);
        return;
    }
    FieldReader fields(in);
    for (ObjectId const owner : owners) {
        column.visit(owner, fields);
    }
}

} // namespace trembler::insight
