#include "physics/dynamics/engines/native/island_solver.hpp"

#include "physics/dynamics/engines/native/seams.hpp"
#include "runtime/component/component.hpp"
#include "runtime/math/exact_math.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

// Contacts are springs of a quarter of the substeps' rate, strongly overdamped, as in Solver2D; a higher rate
// is not followed by the substeps.
constexpr double contactShare = 0.25;
constexpr double contactDamping = 10;
// Per step, the share by which the force at which a spring is not compressed follows most of the present one,
// so that bodies at rest do not sink in. All of it, or faster, and a pile would never come to rest. Bodies
// faster than this (m/s) are not at rest: a force that follows their motion late drives it, as any integral
// control of a slow oscillation does.
constexpr double steadyRate = 0.08;
constexpr double steadyPart = 0.95;
constexpr double fastestSteady = 2e-4;
// A change of velocity up to this multiple of that by loads is one by steady forces, such as friction, and
// not an impact.
constexpr double steadyShare = 2.5;
// With r the mass that rests on a body as a multiple of its own, 0.9 √r substeps hold a stack
// (docs/measurements).
constexpr double stackFactor = 0.9;
constexpr double mostSubsteps = 64;
constexpr int leastSubsteps = 4;
// Contacts are solved at once if one bears this multiple of a body's weight, if masses that touch differ so
// much, or if their forces are determined, since bodies have no more points of contact than this: then what
// is stacked is as stiff as it should be, however high. Other piles of equal bodies would never come to rest.
constexpr double unequalLoads = 50;
constexpr double unequalMasses = 3;
constexpr std::size_t determinedPoints = 2; // for each body: the third equation is that of friction
constexpr std::size_t mostExactContacts = 150;
// A substep in which joints cannot be closed is split in two, up to so many times.
constexpr int mostHalvings = 6;
// Of a step, all together.
constexpr int mostSplits = 24;
// Then it may leave joints apart by so much (m or rad), or have so many times the energy that it should,
// which is taken away.
constexpr double mostMisfit = 1e-3;
constexpr double mostBearableGain = 4;
// Joints that are closed from far apart make bodies fast for a substep, but no faster than so, m/s.
constexpr double fastestBearable = 20;
// A body may move by this share of its thinnest half, or turn by so many rad, before its contacts are found
// again.
constexpr double shareOfThin = 0.5;
constexpr double widestTurn = 0.15;
// Of these intervals a step has at most so many.
constexpr int mostIntervals = 64;
// Impacts at their exact times, of a small island; in a large one bodies bounce up to a substep early.
constexpr int mostHits = 16;
constexpr std::size_t smallIsland = 128;
constexpr int roundsOfStack = 2;
constexpr int roundsOfImpact = 12;
constexpr double fastImpact = 0.5;   // m/s
constexpr double deepOverlap = 5e-3; // m
// Contacts may add this share to the bodies' kinetic energy, and that of so many m/s, as roundings and
// overlaps that are closed do.
constexpr double mostExcess = 0.05;
constexpr double slowestExcess = 0.1;

} // namespace

// A damped spring by implicit Euler as a soft constraint: E. Catto, "Soft Constraints", GDC 2011.
Softness softness(double h) {
    double const omega = 2 * pi * contactShare / h;
    double const a1 = 2 * contactDamping + h * omega;
    return {omega / a1, 1 / (h * omega * a1)};
}

IslandSolver::IslandSolver(NativeEngine& engine, Island const& island, DynamicsSettings const& settings)
    : engine_(engine), island_(island), settings_(settings), rows_(engine.rows_), seams_(engine.seamSearch_) {
}

int IslandSolver::demand(double duration) const {
    if (!engine_.choosesSubsteps_) {
        return std::max(1, settings_.substeps);
    }
    if (island_.joints.empty() && island_.contacts.empty()) {
        return 1; // constant forces are integrated exactly
    }
    double most = 0;
    for (std::uint32_t const i : island_.contacts) {
        Contact const& contact = engine_.contacts_[i];
        double const pressure = contact.force[0] + contact.force[1];
        for (SlotIndex const slot : {contact.a, contact.b}) {
            double const weight = length(engine_.bodies_[slot].load.force);
            if (weight > 0 && pressure > most * weight) {
                most = pressure / weight;
            }
        }
    }
    double wanted = std::max<double>(leastSubsteps, stackFactor * std::sqrt(most));
    if (!island_.joints.empty()) {
        wanted = std::max<double>(wanted, settings_.substeps);
    }
    double const share = std::min(1.0, duration / frameDuration);
    return std::max(1, static_cast<int>(std::ceil(share * std::min(wanted, mostSubsteps))));
}

