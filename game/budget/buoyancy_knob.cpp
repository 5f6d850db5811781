// The buoyancy knob: exact, or by a number of particles per body; each may be computed once in several
// frames.
#include "game/budget/force_sample.hpp"
#include "game/budget/knobs.hpp"
#include "game/budget/making_options.hpp"
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"
#include "physics/buoyancy/properties/results.hpp"
#include "physics/buoyancy/properties/settings.hpp"
#include "physics/depth.hpp"
#include "physics/dynamics/properties/shapes/shape_rules.hpp"
#include "runtime/placement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <memory>

namespace trembler::budget {
namespace buoyancy_knob {
namespace {

constexpr std::string_view effect = "buoyancy";
/// The error of the particles varies as a body moves slightly, so it is averaged over these shifts, up and
/// down, as shares of the body's size.
constexpr std::array<double, 3> shifts{0, 0.1, -0.1};

struct Liquids {
    std::vector<LiquidPiece> pieces;
    Vec2 up;
    double weight = 0; ///< N per m² of displaced area
};

struct Floater {
    Shape const* shape = nullptr;
    Vec2 at;
    double angle = 0;
    Vec2 velocity;
    double spin = 0;
    std::vector<Liquids> liquids;
};

using HullMaker = std::function<std::unique_ptr<Hull>(Shape const&)>;

struct Lift {
    Vec2 force;           ///< N
    Vec2 change;          ///< N/s, rate of change due to the body's motion, to first order
    double stiffness = 0; ///< N/m, against sinking deeper
};

Lift liftOf(Hull const& hull, Floater const& floater, Vec2 at, double angle) {
    Lift lift;
    Pose const pose(at, angle);
    for (Liquids const& liquid : floater.liquids) {
        Displacement sum;
        for (LiquidPiece const& piece : liquid.pieces) {
            sum += displacedOf(hull, piece, pose, liquid.up);
        }
        // A rising body loses displaced area along its waterline; see Waterline.
        double const growth =
            -(sum.waterline.length * dot(floater.velocity, liquid.up) + sum.waterline.first * floater.spin);
        lift.force += liquid.weight * sum.wet.area * liquid.up;
        lift.change += liquid.weight * growth * liquid.up;
        lift.stiffness += liquid.weight * sum.waterline.length;
    }
    return lift;
}

/// The immersed bodies of the sample with all that their lift is computed from.
class FloatingSample {
public:
    explicit FloatingSample(World const& world) {
        Immersions const* const immersions = world.find<Immersions>();
        auto const* const gravity = world.find<LinearGravityVector>();
        if (immersions == nullptr || gravity == nullptr) {
            return;
        }
        auto const& entries = immersions->entries;
        sample_ = sampleOf(world, [&](ObjectId id) {
            return std::any_of(entries.begin(), entries.end(), [&](auto const& e) { return e.object == id; });
        });
        for (Sample::Body const& body : sample_.bodies) {
            Floater floater;
            floater.shape = world.find<Shape>(body.object);
            floater.at = world.find<Position>(body.object)->value;
            floater.angle = angleOf(world, body.object);
            if (auto const* const velocity = world.find<Velocity>(body.object)) {
                floater.velocity = velocity->value;
            }
            if (auto const* const spin = world.find<AngularVelocity>(body.object)) {
                floater.spin = spin->value;
            }
            for (Immersions::Entry const& entry : entries) {
                Shape const* const area = world.find<Shape>(entry.liquid);
                Position const* const at = world.find<Position>(entry.liquid);
                if (entry.object == body.object && area != nullptr && at != nullptr) {
                    floater.liquids.push_back(
                        {liquidPieces(*area, Pose(at->value, angleOf(world, entry.liquid))), entry.up,
                         entry.density * worldDepth * Immersions::pull(entry, gravity->gravity)});
                }
            }
            floaters_.push_back(std::move(floater));
        }
        for (double const shift : shifts) {
            (void)shift;
            shifted_.bodies.insert(shifted_.bodies.end(), sample_.bodies.begin(), sample_.bodies.end());
        }
        right_ = forces(exactly);
        for (Floater const& floater : floaters_) {
            stiffness_.push_back(
                liftOf(ExactHull(*floater.shape), floater, floater.at, floater.angle).stiffness);
        }
        for (std::size_t i = 0; i < shifts.size(); ++i) {
            shiftedStiffness_.insert(shiftedStiffness_.end(), stiffness_.begin(), stiffness_.end());
        }
    }

