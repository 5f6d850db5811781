// Box2D 2.4 behind the engine interface.
//
// Box2D's own gravity is off: gravity is a force like any other. The origin of a Box2D body is its centre of
// mass, as Box2D would lose precision in moments about another origin.
#pragma once

#include "physics/dynamics/engines/body_core.hpp"
#include "physics/dynamics/engines/box2d/box2d_crowd.hpp"
#include "physics/dynamics/engines/box2d/joints_at_once.hpp"
#include "physics/dynamics/engines/box2d/substep_motion.hpp"
#include "physics/dynamics/engines/impact_budget.hpp"
#include "physics/dynamics/engines/slot_set.hpp"

#include <box2d/box2d.h>

#include <optional>

namespace trembler {

class Box2dEngine final : public Engine, private b2ContactListener {
public:
    explicit Box2dEngine(double scale);
    ~Box2dEngine() override;

    void addBody(SlotIndex slot, BodySpec const& spec) override;
    void removeBody(SlotIndex slot) override;
    void addJoint(SlotIndex slot, JointSpec const& spec) override;
    void removeJoint(SlotIndex slot) override;
    void place(SlotIndex slot, Motion const& motion) override;
    [[nodiscard]] bool isAt(SlotIndex slot, Motion const& motion) const override;
    void setLoads(std::span<Load const> loads) override;
    void setDrags(std::span<Drag const> drags) override;
    void wake(SlotIndex slot) override;
    void applyImpulse(SlotIndex slot, Vec2 impulse, Vec2 point) override;
    [[nodiscard]] std::span<std::uint8_t const> awake() const override { return awake_; }
    [[nodiscard]] bool anyAwake() const override { return anyAwake_ || disturbed_; }
    bool solveJointsAtOnce(bool wanted) override;
    void findTouchesAtEnd(bool wanted) override { touchesAtEnd_ = wanted; }
    void step(double duration, DynamicsSettings const& settings) override;
    [[nodiscard]] std::span<MovedBody const> moved() const override {
        return std::span(moved_).first(movedCount_);
    }
    [[nodiscard]] std::vector<TouchChange>& touchChanges() override { return touches_; }
    void addContactPatches(std::vector<ContactPatch>& patches) const override;
    void noteImpacts(bool wanted) override;
    [[nodiscard]] std::span<Impact const> impacts() const override { return impacts_; }
    [[nodiscard]] Vec2 jointForce(SlotIndex slot) const override { return joints_[slot].force; }
    [[nodiscard]] std::vector<SlotIndex> lost() const override;

private:
    struct BodyEntry {
        b2Body* body = nullptr;
        ObjectId object;
        b2Vec2 force = b2Vec2_zero; // in engine units
        float torque = 0;
        int restlessJoints = 0; // motors that must not fall asleep
        BodyCore core;
        double extent = 0; // m, of its farthest point from the centre of mass
    };
    struct Place { // in engine units
        b2Vec2 centre = b2Vec2_zero;
        float angle = 0;
    };
    /// A touch that began or ended while Box2D moved a body back along its path.
    struct OnTheWay {
        SlotIndex slot = noSlot;
        Place place; // of the body then
        bool ended = false;
    };
    struct JointEntry {
        b2Joint* joint = nullptr;
        SlotIndex a = noSlot;
        SlotIndex b = noSlot;
        bool restless = false;
        Vec2 force; // N, mean over the last step()
    };