// Impulses found one by one need as many rounds as the loads differ. A few contacts are solved at once
// instead.
bool IslandSolver::wantsExactContacts() const {
    if (island_.contacts.empty() || island_.contacts.size() > mostExactContacts) {
        return false;
    }
    std::size_t points = 0;
    for (std::uint32_t const i : island_.contacts) {
        Contact const& contact = engine_.contacts_[i];
        if (!contact.used) {
            continue;
        }
        points += static_cast<std::size_t>(contact.meeting.count);
        double const pressure = contact.force[0] + contact.force[1];
        double const a = stateOf(contact.a).inverseMass;
        double const b = stateOf(contact.b).inverseMass;
        if (a > 0 && b > 0 && std::max(a, b) > unequalMasses * std::min(a, b)) {
            return true;
        }
        for (SlotIndex const slot : {contact.a, contact.b}) {
            double const weight = length(engine_.bodies_[slot].load.force);
            if (weight > 0 && pressure > unequalLoads * weight) {
                return true;
            }
        }
    }
    return island_.bodies.size() > 1 && points <= determinedPoints * island_.bodies.size();
}

// --- intervals
// ------------------------------------------------------------------------------------------------

double IslandSolver::safeTime(Contact const& contact, double remaining) const {
    BodyEntry const& a = engine_.bodies_[contact.a];
    BodyEntry const& b = engine_.bodies_[contact.b];
    MovingState const& stateA = stateOf(contact.a);
    MovingState const& stateB = stateOf(contact.b);
    Vec2 const velocity = stateB.velocity - stateA.velocity;
    double const turning = std::abs(stateA.spin) * a.extent + std::abs(stateB.spin) * b.extent;
    double const thin = shareOfThin * std::min(a.fixed ? 1e9 : a.thin, b.fixed ? 1e9 : b.thin);
    double const speed = length(velocity) + turning;
    if (speed * remaining <= thin) {
        return remaining;
    }
    // Conservative advancement: the pieces cannot meet before they have covered the gap between them.
    Convex const& pieceA = a.pieces[pieceOf(firstOf(contact.key))];
    Convex const& pieceB = b.pieces[pieceOf(secondOf(contact.key))];
    Pose const& poseA = engine_.poses_[contact.a];
    Pose const& poseB = engine_.poses_[contact.b];
    double const near = std::min(thin, 1e-3);
    double time = 0;
    for (int i = 0; i < 100 && time < remaining; ++i) {
        double const angleA = a.angle + time * stateA.spin;
        double const angleB = b.angle + time * stateB.spin;
        CosineAndSine const turnA = exactTurn(angleA);
        CosineAndSine const turnB = exactTurn(angleB);
        Pose const atA{{}, turnA.cosine, turnA.sine};
        Pose const atB{poseB.at - poseA.at + time * velocity, turnB.cosine, turnB.sine};
        double const gap = gapBetween(pieceA, atA, pieceB, atB);
        if (gap <= near) {
            break;
        }
        time += std::max(gap - near / 2, near / 4) / speed;
    }
    return std::min(remaining, std::max(time, thin / speed));
}

double IslandSolver::interval(double remaining) const {
    double time = remaining;
    double spin = 0;
    for (SlotIndex const slot : island_.bodies) {
        spin = std::max(spin, std::abs(stateOf(slot).spin));
    }
    if (spin * time > widestTurn && !island_.contacts.empty()) {
        bool round = true; // discs may turn by any angle
        for (SlotIndex const slot : island_.bodies) {
            BodyEntry const& body = engine_.bodies_[slot];
            round = round && (std::abs(stateOf(slot).spin) * time <= widestTurn ||
                              (body.pieces.size() == 1 && body.pieces[0].disc() &&
                               lengthSquared(body.pieces[0].corners[0]) < 1e-18));
        }
        if (!round) {
            time = std::max(widestTurn / spin, time / mostIntervals);
        }
    }
    for (std::uint32_t const i : island_.contacts) {
        time = safeTime(engine_.contacts_[i], time);
    }
    return std::max(time, std::min(remaining, 1e-7));
}

