// An engine that moves nothing: it records every call, and returns the data that a test has set.
#pragma once

#include "physics/dynamics/core/engine.hpp"

#include <algorithm>
#include <map>
#include <vector>

namespace trembler::test {

class RecordingEngine final : public Engine {
public:
    void addBody(SlotIndex slot, BodySpec const& spec) override {
        specs[slot] = spec;
        shapes[slot] = *spec.shape;
        at[slot] = spec.motion;
        added.push_back(spec.object);
    }
    void removeBody(SlotIndex slot) override {
        specs.erase(slot);
        removed.push_back(slot);
    }
    void addJoint(SlotIndex, JointSpec const&) override {}
    void removeJoint(SlotIndex) override {}
    void place(SlotIndex slot, Motion const& motion) override {
        at[slot] = motion;
        placed.push_back(slot);
    }
    [[nodiscard]] bool isAt(SlotIndex slot, Motion const& motion) const override {
        Motion const& is = at.at(slot);
        return is.centre == motion.centre && is.angle == motion.angle && is.velocity == motion.velocity &&
               is.spin == motion.spin;
    }
    void setLoads(std::span<Load const> given) override { loads.assign(given.begin(), given.end()); }
    void setDrags(std::span<Drag const> given) override { drags.assign(given.begin(), given.end()); }
    void wake(SlotIndex slot) override { woken.push_back(slot); }
    void applyImpulse(SlotIndex, Vec2, Vec2) override {}
    [[nodiscard]] std::span<std::uint8_t const> awake() const override { return isAwake; }
    [[nodiscard]] bool anyAwake() const override {
        return std::any_of(isAwake.begin(), isAwake.end(), [](std::uint8_t is) { return is != 0; });
    }
    void step(double duration, DynamicsSettings const& settings) override {
        steps.push_back({duration, settings});
    }
    [[nodiscard]] std::span<MovedBody const> moved() const override { return hasMoved; }
    [[nodiscard]] std::vector<TouchChange>& touchChanges() override { return changes_; }
    void addContactPatches(std::vector<ContactPatch>&) const override {}
    [[nodiscard]] Vec2 jointForce(SlotIndex) const override { return {}; }
    [[nodiscard]] std::vector<SlotIndex> lost() const override { return hasLost; }

    struct Step {
        double duration = 0; ///< s
        DynamicsSettings settings;
    };
    std::vector<Step> steps;
    std::vector<SlotIndex> hasLost;

    std::map<SlotIndex, BodySpec> specs; ///< without their shapes, which exist only during add()
    std::map<SlotIndex, Shape> shapes;
    std::map<SlotIndex, Motion> at;
    std::vector<ObjectId> added;
    std::vector<SlotIndex> removed;
    std::vector<SlotIndex> placed;
    std::vector<SlotIndex> woken;
    std::vector<Load> loads;
    std::vector<Drag> drags;
    std::vector<std::uint8_t> isAwake;
    std::vector<MovedBody> hasMoved;

private:
    std::vector<TouchChange> changes_;
};

} // namespace trembler::test
