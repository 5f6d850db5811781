// The common part of the detail levels of electricity: finds which circuits must be analysed again, and which
// results are new.
#pragma once

#include "physics/electricity/core/circuit.hpp"
#include "physics/electricity/core/graph_changes.hpp"
#include "physics/electricity/properties/quantities.hpp"

#include <functional>
#include <optional>

namespace trembler {

/// Finds the objects that are on now. Only circuits with changes are analysed, or all circuits if the journal
/// of changes does not reach back to the last update. In both cases the result is compared with the present
/// state, so it does not matter which level computed it.
class StateUpdate {
public:
    /// Marks which vertices of a circuit are on. `on` has a 0 for every vertex. Called once for each circuit
    /// to be analysed, in the order of their numbers.
    using Analyse = std::function<void(Circuit const& circuit, std::vector<std::uint8_t>& on)>;

    /// A conductor whose entry in the state must be written.
    struct Entry {
        ObjectId object;
        std::uint32_t circuit = 0;
        bool on = false;
        bool switched = false; ///< from on to off or the other way; a new conductor was off
    };

    /// `touched` are objects with changes that are not in the graph; their circuits are analysed, too.
    void run(ElectricityColumns const& columns, GraphChanges const& changes, ElectricalState const& state,
             Analyse const& analyse, std::span<ObjectId const> touched = {});

    /// Whether the state must change.
    [[nodiscard]] bool anything() const { return !entries_.empty() || !gone_.empty(); }
    /// Ascending by object.
    [[nodiscard]] std::span<Entry const> entries() const { return entries_; }
    /// Objects in the state that no longer exist.
    [[nodiscard]] std::span<ObjectId const> gone() const { return gone_; }
    /// The number of analysed circuits, and whether these are all circuits.
    [[nodiscard]] std::uint32_t circuits() const { return circuits_; }
    [[nodiscard]] bool sawAll() const { return sawAll_; }
    /// Why a circuit was analysed: the connections made and broken in it. Empty without tracing.
    [[nodiscard]] std::span<EventId const> causes(std::uint32_t circuit) const {
        return circuit < causes_.size() ? std::span<EventId const>(causes_[circuit])
                                        : std::span<EventId const>{};
    }
    /// Writes the result into the state. event(what, objects, causes) is called for every switch, ascending.
    template <class RecordEvent>
    void writeTo(ElectricalState& state, std::uint64_t frame, RecordEvent&& event) const {
        prepare(state, frame);
        for (Entry const& entry : entries_) {
            EventId id;
            if (entry.switched) {
                (entry.on ? state.switchedOn : state.switchedOff).push_back(entry.object);
                id = event(entry.on ? "on" : "off", std::span(&entry.object, 1), causes(entry.circuit));
            }
            state.byIndex[entry.object.index] = {entry.object, entry.on, id};
        }
    }

private:
    void lookAtAll(ElectricityColumns const& columns, ElectricalState const& state, Analyse const& analyse);
    void lookAt(ElectricityColumns const& columns, ObjectId seed, ElectricalState const& state,
                Analyse const& analyse);
    void prepare(ElectricalState& state, std::uint64_t frame) const;

    std::optional<std::uint64_t> seen_; // the latest change that the state accounts for
    CircuitWalk walk_;
    Circuit circuit_;
    std::vector<std::uint8_t> on_;
    std::uint32_t circuits_ = 0;
    bool sawAll_ = false;
    std::vector<Entry> entries_;
    std::vector<ObjectId> gone_;
    std::vector<std::vector<EventId>> causes_; // by circuit
    std::size_t bound_ = 0;                    // one past the highest index of a vertex
};

/// The whole update() of a detail level without quantities.
template <class Access>
void updateElectricalState(Access& access, StateUpdate& update, StateUpdate::Analyse const& analyse) {
    ElectricityColumns const columns{
        access.template read<ElectricityGraph>(), access.template read<Conductor>(),
        access.template read<ElectricalSource>(), access.template read<ElectricalReturn>()};
    update.run(columns, access.template read<GraphChanges>(), access.template derived<ElectricalState>(),
               analyse);
    if (ElectricalQuantities const& others = access.template derived<ElectricalQuantities>();
        !others.byIndex.empty()) { // written by a level with quantities
        access.template derive<ElectricalQuantities>() = {};
    }
    if (update.anything()) { // otherwise components that read the state can continue to sleep
        update.writeTo(access.template derive<ElectricalState>(), access.frame(),
                       [&](std::string_view what, std::span<ObjectId const> objects,
                           std::span<EventId const> causes) { return access.event(what, objects, causes); });
    }
}

} // namespace trembler