void IslandSolver::findContacts(double time) {
    for (SlotIndex const slot : island_.bodies) {
        engine_.setPose(slot);
    }
    for (std::uint32_t const i : island_.contacts) {
        Contact& contact = engine_.contacts_[i];
        engine_.meetOne(contact, 1e-3 + engine_.reach(contact.a, time) + engine_.reach(contact.b, time));
    }
    seams_.clear();
    for (std::uint32_t const i : island_.contacts) {
        seams_.push_back(&engine_.contacts_[i]);
    }
    leaveOutSeams(seams_, engine_.bodies_, engine_.poses_);
}

// --- a step
// ---------------------------------------------------------------------------------------------------

void IslandSolver::catchUpLoads() {
    bool any = false;
    for (SlotIndex const slot : island_.bodies) {
        BodyEntry const& entry = engine_.bodies_[slot];
        Vec2 const force = entry.load.force - entry.loadBefore.force;
        double const torque = entry.load.torque - entry.loadBefore.torque;
        // In the first step of its life nothing has acted yet.
        bool const varied = entry.loadBefore.varies || entry.steps == 1;
        if (entry.lastStep == 0 || !entry.load.varies || !varied ||
            (force.x == 0 && force.y == 0 && torque == 0)) {
            continue;
        }
        MovingState& state = stateOf(slot);
        state.velocity += entry.lastStep / 2 * state.inverseMass * force;
        state.spin += entry.lastStep / 2 * state.inverseInertia * torque;
        any = true;
    }
    if (any) {
        beginJointedImpacts();
    }
}

void IslandSolver::run(double duration) {
    int const substeps = demand(duration);
    h_ = duration / substeps;
    catchUpLoads();
    int hits = island_.bodies.size() > smallIsland ? 0 : mostHits;
    int corrections = 4 * hits;
    int intervals = mostIntervals;
    double left = duration;
    rows_.clear();
    relaxes_ = !island_.joints.empty() && beginsRelaxed();
    if (!island_.joints.empty() && !relaxes_) {
        double const covered = moveSmoothly(duration);
        left = covered < duration ? duration - covered : 0;
        if (covered > 0) { // with all contacts open
            forgetForces();
        }
        since_ = covered;
    }
    exactContacts_ = !relaxes_ && wantsExactContacts();
    for (bool first = left == duration; left > 1e-12 * duration; first = false) {
        double const span = --intervals > 0 ? interval(left) : left;
        if (!first || span < left) {
            findContacts(span);
        }
        int const parts = std::max(1, static_cast<int>(std::ceil(span / h_ - 1e-9)));
        makeRows();
        for (int i = 0; i < parts; ++i) {
            double rest = span / parts;
            while (rest > 0) {
                Hit const hit = firstHit(rest);
                if (hit.any && hits > 0) {
                    bool const aside = hit.after > 0 && hitsAside(hit.after) && --corrections > 0;
                    if (hit.after > 0) {
                        substep(hit.after);
                    }
                    rest = hit.after < rest ? rest - hit.after : 0;
                    if (aside) { // the normal has turned since it was found
                        findContacts(rest);
                        makeRows();
                        continue;
                    }
                    --hits;
                    bounce(0);
                    continue;
                }
                if (hit.any) {
                    bounce(rest);
                }
                substep(rest);
                rest = 0;
            }
        }
        left = span < left ? left - span : 0;
    }
    if (!island_.joints.empty()) {
        noteTroubles();
    }

    auto const rests = [&](SlotIndex slot) {
        MovingState const& state = stateOf(slot);
        return length(state.velocity) + std::abs(state.spin) * engine_.bodies_[slot].extent <= fastestSteady;
    };
    for (ContactRow const& row : rows_) {
        if (!rests(row.a) || !rests(row.b)) {
            continue;
        }
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            Contact& contact = *row.detail->contact;
            contact.steady[n] += steadyRate * (steadyPart * contact.force[n] - contact.steady[n]);
        }
    }
    for (SlotIndex const slot : island_.bodies) {
        engine_.setPose(slot);
    }
}