    void takeStep(float h, DynamicsSettings const& settings, bool last);
    void findContactsOfAdded();
    /// Whether Box2D's search for impacts within the coming substep would take too long.
    [[nodiscard]] bool tooManyImpacts(double h) const;
    [[nodiscard]] static bool stops(b2Body const& body) {
        return body.GetType() != b2_dynamicBody || body.IsBullet();
    }
    [[nodiscard]] static bool isActive(b2Body const& body) {
        return body.GetType() != b2_staticBody && body.IsAwake();
    }
    void noteStart();
    /// Moves bodies that were too fast back to where their paths were first blocked, after a substep without
    /// impacts.
    void holdBack();
    /// The share of its path that a body's core can move before it hits something.
    [[nodiscard]] float freeShare(BodyEntry const& entry, Place const& start, b2Vec2 way) const;
    /// Whether Box2D has moved a body back along its path within the substep, and evaluates contacts there.
    [[nodiscard]] bool onTheWay(b2Contact* contact) const;
    void noteOnTheWay(b2Contact* contact, bool ended);

    // The touches at a frame's end, see box2d_frame_end.cpp.
    /// A touch that was reported as begun or ended before Box2D reported it.
    struct Reported {
        b2Contact const* contact = nullptr; // to be compared with only: Box2D may have destroyed it
        TouchChange change;
        SlotIndex slot = noSlot;
        SlotIndex other = noSlot;
    };
    /// Whether the contact touches at the present positions and did not when Box2D evaluated it, or the
    /// reverse.
    [[nodiscard]] static bool isStale(b2Contact* contact);
    /// The body's motion in the last substep, from `start` to its present place.
    [[nodiscard]] SubstepMotion motionFrom(SlotIndex slot, Place const& start) const;
    /// farInSubstep in engine units.
    [[nodiscard]] float farLimit() const { return static_cast<float>(farInSubstep * scale_); }
    /// Finds substepMotions_, movedFar_ and farSlots_.
    void noteSubstepMotions();
    /// Finds a set of bodies that contains at least one body of each pair that moved far apart; false if it
    /// is not smaller than farSlots_, which is such a set, too.
    [[nodiscard]] bool findDeviating();
    /// Reports the touches of pairs that moved far apart if they differ from the touches that Box2D has.
    void reportStaleTouches();
    void reportIfStale(b2Contact* contact, SlotIndex slot, SlotIndex other);
    /// Whether the change has been reported already. It is then removed from reported_.
    [[nodiscard]] bool takeReported(b2Contact const* contact, TouchChange const& change);
    /// Reverts the reported touches that Box2D did not find when it evaluated them.
    void settleReported();
    /// Reverts the reported touches of a body that is removed.
    void forgetReported(SlotIndex slot);
    void takeBack(Reported const& reported);
    /// The manifold of a contact at the frame's end; nothing if it does not touch.
    [[nodiscard]] std::optional<b2Manifold> manifoldNow(b2Contact* contact) const;

    void BeginContact(b2Contact* contact) override;
    void EndContact(b2Contact* contact) override;
    void PreSolve(b2Contact* contact, b2Manifold const* before) override;
    void PostSolve(b2Contact* contact, b2ContactImpulse const* impulse) override;
    /// Stores the velocities at the beginning of a substep, for its impacts.
    void noteVelocities();
    [[nodiscard]] ImpactBudget::Body beforeImpact(b2Body const* body) const;
    /// Reports the impacts of a substep.
    void settleImpacts();
    void noteTouch(b2Contact* contact, int delta);
    [[nodiscard]] TouchChange changeOf(b2Contact* contact, int delta) const;
    /// Wakes the body and all that it rests on or is tied to, as Box2D itself does within its step, but with
    /// their loads, which Box2D drops when a body falls asleep.
    void wakeAll(b2Body* body);
    void loadWoken();
    void keepAwake(SlotIndex slot, int change);
    /// Slows down bodies with drag, by the effect of drag in the coming substep.
    void applyDrags(double substep);
    void noteDragged();
    void applyJoints(float substep);
    [[nodiscard]] Twist momentumOf(b2Body const& body) const;
    static void prefetchAfter(SlotIndex slot, BodyEntry const* entries, SlotIndex count);
    /// `mayFallAsleep`: Box2D may put it to sleep after this substep.
    void noteAwake(SlotIndex slot, bool mayFallAsleep);
    /// After a substep: marks the bodies that moved.
    void noteSubstep();
    /// After the last one: the list of all bodies that were awake in any.
    void noteMotion(bool sleeping);
    [[nodiscard]] bool drifts(BodyEntry const& entry) const;
    /// The speed that its load gives any point of a body within one substep at most, in engine units.
    [[nodiscard]] float speedGain(b2Body const* body) const;
    [[nodiscard]] b2Vec2 toEngine(Vec2 v) const {
        return {static_cast<float>(v.x * scale_), static_cast<float>(v.y * scale_)};
    }
    [[nodiscard]] Vec2 fromEngine(b2Vec2 v) const {
        return {static_cast<double>(v.x) / scale_, static_cast<double>(v.y) / scale_};
    }
    [[nodiscard]] SlotIndex slotOf(b2Body const* body) const;
    [[nodiscard]] b2Joint* makeJoint(JointSpec const& spec);

