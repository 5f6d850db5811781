#include "render/scene/overlays/field_lines.hpp"

#include "runtime/placement.hpp"
#include "runtime/property/for_each.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace trembler::render {
namespace {

constexpr int mostSteps = 4000;
constexpr std::size_t none = static_cast<std::size_t>(-1);

/// A line as it was traced, and the pole where it ended (`none` if it left).
struct Trace {
    std::vector<Point> points;
    std::size_t endsAt = none;
    double arrival = 0; ///< rad, the direction in which that pole is left to go back along the line
};

class Tracer {
public:
    Tracer(std::span<FieldPole const> poles, Extent const& within, FieldLineOptions const& options)
        : poles_(poles), within_(within), softening_(options.softening), step_(options.step) {}

    // Follows the field (sign 1) or runs against it (sign -1).
    [[nodiscard]] Trace follow(std::size_t pole, double angle, double sign) const {
        Trace trace;
        Point const from = poles_[pole].at;
        Point at = from + clearance() * Point{std::cos(angle), std::sin(angle)};
        trace.points = {from, at};
        for (int i = 0; i < mostSteps; ++i) {
            std::optional<Point> const next = advance(at, sign);
            if (!next) {
                return trace; // the fields of all poles cancel here
            }
            at = *next;
            trace.points.push_back(at);
            if (std::size_t const end = capturedBy(at, sign); end != none) {
                trace.points.push_back(poles_[end].at);
                trace.endsAt = end;
                trace.arrival = std::atan2(at.y - poles_[end].at.y, at.x - poles_[end].at.x);
                return trace;
            }
            if (at.x < within_.lower.x || at.x > within_.upper.x || at.y < within_.lower.y ||
                at.y > within_.upper.y) {
                return trace;
            }
        }
        return trace;
    }

private:
    [[nodiscard]] double clearance() const { return std::max(softening_, 1.5 * step_); }

    [[nodiscard]] std::optional<Point> direction(Point at, double sign) const {
        Point const field = fieldAt(poles_, at, softening_);
        double const strength = length(field);
        if (!(strength > 1e-12) || !std::isfinite(strength)) {
            return std::nullopt;
        }
        return (sign / strength) * field;
    }

    [[nodiscard]] std::optional<Point> advance(Point at, double sign) const {
        auto const k1 = direction(at, sign);
        auto const k2 = k1 ? direction(at + (0.5 * step_) * *k1, sign) : std::nullopt;
        auto const k3 = k2 ? direction(at + (0.5 * step_) * *k2, sign) : std::nullopt;
        auto const k4 = k3 ? direction(at + step_ * *k3, sign) : std::nullopt;
        if (!k4) {
            return std::nullopt;
        }
        return at + (step_ / 6) * (*k1 + 2.0 * *k2 + 2.0 * *k3 + *k4);
    }

    [[nodiscard]] std::size_t capturedBy(Point at, double sign) const {
        for (std::size_t i = 0; i < poles_.size(); ++i) {
            if (sign * poles_[i].strength < 0 && length(poles_[i].at - at) < 0.9 * clearance()) {
                return i;
            }
        }
        return none;
    }

    std::span<FieldPole const> poles_;
    Extent within_;
    double softening_;
    double step_;
};

double angleBetween(double a, double b) {
    return std::abs(std::remainder(a - b, 2 * std::numbers::pi));
}

} // namespace

std::vector<FieldPole> activePoles(World const& world) {
    std::vector<FieldPole> poles;
    auto const* const strengths = world.store().findColumn<MagneticStrength>();
    auto const* const sets = world.store().findColumn<MagneticPoles>();
    auto const* const magnets = world.store().findColumn<Magnet>();
    auto const* const positions = world.store().findColumn<Position>();
    if (strengths == nullptr || sets == nullptr || magnets == nullptr || positions == nullptr) {
        return poles;
    }
    forEach(
        [&](ObjectId id, MagneticPoles const& set, MagneticStrength const& strength, Magnet const& magnet,
            Position const& position) {
            double const q = magnet.level * strength.strength;
            Rotation const* const rotation = world.find<Rotation>(id);
            double const angle = rotation == nullptr ? 0 : rotation->angle;
            auto const add = [&](PoleSet which, Vec2 place, double own) {
                if (q > 0 && (set.poles == which || set.poles == PoleSet::both)) {
                    poles.push_back({toPoint(position.value + rotated(place, angle)), own});
                }
            };
            add(PoleSet::north, set.north, q);
            add(PoleSet::south, set.south, -q);
        },
        *sets, *strengths, *magnets, *positions);
    return poles;
}

Point fieldAt(std::span<FieldPole const> poles, Point at, double softening) {
    Point sum;
    for (FieldPole const& pole : poles) {
        Point const r = at - pole.at;
        double const d2 = dot(r, r) + softening * softening;
        if (d2 > 0) {
            sum = sum + (pole.strength / (d2 * std::sqrt(d2))) * r;
        }
    }
    return sum;
}

std::vector<std::vector<Point>> fieldLines(std::span<FieldPole const> poles, Extent const& within,
                                           FieldLineOptions const& options) {
    std::vector<std::vector<Point>> lines;
    double strongest = 0;
    for (FieldPole const& pole : poles) {
        strongest = std::max(strongest, std::abs(pole.strength));
    }
    if (within.empty() || !(strongest > 0)) {
        return lines;
    }
    FieldLineOptions own = options;
    if (!(own.step > 0)) {
        own.step = std::max(within.half().x, within.half().y) / 400;
    }
    Tracer const tracer(poles, within, own);
    auto const share = [&](FieldPole const& pole) {
        return std::max(
            4, static_cast<int>(std::lround(own.linesPerPole * std::abs(pole.strength) / strongest)));
    };
    auto const angleOf = [](int line, int count) { return 2 * std::numbers::pi * (line + 0.5) / count; };
    std::vector<std::vector<double>> arrivals(poles.size());
    for (std::size_t p = 0; p < poles.size(); ++p) {
        for (int i = 0; poles[p].strength > 0 && i < share(poles[p]); ++i) {
            Trace trace = tracer.follow(p, angleOf(i, share(poles[p])), 1);
            if (trace.endsAt != none) {
                arrivals[trace.endsAt].push_back(trace.arrival);
            }
            lines.push_back(std::move(trace.points));
        }
    }
    for (std::size_t p = 0; p < poles.size(); ++p) {
        int const count = share(poles[p]);
        for (int i = 0; poles[p].strength < 0 && i < count; ++i) {
            double const angle = angleOf(i, count);
            bool const taken = std::any_of(arrivals[p].begin(), arrivals[p].end(), [&](double arrival) {
                return angleBetween(arrival, angle) < std::numbers::pi / count;
            });
            if (!taken) {
                Trace trace = tracer.follow(p, angle, -1);
                if (trace.endsAt == none) { // a line to a north pole is one of that pole's already
                    std::reverse(trace.points.begin(), trace.points.end());
                    lines.push_back(std::move(trace.points));
                }
            }
        }
    }
    return lines;
}

} // namespace trembler::render