void IslandSolver::makeRows() {
    rows_.clear();
    // Rows refer to their details, which therefore must not move.
    std::vector<RowDetail>& details = engine_.rowDetails_;
    details.clear();
    details.reserve(island_.contacts.size());
    for (SlotIndex const slot : island_.bodies) {
        MovingState& state = stateOf(slot);
        state.moved = {};
        state.turned = 0;
        state.cosine = 1;
        state.sine = 0;
    }
    for (std::uint32_t const i : engine_.solvingOrder_.of(island_, engine_.contacts_, engine_.bodies_)) {
        Contact& contact = engine_.contacts_[i];
        BodyEntry const& a = engine_.bodies_[contact.a];
        BodyEntry const& b = engine_.bodies_[contact.b];
        double const radiusA = a.pieces[pieceOf(firstOf(contact.key))].radius;
        double const radiusB = b.pieces[pieceOf(secondOf(contact.key))].radius;
        MovingState const& stateA = stateOf(contact.a);
        MovingState const& stateB = stateOf(contact.b);
        RowDetail& detail = details.emplace_back();
        ContactRow& row = rows_.emplace_back();
        row.detail = &detail;
        detail.contact = &contact;
        detail.restitution = std::max(a.restitution, b.restitution);
        row.a = contact.a;
        row.b = contact.b;
        row.normal = contact.meeting.normal;
        row.friction = std::sqrt(a.friction * b.friction);
        row.bounces = detail.restitution > 0;
        row.count = contact.meeting.count;
        double const mass = stateA.inverseMass + stateB.inverseMass;
        Vec2 const across = perpendicular(row.normal);
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            MeetingPoint const& found = contact.meeting.points[n];
            PointRow& point = row.points[n];
            detail.armA[n] = found.armA;
            detail.armB[n] = found.armB;
            // Both arms end in the same point, halfway between the surfaces, so that angular momentum is
            // kept.
            Vec2 const reachA = detail.reachA[n] = found.armA + (radiusA + found.separation / 2) * row.normal;
            Vec2 const reachB = detail.reachB[n] = found.armB - (radiusB + found.separation / 2) * row.normal;
            detail.gap[n] = found.separation;
            point.normalA = cross(reachA, row.normal);
            point.normalB = cross(reachB, row.normal);
            point.acrossA = cross(reachA, across);
            point.acrossB = cross(reachB, across);
            point.normalInverse = mass + stateA.inverseInertia * point.normalA * point.normalA +
                                  stateB.inverseInertia * point.normalB * point.normalB;
            point.tangentMass = 1 / (mass + stateA.inverseInertia * point.acrossA * point.acrossA +
                                     stateB.inverseInertia * point.acrossB * point.acrossB);
        }
        row.coupling = mass + stateA.inverseInertia * row.points[0].normalA * row.points[1].normalA +
                       stateB.inverseInertia * row.points[0].normalB * row.points[1].normalB;
    }
}

double IslandSolver::gapOf(ContactRow const& row, std::size_t point) const {
    MovingState const& a = stateOf(row.a);
    MovingState const& b = stateOf(row.b);
    RowDetail const& detail = *row.detail;
    Vec2 const way = b.moved - a.moved + (b.turn(detail.armB[point]) - detail.armB[point]) -
                     (a.turn(detail.armA[point]) - detail.armA[point]);
    return detail.gap[point] + dot(row.normal, way);
}

double IslandSolver::normalSpeed(ContactRow const& row, PointRow const& point) const {
    MovingState const& a = stateOf(row.a);
    MovingState const& b = stateOf(row.b);
    return dot(row.normal, b.velocity - a.velocity) + b.spin * point.normalB - a.spin * point.normalA;
}

double IslandSolver::slipOf(ContactRow const& row, PointRow const& point) const {
    MovingState const& a = stateOf(row.a);
    MovingState const& b = stateOf(row.b);
    return dot(perpendicular(row.normal), b.velocity - a.velocity) + b.spin * point.acrossB -
           a.spin * point.acrossA;
}

void IslandSolver::push(ContactRow const& row, PointRow const& point, double normal, double across) {
    MovingState& a = stateOf(row.a);
    MovingState& b = stateOf(row.b);
    Vec2 const impulse = normal * row.normal + across * perpendicular(row.normal);
    a.velocity -= a.inverseMass * impulse;
    a.spin -= a.inverseInertia * (normal * point.normalA + across * point.acrossA);
    b.velocity += b.inverseMass * impulse;
    b.spin += b.inverseInertia * (normal * point.normalB + across * point.acrossB);
}

// --- a substep
// ------------------------------------------------------------------------------------------------

namespace {

// exp(-x) to the second order, and between 0 and 1 for any x, however strong the damping.
double decay(double x) {
    return 1 / (1 + x * (1 + x / 2));
}

} // namespace

