#include "physics/dynamics/simulation.hpp"

namespace trembler {

std::vector<Refusal> Simulation::follow(DynamicsColumns const& columns) {
    DynamicsSettings const settings = columns.worldSettings();
    if (!engine_ || settings.scale != settings_.scale) {
        engine_ = maker_(settings.scale);
        bodies_ = {};
        joints_ = {};
        touching_ = {};
        bodiesVersion_ = 0;
    }
    settings_ = settings;
    std::vector<Refusal> refusals;
    bool const bodiesChanged =
        columns.bodiesVersion() != bodiesVersion_ || columns.motionStructure() != motionStructure_;
    bool const jointsChanged = bodiesChanged || columns.jointsVersion() != jointsVersion_;
    if (jointsChanged) {
        std::vector<SlotIndex> const going =
            bodiesChanged ? bodies_.outdated(columns) : std::vector<SlotIndex>{};
        joints_.removeOutdated(columns, going, *engine_);
        for (SlotIndex const slot : going) {
            bodies_.remove(slot, *engine_);
            causes_.forget(slot);
        }
        if (bodiesChanged) {
            bodies_.addMissing(columns, *engine_, refusals);
            bodies_.findRows(columns);
            loadsStale_ = true;
        }
        joints_.addMissing(columns, bodies_, *engine_, refusals);
        bodiesVersion_ = columns.bodiesVersion();
        jointsVersion_ = columns.jointsVersion();
        motionStructure_ = columns.motionStructure();
    }
    if (columns.motionVersion() != motionVersion_) {
        bodies_.followMotion(columns, *engine_);
        motionVersion_ = columns.motionVersion();
    }
    return refusals;
}

void Simulation::endLoads() {
    loads_.apply(bodies_.bodies(), *engine_);
    loadsStale_ = false;
}

bool Simulation::step(double duration) {
    if (!engine_->anyAwake()) {
        return false;
    }
    engine_->step(duration, settings_);
    loads_.noteSleepers(*engine_);
    return true;
}

} // namespace trembler