    [[nodiscard]] std::size_t size() const { return floaters_.size(); }
    [[nodiscard]] Error errorOfHulls(HullMaker const& makeHull) const {
        return errorOf(shifted_, forces(makeHull), right_, shiftedStiffness_);
    }
    /// The error of forces that are reused for `period` frames. Looking ahead corrects it to first order.
    [[nodiscard]] Error errorOfPeriod(int period, bool lookAhead) const {
        double const age = (period - 1) / 2.0 * frameDuration;
        std::vector<Vec2> stale;
        std::vector<Vec2> fresh;
        for (Floater const& floater : floaters_) {
            ExactHull const hull(*floater.shape);
            Lift const before = liftOf(hull, floater, floater.at, floater.angle);
            stale.push_back(before.force + (lookAhead ? age : 0) * before.change);
            fresh.push_back(
                liftOf(hull, floater, floater.at + age * floater.velocity, floater.angle + age * floater.spin)
                    .force);
        }
        return errorOf(sample_, stale, fresh, stiffness_);
    }
    static std::unique_ptr<Hull> exactly(Shape const& shape) { return std::make_unique<ExactHull>(shape); }

private:
    static double angleOf(World const& world, ObjectId id) {
        Rotation const* const rotation = world.find<Rotation>(id);
        return rotation == nullptr ? 0 : rotation->angle;
    }
    [[nodiscard]] std::vector<Vec2> forces(HullMaker const& makeHull) const {
        std::vector<std::unique_ptr<Hull>> hulls;
        for (Floater const& floater : floaters_) {
            hulls.push_back(makeHull(*floater.shape));
        }
        std::vector<Vec2> all;
        for (double const shift : shifts) {
            for (std::size_t i = 0; i < floaters_.size(); ++i) {
                Vec2 const at = floaters_[i].at + Vec2{0, shift * hulls[i]->radius()};
                all.push_back(liftOf(*hulls[i], floaters_[i], at, floaters_[i].angle).force);
            }
        }
        return all;
    }

    Sample sample_;
    Sample shifted_; // the same bodies, once for each shift
    std::vector<Floater> floaters_;
    std::vector<Vec2> right_; // the exact forces on the shifted bodies, N
    std::vector<double> stiffness_;
    std::vector<double> shiftedStiffness_;
};

// µs per body on the machine of docs/measurements/accuracy.md.
constexpr double workOfExact = 0.083;
double workOfParticles(int count) {
    return 0.04 + 0.017 * count;
}

} // namespace
} // namespace buoyancy_knob

std::optional<Knob> buoyancyKnob(World const& world) {
    using namespace buoyancy_knob;
    auto const levels = levelsOf(world, effect);
    auto const now = working(levels);
    if (!now) {
        return std::nullopt;
    }
    FloatingSample const floating(world);
    auto const settings = settingsOf<BuoyancySettings>(world);
    Knob knob;
    knob.effect = effect;
    knob.of = "of the lift";
    knob.source = fmt::format("Measured on {} bodies that float, against exact sections of their shapes.",
                              floating.size());
    std::map<int, Error> stale;
    auto const add = [&](ComponentStatus const& level, Option made, Error const& error, bool current) {
        bool const isNow = level.info == now->info && current;
        made.makes.insert(made.makes.begin(), toLevel(effect, level.info->text.level));
        for (int const period : withCurrent(std::vector<int>{1, 2, 4, 8, 12}, isNow ? now->period : 1)) {
            Option option = made;
            runEvery(option, title(*level.info), period);
            auto const [at, isNew] = stale.try_emplace(period);
            if (isNew) {
                at->second = floating.errorOfPeriod(period, settings.lookAhead);
            }
            option.error = together(error, at->second);
            if (isNow && period == now->period) {
                knob.current = knob.options.size();
            }
            knob.options.push_back(std::move(option));
        }
    };
    for (ComponentStatus const& level : levels) {
        knob.components.push_back(title(*level.info));
        if (level.info->text.level == "exact") {
            add(level, {"exact", {}, workOfExact, {}, {}}, {}, true);
            continue;
        }
        for (int const count : withCurrent(std::vector<int>{4, 16, 64, 256}, settings.particles)) {
            Error const error = floating.errorOfHulls(
                [count](Shape const& shape) { return std::make_unique<ParticleHull>(shape, count); });
            add(level,
                {fmt::format("{} particles", count),
                 {toSetting(BuoyancySettings::text.key, "particles", count)},
                 workOfParticles(count),
                 {},
                 {}},
                error, count == settings.particles);
        }
    }
    return knob;
}

} // namespace trembler::budget