void IslandSolver::accelerate(SlotIndex slot, double h) {
    MovingState& state = stateOf(slot);
    BodyEntry const& entry = engine_.bodies_[slot];
    state.velocityBefore = state.velocity;
    state.spinBefore = state.spin;
    Twist const load{h * entry.load.force, h * entry.load.torque};
    Twist push = load;
    if (slot < engine_.dragged_.size() && engine_.dragged_[slot].drag.any()) {
        Twist const now{entry.mass * state.velocity, entry.inertia * state.spin};
        Twist const drag = engine_.dragged_[slot].before(entry.mass, entry.inertia, now, load, h);
        push = {push.linear + drag.linear, push.angular + drag.angular};
    }
    state.velocity += state.inverseMass * push.linear;
    state.spin += state.inverseInertia * push.angular;
    state.velocity *= decay(h * entry.damping.linear);
    state.spin *= decay(h * entry.damping.angular);
    state.accelerated = state.velocity - state.velocityBefore;
    state.accelerates = state.spin - state.spinBefore;
}

void IslandSolver::startRows(double h) {
    for (ContactRow& row : rows_) {
        Contact const& contact = *row.detail->contact;
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            PointRow& point = row.points[n];
            point.now = gapOf(row, n);
            point.normal = row.awaits ? 0 : h * contact.force[n];
            point.steady = h * contact.steady[n];
            point.tangent = row.awaits ? 0 : h * contact.drag[n];
            if (point.normal != 0 || point.tangent != 0) {
                push(row, point, point.normal, point.tangent);
            }
        }
    }
}

namespace {

// The impulses of two points, none negative, by trying the four cases of the complementarity problem (E.
// Catto, Box2D 2.4). `rest`: m/s that the changes of the impulses have to bring about; `whole`: 1/kg of each
// point alone; `k`: of both.
std::array<double, 2> bothImpulses(std::array<double, 2> const& before, std::array<double, 2> const& rest,
                                   std::array<double, 2> const& whole, double k) {
    double const determinant = whole[0] * whole[1] - k * k;
    bool const regular = determinant > 1e-6 * whole[0] * whole[1];
    if (regular) {
        std::array<double, 2> const both{before[0] + (whole[1] * rest[0] - k * rest[1]) / determinant,
                                         before[1] + (whole[0] * rest[1] - k * rest[0]) / determinant};
        if (both[0] >= 0 && both[1] >= 0) {
            return both;
        }
    }
    double const first = before[0] + (rest[0] + k * before[1]) / whole[0];
    double const leftOfSecond = rest[1] + whole[1] * before[1] - k * (first - before[0]);
    if (first >= 0 && (leftOfSecond <= 0 || !regular)) {
        return {first, 0};
    }
    double const second = before[1] + (rest[1] + k * before[0]) / whole[1];
    double const leftOfFirst = rest[0] + whole[0] * before[0] - k * (second - before[1]);
    if (second >= 0 && leftOfFirst <= 0) {
        return {0, second};
    }
    return {};
}

// Both points of a contact are solved at once: one after the other they would tilt the body a little in each
// substep. Friction follows. `rate`: 1/s, of substeps.
void solveRow(ContactRow& row, MovingState& a, MovingState& b, double rate, Softness const& soft, bool bias,
              bool frictionOnly) {
    Vec2 const normal = row.normal;
    double const massA = a.inverseMass;
    double const massB = b.inverseMass;
    double const inertiaA = a.inverseInertia;
    double const inertiaB = b.inverseInertia;
    Vec2 velocityA = a.velocity;
    Vec2 velocityB = b.velocity;
    double spinA = a.spin;
    double spinB = b.spin;
    double const common = dot(normal, velocityB - velocityA);
    std::array<double, 2> rest{};
    std::array<double, 2> whole{};
    auto const count = static_cast<std::size_t>(row.count);
    for (std::size_t n = 0; n < count; ++n) {
        PointRow const& point = row.points[n];
        double const speed = common + spinB * point.normalB - spinA * point.normalA;
        whole[n] = point.normalInverse;
        if (point.now > 0) { // it may just reach the other surface
            rest[n] = -speed - point.now * rate;
        } else if (bias) {
            double const yield = soft.yield * point.normalInverse;
            whole[n] += yield;
            rest[n] = -speed - std::max(soft.bias * point.now, -fastestParting) -
                      yield * (point.normal - point.steady);
        } else {
            rest[n] = -speed;
        }
    }
    std::array<double, 2> sum{};
    if (frictionOnly) {
        sum = {row.points[0].normal, row.points[1].normal};
    } else if (count == 1) {
        sum[0] = std::max(row.points[0].normal + rest[0] / whole[0], 0.0);
    } else {
        sum = bothImpulses({row.points[0].normal, row.points[1].normal}, rest, whole, row.coupling);
    }
    double pressed = 0;
    double turnA = 0;
    double turnB = 0;
    for (std::size_t n = 0; n < count; ++n) {
        PointRow& point = row.points[n];
        double const more = sum[n] - point.normal;
        point.normal = sum[n];
        pressed += more;
        turnA += more * point.normalA;
        turnB += more * point.normalB;
    }
    velocityA -= massA * pressed * normal;
    velocityB += massB * pressed * normal;
    spinA -= inertiaA * turnA;
    spinB += inertiaB * turnB;
    Vec2 const across = perpendicular(normal);
    double slip = dot(across, velocityB - velocityA);
    double dragged = 0;
    for (std::size_t n = 0; n < count; ++n) {
        PointRow& point = row.points[n];
        double const most = row.friction * point.normal;
        double const here = slip + spinB * point.acrossB - spinA * point.acrossA;
        double const wanted = std::clamp(point.tangent - point.tangentMass * here, -most, most);
        double const more = wanted - point.tangent;
        point.tangent = wanted;
        slip += (massA + massB) * more;
        dragged += more;
        spinA -= inertiaA * more * point.acrossA;
        spinB += inertiaB * more * point.acrossB;
    }
    a.velocity = velocityA - massA * dragged * across;
    b.velocity = velocityB + massB * dragged * across;
    a.spin = spinA;
    b.spin = spinB;
}

} // namespace

