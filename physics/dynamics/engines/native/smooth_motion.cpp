// Joined bodies that touch nothing: their motion is smooth, so it is integrated as an ordinary differential
// equation, by the pair of Runge-Kutta methods of orders 5 and 4 of J. R. Dormand and P. J. Prince (1980),
// with steps chosen by the estimate of their error. The accelerations follow from all joints at once (D.
// Baraff, "Linear-time dynamics using Lagrange multipliers", 1996); after each step places and velocities are
// put back onto the constraints.
#include "physics/dynamics/engines/native/island_solver.hpp"
#include "runtime/math/exact_math.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace trembler::native {
namespace {

// m or m/s times a frame, by which a step may be wrong.
constexpr double tolerance = 2e-7;
// Constraints that are off by more than this, m or rad, at the beginning are for the substeps to close.
constexpr double mostError = 1e-6;
// A limit that is nearer than this, m or rad, holds.
constexpr double atLimit = 1e-7;
// Contacts nearer than this, m, are for the substeps.
constexpr double clear = 1e-5;
constexpr int mostSteps = 300;
constexpr double leastShare = 1.0 / 512; // of a frame, as a step
constexpr double atEase = 1e300;

constexpr std::array<std::array<double, 6>, 6> tableau{
    {{1.0 / 5},
     {3.0 / 40, 9.0 / 40},
     {44.0 / 45, -56.0 / 15, 32.0 / 9},
     {19372.0 / 6561, -25360.0 / 2187, 64448.0 / 6561, -212.0 / 729},
     {9017.0 / 3168, -355.0 / 33, 46732.0 / 5247, 49.0 / 176, -5103.0 / 18656},
     {35.0 / 384, 0, 500.0 / 1113, 125.0 / 192, -2187.0 / 6784, 11.0 / 84}}};
constexpr std::array<double, 7> errorWeights{71.0 / 57600,      0,          -71.0 / 16695, 71.0 / 1920,
                                             -17253.0 / 339200, 22.0 / 525, -1.0 / 40};

} // namespace

class SmoothMotion {
public:
    SmoothMotion(IslandSolver& solver, double duration)
        : solver_(solver), engine_(solver.engine_), island_(solver.island_), duration_(duration) {
        std::size_t const size = island_.bodies.size();
        state_.resize(size);
        trial_.resize(size);
        for (std::vector<State>& slope : slopes_) {
            slope.resize(size);
        }
        engine_.indices_.resize(engine_.bodies_.size());
        engine_.follows_.assign(engine_.bodies_.size(), 1.0);
        for (std::size_t i = 0; i < size; ++i) {
            SlotIndex const slot = island_.bodies[i];
            engine_.indices_[slot] = static_cast<std::uint32_t>(i);
            BodyEntry const& entry = engine_.bodies_[slot];
            MovingState const& moving = engine_.states_[slot];
            state_[i] = {entry.centre, entry.angle, moving.velocity, moving.spin};
        }
    }

    double run() {
        if (!begins()) {
            return 0;
        }
        double& step = engine_.bodies_[island_.bodies[0]].smoothStep;
        double h = step > 0 ? std::min(step, duration_) : duration_ / 4;
        double time = 0;
        bool known = false; // the first slope
        for (int steps = 0; steps < mostSteps && time < duration_ * (1 - 1e-12); ++steps) {
            bool const last = h >= (duration_ - time) * (1 - 1e-9);
            double const size = last ? duration_ - time : h;
            if (!known && !slope(state_, slopes_[0])) {
                break;
            }
            known = true;
            // Impulses of a limit that has let go would hold it.
            if (letGo()) {
                known = false;
                continue;
            }
            double const error = attempt(size);
            double const change =
                error > 0 ? std::clamp(0.9 * exactExp(0.2 * exactLog(tolerance / error)), 0.2, 4.0) : 4.0;
            if (!(error <= tolerance)) {
                h = size * (std::isfinite(change) ? change : 0.2);
                if (h < leastShare * duration_ * 1e-3) {
                    break;
                }
                continue;
            }
            if (!project(trial_)) {
                break;
            }
            if (meetsSomething()) { // as near to it as is worth while
                if (size < leastShare * duration_) {
                    break;
                }
                h = size / 2;
                continue;
            }
            commit(size);
            time += size;
            known = false;
            if (!last || change < 1) {
                h = size * change;
            }
        }
        step = h;
        if (time > 0) {
            finish();
        }
        return time;
    }

private:
    struct State {
        Vec2 place;
        double angle = 0;
        Vec2 velocity;
        double spin = 0;
    };

