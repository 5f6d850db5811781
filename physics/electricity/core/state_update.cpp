#include "physics/electricity/core/state_update.hpp"

#include <algorithm>

namespace trembler {

void StateUpdate::run(ElectricityColumns const& columns, GraphChanges const& changes,
                      ElectricalState const& state, Analyse const& analyse,
                      std::span<ObjectId const> touchedToo) {
    entries_.clear();
    gone_.clear();
    causes_.clear();
    circuits_ = 0;
    sawAll_ = false;
    std::span<ObjectId const> const vertices = columns.graph.owners();
    bound_ = vertices.empty() ? 0 : vertices.back().index + std::size_t{1};
    if (seen_ == changes.number && touchedToo.empty()) {
        return;
    }
    walk_.begin(columns);
    if (!seen_ || !changes.remembers(*seen_)) {
        lookAtAll(columns, state, analyse);
    } else {
        auto const news = std::partition_point(changes.journal.begin(), changes.journal.end(),
                                               [&](auto const& touched) { return touched.number <= *seen_; });
        std::span<GraphChanges::Touched const> const touched(news, changes.journal.end());
        for (auto const& [object, event, number] : touched) {
            if (columns.graph.has(object)) {
                lookAt(columns, object, state, analyse);
            } else if (object.index < state.byIndex.size() && state.byIndex[object.index].object == object) {
                gone_.push_back(object);
            }
        }
        for (ObjectId const object : touchedToo) {
            lookAt(columns, object, state, analyse);
        }
        for (auto const& [object, event, number] : touched) {
            std::uint32_t const circuit =
                columns.graph.has(object) ? walk_.circuitOf(object) : CircuitWalk::none;
            if (event && circuit != CircuitWalk::none) {
                causes_.resize(std::max<std::size_t>(causes_.size(), circuit + std::size_t{1}));
                causes_[circuit].push_back(event);
            }
        }
    }
    seen_ = changes.number;
    auto const ascending = [](Entry const& x, Entry const& y) { return x.object < y.object; };
    if (!std::is_sorted(entries_.begin(), entries_.end(), ascending)) {
        std::sort(entries_.begin(), entries_.end(), ascending);
    }
}

void StateUpdate::lookAtAll(ElectricityColumns const& columns, ElectricalState const& state,
                            Analyse const& analyse) {
    sawAll_ = true;
    for (ElectricalState::Entry const& entry : state.byIndex) {
        if (entry.object.valid() && !columns.graph.has(entry.object)) {
            gone_.push_back(entry.object);
        }
    }
    for (ObjectId const id : columns.graph.owners()) {
        lookAt(columns, id, state, analyse);
    }
}

void StateUpdate::lookAt(ElectricityColumns const& columns, ObjectId seed, ElectricalState const& state,
                         Analyse const& analyse) {
    if (!walk_.walk(columns, seed, circuit_)) {
        return;
    }
    on_.assign(circuit_.size(), 0);
    analyse(circuit_, on_);
    for (std::uint32_t v = 0; v < circuit_.size(); ++v) {
        ObjectId const id = circuit_.objects[v];
        bool const known = id.index < state.byIndex.size() && state.byIndex[id.index].object == id;
        bool const was = known && state.byIndex[id.index].on;
        bool const is = on_[v] != 0;
        if (!known || was != is) {
            entries_.push_back({id, circuits_, is, was != is});
        }
    }
    ++circuits_;
}

void StateUpdate::prepare(ElectricalState& state, std::uint64_t frame) const {
    state.frame = frame;
    state.switchedOn.clear();
    state.switchedOff.clear();
    for (ObjectId const id : gone_) {
        state.byIndex[id.index] = {};
    }
    if (state.byIndex.size() < bound_) {
        state.byIndex.resize(bound_);
    }
}

} // namespace trembler