void IslandSolver::solveContacts(double h, bool bias) {
    Softness const soft = softness(h);
    auto const solve = [&](ContactRow& row) {
        if (!row.awaits) {
            solveRow(row, stateOf(row.a), stateOf(row.b), 1 / h, soft, bias, exactContacts_);
        }
    };
    if (bias) {
        for (ContactRow& row : rows_) {
            solve(row);
        }
    } else {
        for (auto row = rows_.rbegin(); row != rows_.rend(); ++row) {
            solve(*row);
        }
    }
}

// Steady forces lead to the mean of the velocities before and after, which is exact for constant ones. Where
// contacts bear a body their springs damp its motion by the velocity after, except along the surface on which
// it slides.
void IslandSolver::findBearing() {
    for (ContactRow const& row : rows_) {
        if (stateOf(row.a).borne == Borne::held && stateOf(row.b).borne == Borne::held) {
            continue;
        }
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            PointRow const& point = row.points[n];
            if (point.normal <= 0) {
                continue;
            }
            bool const slides = std::abs(point.tangent) >= (1 - 1e-12) * row.friction * point.normal;
            Vec2 const along = perpendicular(row.normal);
            for (SlotIndex const slot : {row.a, row.b}) {
                MovingState& state = stateOf(slot);
                bool const same =
                    state.borne == Borne::not_at_all ||
                    (state.borne == Borne::sliding && std::abs(cross(state.slidesAlong, along)) < 1e-6);
                state.borne = slides && same ? Borne::sliding : Borne::held;
                state.slidesAlong = along;
            }
        }
    }
}

Drift IslandSolver::driftOf(SlotIndex slot) const {
    MovingState const& state = stateOf(slot);
    BodyEntry const& entry = engine_.bodies_[slot];
    Drift drift{state.velocity, state.spin};
    Vec2 const change = state.velocity - state.velocityBefore;
    bool const steady = entry.joints > 0 ||
                        lengthSquared(change) <= steadyShare * steadyShare * lengthSquared(state.accelerated);
    if (steady && state.borne == Borne::not_at_all) {
        drift.velocity -= change / 2;
        drift.spin -= (state.spin - state.spinBefore) / 2;
    } else if (steady && state.borne == Borne::sliding && entry.joints == 0) {
        drift.velocity -= dot(change, state.slidesAlong) / 2 * state.slidesAlong;
    }
    return drift;
}