    [[nodiscard]] std::vector<ExactRow>& rows() { return engine_.exact_.rows(); }

    // Whether only rigid joints, springs, and limits act.
    bool begins() {
        for (SlotIndex const slot : island_.bodies) {
            if (slot < engine_.dragged_.size() && engine_.dragged_[slot].drag.any()) {
                return false;
            }
        }
        solver_.makeRows();
        for (ContactRow const& row : solver_.rows_) {
            for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
                if (row.detail->gap[n] < clear) {
                    return false;
                }
            }
        }
        prepare(state_);
        for (SlotIndex const joint : island_.joints) {
            for (JointRow const& row : engine_.joints_[joint].rows->rows()) {
                bool const spring = !row.exact() && row.softness > 0;
                if (row.stiff != 0 && !spring && !row.exact()) {
                    return false; // a motor
                }
            }
        }
        solver_.takeExactRows(true);
        for (ExactRow& row : rows()) {
            if (row.oneSided) {
                if (row.error < -mostError) {
                    return false;
                }
                double const rate = rateIn(state_, row);
                row.active = row.error <= atLimit && std::abs(rate) <= 1e-6;
                if (row.error <= atLimit && rate < -1e-6) {
                    return false; // it strikes the limit
                }
            } else if (std::abs(row.error) > mostError || std::abs(rateIn(state_, row)) > 1e-3) {
                return false;
            }
        }
        return true;
    }

    void prepare(std::vector<State> const& at) {
        for (SlotIndex const slot : island_.joints) {
            JointRows& joint = *engine_.joints_[slot].rows;
            std::span<SlotIndex const> const slots = joint.slots();
            std::array<JointPose, 4> poses;
            for (std::size_t i = 0; i < slots.size(); ++i) {
                if (slots[i] == noSlot) {
                    continue;
                }
                MovingState const& moving = engine_.states_[slots[i]];
                if (engine_.moves(slots[i])) {
                    State const& state = at[engine_.indices_[slots[i]]];
                    poses[i] = {state.place,           state.angle,    moving.inverseMass,
                                moving.inverseInertia, state.velocity, state.spin};
                } else {
                    poses[i] = {engine_.bodies_[slots[i]].centre, engine_.bodies_[slots[i]].angle, 0, 0};
                }
            }
            joint.prepare({poses.data(), slots.size()}, duration_, atEase);
        }
    }

    [[nodiscard]] double rateIn(std::vector<State> const& at, ExactRow const& row) const {
        double rate = 0;
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
            ExactTerm const& term = row.terms[i];
            if (term.slot != noSlot) {
                State const& state = at[engine_.indices_[term.slot]];
                rate += dot(term.linear, state.velocity) + term.angular * state.spin;
            }
        }
        return rate;
    }

    // The rates of all places and velocities.
    bool slope(std::vector<State> const& at, std::vector<State>& slope) {
        prepare(at);
        solver_.takeExactRows(false);
        for (std::size_t i = 0; i < at.size(); ++i) {
            BodyEntry const& entry = engine_.bodies_[island_.bodies[i]];
            MovingState const& moving = engine_.states_[island_.bodies[i]];
            slope[i].place = at[i].velocity;
            slope[i].angle = at[i].spin;
            slope[i].velocity = moving.inverseMass * entry.load.force - entry.damping.linear * at[i].velocity;
            slope[i].spin = moving.inverseInertia * entry.load.torque - entry.damping.angular * at[i].spin;
        }
        std::vector<double>& right = engine_.right_;
        right.clear();
        for (SlotIndex const slot : island_.joints) {
            JointRows& joint = *engine_.joints_[slot].rows;
            std::span<SlotIndex const> const slots = joint.slots();
            for (JointRow const& row : joint.rows()) {
                if (row.exact()) {
                    if (row.stiff != 0) {
                        right.push_back(-row.bend);
                    }
                    continue;
                }
                double rate = 0;
                for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
                    SlotIndex const body = slots[static_cast<std::size_t>(row.terms[i].body)];
                    if (body != noSlot && engine_.moves(body)) {
                        State const& state = at[engine_.indices_[body]];
                        rate += dot(row.terms[i].linear, state.velocity) + row.terms[i].angular * state.spin;
                    }
                }
                double const pull = row.pull - row.damping * rate;
                for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
                    SlotIndex const body = slots[static_cast<std::size_t>(row.terms[i].body)];
                    if (body != noSlot && engine_.moves(body)) {
                        MovingState const& moving = engine_.states_[body];
                        State& rates = slope[engine_.indices_[body]];
                        rates.velocity += moving.inverseMass * pull * row.terms[i].linear;
                        rates.spin += moving.inverseInertia * pull * row.terms[i].angular;
                    }
                }
            }
        }
        if (rows().empty()) {
            return true;
        }
        for (std::size_t i = 0; i < rows().size(); ++i) {
            right[i] -= rateIn(slope, rows()[i]);
        }
        if (!engine_.exact_.factorise(engine_.states_, engine_.follows_)) {
            return false;
        }
        std::span<double const> const found = engine_.exact_.solve(right);
        for (std::size_t i = 0; i < rows().size(); ++i) {
            rows()[i].impulse = found[i]; // a force here
            give(slope, rows()[i], found[i], false);
        }
        return true;
    }

    // Adds an impulse to velocities, or a displacement to places.
    void give(std::vector<State>& to, ExactRow const& row, double size, bool places) const {
        for (std::size_t i = 0; i < static_cast<std::size_t>(row.count); ++i) {
            ExactTerm const& term = row.terms[i];
            if (term.slot != noSlot) {
                MovingState const& moving = engine_.states_[term.slot];
                State& state = to[engine_.indices_[term.slot]];
                (places ? state.place : state.velocity) += moving.inverseMass * size * term.linear;
                (places ? state.angle : state.spin) += moving.inverseInertia * size * term.angular;
            }
        }
    }

    bool letGo() {
        bool any = false;
        for (ExactRow& row : rows()) {
            if (row.oneSided && row.active && row.impulse < 0) {
                row.active = false;
                any = true;
            }
        }
        return any;
    }

    // A step of `h` (s) from state_ to trial_; returns the estimate of its error.
    double attempt(double h) {
        for (std::size_t stage = 0; stage < 6; ++stage) {
            for (std::size_t i = 0; i < state_.size(); ++i) {
                State sum = state_[i];
                for (std::size_t n = 0; n <= stage; ++n) {
                    double const weight = h * tableau[stage][n];
                    State const& slope = slopes_[n][i];
                    sum.place += weight * slope.place;
                    sum.angle += weight * slope.angle;
                    sum.velocity += weight * slope.velocity;
                    sum.spin += weight * slope.spin;
                }
                trial_[i] = sum;
            }
            if (!slope(trial_, slopes_[stage + 1])) {
                return std::numeric_limits<double>::infinity();
            }
        }
        double worst = 0;
        for (std::size_t i = 0; i < state_.size(); ++i) {
            State sum;
            for (std::size_t n = 0; n < 7; ++n) {
                double const weight = h * errorWeights[n];
                State const& slope = slopes_[n][i];
                sum.place += weight * slope.place;
                sum.angle += weight * slope.angle;
                sum.velocity += weight * slope.velocity;
                sum.spin += weight * slope.spin;
            }
            double const extent = engine_.bodies_[island_.bodies[i]].extent;
            double const error = length(sum.place) + extent * std::abs(sum.angle) +
                                 duration_ * (length(sum.velocity) + extent * std::abs(sum.spin));
            if (!(error <= worst)) {
                worst = error;
            }
        }
        return worst;
    }

    bool project(std::vector<State>& at) {
        if (rows().empty()) {
            return true;
        }
        for (int pass = 0; pass < 2; ++pass) {
            prepare(at);
            solver_.takeExactRows(false);
            std::vector<double>& right = engine_.right_;
            if (!engine_.exact_.factorise(engine_.states_, engine_.follows_)) {
                return false;
            }
            // Places first: the velocities belong to the places that come out.
            for (std::size_t i = 0; i < rows().size(); ++i) {
                right[i] = pass == 0 ? -rows()[i].error : -rateIn(at, rows()[i]);
            }
            std::span<double const> const found = engine_.exact_.solve(right);
            for (std::size_t i = 0; i < rows().size(); ++i) {
                give(at, rows()[i], found[i], pass == 0);
            }
        }
        return true;
    }

    // Whether the trial has run into a limit, a taut rope or another body.
    bool meetsSomething() {
        for (ExactRow const& row : rows()) {
            if (row.oneSided && !row.active && row.error < 0) {
                return true;
            }
        }
        if (solver_.rows_.empty()) {
            return false;
        }
        for (std::size_t i = 0; i < trial_.size(); ++i) {
            SlotIndex const slot = island_.bodies[i];
            MovingState& moving = engine_.states_[slot];
            saved_.resize(trial_.size());
            saved_[i] = {moving.moved, moving.turned, {}, 0};
            moving.moved += trial_[i].place - state_[i].place;
            setTurn(moving, moving.turned + trial_[i].angle - state_[i].angle);
        }
        bool meets = false;
        for (ContactRow const& row : solver_.rows_) {
            for (std::size_t n = 0; n < static_cast<std::size_t>(row.count); ++n) {
                meets = meets || solver_.gapOf(row, n) < clear / 2;
            }
        }
        if (meets) {
            for (std::size_t i = 0; i < trial_.size(); ++i) {
                MovingState& moving = engine_.states_[island_.bodies[i]];
                moving.moved = saved_[i].place;
                setTurn(moving, saved_[i].angle);
            }
        }
        return meets;
    }

    static void setTurn(MovingState& moving, double turned) {
        moving.turned = turned;
        auto const [cosine, sine] = exactTurn(turned);
        moving.cosine = cosine;
        moving.sine = sine;
    }

    void commit(double h) {
        state_.swap(trial_);
        std::size_t next = 0;
        for (SlotIndex const slot : island_.joints) {
            JointEntry& joint = engine_.joints_[slot];
            for (JointRow& row : joint.rows->rows()) {
                row.impulse = row.exact() && row.stiff != 0 ? h * rows()[next++].impulse : 0;
            }
            joint.force += joint.rows->impulseOnA(h) / engine_.duration_;
            joint.last = h;
        }
    }

    void finish() {
        for (std::size_t i = 0; i < state_.size(); ++i) {
            SlotIndex const slot = island_.bodies[i];
            BodyEntry& entry = engine_.bodies_[slot];
            entry.centre = state_[i].place;
            entry.angle = state_[i].angle;
            engine_.states_[slot].velocity = state_[i].velocity;
            engine_.states_[slot].spin = state_[i].spin;
            if (!isFinite(entry.centre) || !std::isfinite(entry.angle)) {
                throw EngineFailure("a body's place or speed is no finite number");
            }
        }
    }

    IslandSolver& solver_;
    NativeEngine& engine_;
    Island const& island_;
    double duration_;
    std::vector<State> state_;
    std::vector<State> trial_;
    std::vector<State> saved_;
    std::array<std::vector<State>, 7> slopes_;
};

double IslandSolver::moveSmoothly(double duration) {
    return SmoothMotion(*this, duration).run();
}

} // namespace trembler::native