    double scale_;
    CrowdFilter crowds_;
    b2World world_;
    b2Body* ground_ = nullptr; // the body that joints to the world connect to
    std::vector<BodyEntry> bodies_;
    SlotSet stopping_; // fixed bodies and bullets
    std::vector<JointEntry> joints_;
    std::vector<DraggedBody> dragged_;     // by slot
    std::vector<SlotIndex> draggedSlots_;  // of bodies with drag
    std::vector<std::uint8_t> awake_;      // by slot: awake, and Box2D has its load
    std::unique_ptr<JointsAtOnce> atOnce_; // while joints are solved so
    bool tiesStale_ = false;               // atOnce_ does not have the present joints
    bool coldStart_ = false;               // Box2D's joint impulses of the last step must not be used
    float substep_ = 0;                    // s
    bool anyAwake_ = false;
    bool disturbed_ = false;       // Box2D may have woken bodies that awake_ does not include
    std::vector<MovedBody> moved_; // the first movedCount_ are valid; longer, to reuse memory
    std::size_t movedCount_ = 0;
    std::vector<std::uint8_t> movedMarks_; // by slot: was awake in an earlier substep of this step
    std::vector<TouchChange> touches_;
    std::vector<b2Body*> wakeStack_;
    int added_ = 0;            // bodies since Box2D last searched for new contacts
    int removed_ = 0;          // bodies removed while such bodies wait
    std::vector<Place> start_; // by slot: places of awake bodies at the beginning of the substep
    bool touchesAtEnd_ = true;
    bool watching_ = false; // start_ is used
    std::vector<OnTheWay> changedOnTheWay_;
    /// In the last substep: far enough for touches to be stale, or stopped by Box2D on its way.
    enum class Moved : std::uint8_t { little, far, stopped };
    std::vector<Moved> movedFar_;               // by slot
    std::vector<SubstepMotion> substepMotions_; // by slot
    std::vector<std::uint8_t> deviates_;        // by slot
    std::vector<SlotIndex> farSlots_;           // ascending: bodies that moved far or were stopped
    std::vector<SlotIndex> deviating_;          // ascending
    struct BodyEdge {
        b2ContactEdge* edge = nullptr;
        SlotIndex slot = noSlot;
    };
    std::vector<BodyEdge> edges_;
    std::vector<Reported> reported_; // since the end of the last frame
    bool impactsWanted_ = false;
    ImpactBook pressures_;
    ImpactBudget budget_;
    struct Velocity { // in engine units
        b2Vec2 linear = b2Vec2_zero;
        float spin = 0;
    };
    std::vector<Velocity> atStart_;     // by slot, at the beginning of the substep
    std::vector<Velocity> beforeTouch_; // by slot, when its contacts were last evaluated
    std::vector<Impact> impacts_;
    double since_ = 0; // s, from the beginning of the frame to that of the substep
};

[[nodiscard]] std::unique_ptr<Engine> makeBox2dEngine(double scale);

} // namespace trembler