void IslandSolver::move(double h) {
    findBearing();
    for (SlotIndex const slot : island_.bodies) {
        MovingState& state = stateOf(slot);
        BodyEntry& entry = engine_.bodies_[slot];
        Drift const drift = driftOf(slot);
        Vec2 const way = h * drift.velocity;
        double const angle = h * drift.spin;
        entry.centre += way;
        entry.angle += angle;
        state.moved += way;
        state.turned += angle;
        // The rotation by an angle from the tangent of its half, by two terms of its series.
        double const q = angle / 2 * (1 + angle * angle / 12);
        double const unit = 1 / (1 + q * q);
        double const c = (1 - q * q) * unit;
        double const s = 2 * q * unit;
        double const cosine = state.cosine * c - state.sine * s;
        state.sine = state.sine * c + state.cosine * s;
        state.cosine = cosine;
        if (!isFinite(entry.centre) || !std::isfinite(entry.angle)) {
            throw EngineFailure("a body's place or speed is no finite number");
        }
    }
}

// Bodies that rest on others need more than one; so do the chains of a small island through which an impact
// goes, or a box that lands on a box would tilt it, and overlapping bodies that push each other apart, or
// they would keep some of that speed.
int IslandSolver::contactRounds(double h) const {
    if (island_.bodies.size() == 1) {
        return 1;
    }
    if (island_.bodies.size() <= smallIsland) {
        for (ContactRow const& row : rows_) {
            for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
                double const gap = gapOf(row, n);
                if (gap < -deepOverlap ||
                    -normalSpeed(row, row.points[n]) - std::max(0.0, gap) / h > fastImpact) {
                    return roundsOfImpact;
                }
            }
        }
    }
    return roundsOfStack;
}

double IslandSolver::fastest() const {
    double speed = 0;
    for (SlotIndex const slot : island_.bodies) {
        speed = std::max(speed, length(stateOf(slot).velocity));
    }
    return speed;
}

bool IslandSolver::bearable(double h, int halvings) {
    if (exactContacts_ || relaxes_ || misfit_ > mostMisfit ||
        (halvings < mostHalvings && splits_ < mostSplits)) {
        return false;
    }
    double const gain = gainOf(h);
    if (gain > mostBearableGain && fastest() > fastestBearable) {
        return false;
    }
    takeGainAway(gain);
    return true;
}

void IslandSolver::substep(double h, int halvings) {
    bool const joined = exactContacts_ || !island_.joints.empty();
    if (joined && !relaxes_) {
        remember();
    }
    for (SlotIndex const slot : island_.bodies) {
        accelerate(slot, h);
        stateOf(slot).borne = Borne::not_at_all;
    }
    if (island_.joints.empty() && !exactContacts_) {
        int const rounds = contactRounds(h);
        auto const solve = [&](bool bias) {
            for (int i = 0; i < rounds; ++i) {
                solveContacts(h, bias);
            }
        };
        startRows(h);
        solve(true);
        if (excess(fastestParting) > 1) {
            startAnew();
            startRows(h);
            solve(true);
            takeGainAway(excess(fastestParting));
        }
        move(h);
        solve(false);
        takeGainAway(excess(slowestExcess));
    } else if (relaxes_) {
        relaxedSubstep(h);
    } else if (!joinedSubstep(h) && !bearable(h, halvings)) {
        bool const springs = !relaxes_ && gainOf(h) > 1;
        restore();
        if (springs) {
            forgetForces();
        }
        if (exactContacts_) { // for the rest of the step
            exactContacts_ = relaxes_ = false;
            substep(h, halvings);
            return;
        }
        if (!relaxes_ && halvings < mostHalvings && splits_ < mostSplits) {
            ++splits_;
            substep(h / 2, halvings + 1);
            substep(h / 2, halvings + 1);
            return;
        }
        relaxes_ = true; // for the rest of the step
        substep(h, halvings);
        return;
    }
    for (SlotIndex const slot : island_.bodies) {
        if (slot < engine_.dragged_.size() && engine_.dragged_[slot].drag.any()) {
            engine_.dragged_[slot].after({engine_.bodies_[slot].mass * stateOf(slot).velocity,
                                          engine_.bodies_[slot].inertia * stateOf(slot).spin});
        }
    }
    noteForces(h);
    since_ += h;
}

// Pieces that overlap on two sides are pressed ever harder by springs that contradict each other, without
// moving. This stress must not become motion when they slip.
double IslandSolver::excess(double fastest) const {
    double allowed = 0;
    double now = 0;
    for (SlotIndex const slot : island_.bodies) {
        BodyEntry const& entry = engine_.bodies_[slot];
        MovingState const& state = stateOf(slot);
        ImpactBudget::Body const free = beforeImpact(slot);
        allowed +=
            (1 + mostExcess) *
                std::max(kineticEnergy(entry.mass, entry.inertia, state.velocityBefore, state.spinBefore),
                         kineticEnergy(entry.mass, entry.inertia, free.velocity, free.spin)) +
            entry.mass * fastest * fastest / 2;
        now += kineticEnergy(entry.mass, entry.inertia, state.velocity, state.spin);
    }
    return now / allowed;
}

void IslandSolver::startAnew() {
    for (SlotIndex const slot : island_.bodies) {
        MovingState& state = stateOf(slot);
        state.velocity = state.velocityBefore + state.accelerated;
        state.spin = state.spinBefore + state.accelerates;
    }
    forgetForces();
}

void IslandSolver::forgetForces() {
    for (ContactRow& row : rows_) {
        row.detail->contact->force = row.detail->contact->drag = {};
    }
}

void IslandSolver::takeGainAway(double gain) {
    if (gain <= 1) {
        return;
    }
    double const share = std::sqrt(1 / gain);
    for (SlotIndex const slot : island_.bodies) {
        stateOf(slot).velocity *= share;
        stateOf(slot).spin *= share;
    }
}

ImpactBudget::Body IslandSolver::beforeImpact(SlotIndex slot) const {
    MovingState const& state = stateOf(slot);
    return {.inverseMass = state.inverseMass,
            .inverseInertia = state.inverseInertia,
            .centre = engine_.bodies_[slot].centre,
            .velocity = state.velocityBefore + state.accelerated,
            .spin = state.spinBefore + state.accelerates};
}

void IslandSolver::settleImpacts() {
    ImpactBudget& budget = engine_.budget_;
    double had = 0;
    double lost = 0;
    if (!budget.exceeded()) {
        budget.settleGroup(had, lost, engine_.impacts_);
        return;
    }
    for (SlotIndex const slot : island_.bodies) {
        BodyEntry const& entry = engine_.bodies_[slot];
        MovingState const& state = stateOf(slot);
        ImpactBudget::Body const before = beforeImpact(slot);
        double const energy = kineticEnergy(entry.mass, entry.inertia, before.velocity, before.spin);
        had += energy;
        lost += std::max(0.0, energy - kineticEnergy(entry.mass, entry.inertia, state.velocity, state.spin));
    }
    budget.settleGroup(had, lost, engine_.impacts_);
}

void IslandSolver::noteForces(double h) {
    double const rate = 1 / h;
    ImpactBudget& budget = engine_.budget_;
    budget.begin();
    for (ContactRow& row : rows_) {
        Contact& contact = *row.detail->contact;
        double sum = 0;
        for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
            contact.force[n] = row.points[n].normal * rate;
            contact.drag[n] = row.points[n].tangent * rate;
            sum += row.points[n].normal;
        }
        contact.pressed = contact.pressed || sum > 0;
        double const more = sum - h * contact.pressure;
        contact.pressure = sum * rate;
        if (auto const impact = impactOf(row, more)) {
            budget.add(*impact, stateOf(row.a).inverseMass > 0 ? row.a : row.b, beforeImpact(row.a),
                       beforeImpact(row.b));
        }
        row.awaits = false;
    }
    settleImpacts();
    for (SlotIndex const slot : island_.joints) {
        JointEntry& joint = engine_.joints_[slot];
        joint.force += joint.rows->impulseOnA(h) / engine_.duration_;
    }
}

std::optional<Impact> IslandSolver::impactOf(ContactRow const& row, double impulse) const {
    MovingState const& a = stateOf(row.a);
    MovingState const& b = stateOf(row.b);
    if (!engine_.impactsWanted_ || !(impulse * (a.inverseMass + b.inverseMass) > faintestImpact)) {
        return std::nullopt;
    }
    ObjectId const objectA = engine_.bodies_[row.a].object;
    ObjectId const objectB = engine_.bodies_[row.b].object;
    bool const swapped = objectB < objectA;
    std::array<Vec2, 2> const& reach = row.detail->reachA;
    Impact impact;
    impact.a = swapped ? objectB : objectA;
    impact.b = swapped ? objectA : objectB;
    impact.normal = swapped ? -row.normal : row.normal;
    impact.point = engine_.bodies_[row.a].centre + reach[0];
    if (row.count > 1) {
        impact.point += 0.5 * (reach[1] - reach[0]);
    }
    impact.impulse = impulse;
    impact.since = since_;
    return impact;
}

} // namespace trembler::native
