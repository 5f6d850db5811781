#include "physics/dynamics/engines/native/convex.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace trembler::native {
namespace {

// The second piece's side is the reference only if the first one is farther beyond it by this, m.
constexpr double clearlyFarther = 1e-4;
// Pieces closer than this, m, meet with their sides even if two corners are nearest.
constexpr double clearlyApart = 2e-4;

constexpr std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

// The pieces as the other sees them: corners and normals turned into the world's directions, about its own
// centre.
struct Turned {
    int count = 0;
    double radius = 0;
    std::array<Vec2, maximumCorners> corners;
    std::array<Vec2, maximumCorners> normals;

    // Relative to `origin`.
    Turned(Convex const& piece, Pose const& pose, Vec2 origin) : count(piece.count), radius(piece.radius) {
        Vec2 const shift = pose.at - origin;
        for (int i = 0; i < count; ++i) {
            corners[at(i)] = shift + pose.turn(piece.corners[at(i)]);
            normals[at(i)] = pose.turn(piece.normals[at(i)]);
        }
    }
    [[nodiscard]] int after(int i) const { return i + 1 < count ? i + 1 : 0; }
};

struct Axis {
    double separation = -std::numeric_limits<double>::infinity();
    int side = 0;
};

// The side of `a` that `b` is farthest beyond.
Axis farthestSide(Turned const& a, Turned const& b) {
    Axis best;
    for (int i = 0; i < a.count; ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (int j = 0; j < b.count; ++j) {
            least = std::min(least, dot(a.normals[at(i)], b.corners[at(j)] - a.corners[at(i)]));
        }
        if (least > best.separation) {
            best = {least, i};
        }
    }
    return best;
}

// The nearest points of two line segments p + s d1 and q + t d2, with s and t from 0 to 1.
struct Nearest {
    double s = 0;
    double t = 0;
};
Nearest nearestOnSegments(Vec2 p, Vec2 d1, Vec2 q, Vec2 d2) {
    double const a = dot(d1, d1);
    double const e = dot(d2, d2);
    Vec2 const r = p - q;
    double const f = dot(d2, r);
    double const c = dot(d1, r);
    double const b = dot(d1, d2);
    double const denominator = a * e - b * b;
    double s = denominator > 1e-18 * a * e ? std::clamp((b * f - c * e) / denominator, 0.0, 1.0) : 0.5;
    double t = (b * s + f) / e;
    if (t < 0) {
        t = 0;
        s = std::clamp(-c / a, 0.0, 1.0);
    } else if (t > 1) {
        t = 1;
        s = std::clamp((b - c) / a, 0.0, 1.0);
    }
    return {s, t};
}

Meeting single(Vec2 normal, Vec2 pointA, Vec2 pointB, Vec2 shiftB, double separation, std::uint32_t feature) {
    Meeting meeting;
    meeting.normal = normal;
    meeting.points[0] = {pointA, pointB - shiftB, separation, feature};
    meeting.count = 1;
    return meeting;
}

Meeting meetDiscs(Turned const& a, Turned const& b, Vec2 shiftB, double margin) {
    Vec2 const way = b.corners[0] - a.corners[0];
    double const distance = length(way);
    double const separation = distance - a.radius - b.radius;
    if (separation > margin) {
        return {};
    }
    Vec2 const normal = distance > 0 ? way / distance : Vec2{0, 1};
    return single(normal, a.corners[0], b.corners[0], shiftB, separation, 0);
}

// `a` has at least two corners, `b` is a disc.
Meeting meetDisc(Turned const& a, Turned const& b, Vec2 shiftB, double margin) {
    Vec2 const centre = b.corners[0];
    Axis const axis = farthestSide(a, b);
    double const radii = a.radius + b.radius;
    if (axis.separation > radii + margin) {
        return {};
    }
    int const i = axis.side;
    Vec2 const from = a.corners[at(i)];
    Vec2 const to = a.corners[at(a.after(i))];
    Vec2 const side = to - from;
    double const u = dot(centre - from, side);
    double const whole = dot(side, side);
    auto const corner = static_cast<std::uint32_t>(i);
    if (axis.separation > 0 && (u < 0 || u > whole)) {
        Vec2 const nearest = u < 0 ? from : to;
        Vec2 const way = centre - nearest;
        double const distance = length(way);
        if (distance - radii > margin) {
            return {};
        }
        Vec2 const normal = distance > 0 ? way / distance : a.normals[at(i)];
        return single(normal, nearest, centre, shiftB, distance - radii,
                      0x100U | corner << 1U | (u < 0 ? 0U : 1U));
    }
    Vec2 const normal = a.normals[at(i)];
    Meeting meeting =
        single(normal, centre - axis.separation * normal, centre, shiftB, axis.separation - radii, corner);
    meeting.sideOfA = true;
    return meeting;
}

// Both have at least two corners.
Meeting meetSides(Turned const& a, Turned const& b, Vec2 shiftB, double margin) {
    Axis const ofA = farthestSide(a, b);
    double const radii = a.radius + b.radius;
    if (ofA.separation > radii + margin) {
        return {};
    }
    Axis const ofB = farthestSide(b, a);
    if (ofB.separation > radii + margin) {
        return {};
    }
    // A side of a is preferred unless that of b is clearly farther, so that the reference rarely changes.
    bool const flip = ofB.separation > ofA.separation + clearlyFarther;
    Turned const& first = flip ? b : a;
    Turned const& second = flip ? a : b;
    int const side = flip ? ofB.side : ofA.side;
    double const separated = flip ? ofB.separation : ofA.separation;
    Vec2 const normal = first.normals[at(side)];
    // The side of the other that faces it most.
    int incident = 0;
    double most = std::numeric_limits<double>::infinity();
    for (int i = 0; i < second.count; ++i) {
        double const facing = dot(normal, second.normals[at(i)]);
        if (facing < most) {
            most = facing;
            incident = i;
        }
    }
    Vec2 const v1 = first.corners[at(side)];
    Vec2 const v2 = first.corners[at(first.after(side))];
    Vec2 const w1 = second.corners[at(incident)];
    Vec2 const w2 = second.corners[at(second.after(incident))];
    std::uint32_t const sides = static_cast<std::uint32_t>(side) << 4U |
                                static_cast<std::uint32_t>(incident) << 8U | (flip ? 0x1000U : 0U);
    if (separated > clearlyApart) {
        // Two corners may be nearest: then neither side's direction is that of the distance.
        Nearest const near = nearestOnSegments(v1, v2 - v1, w1, w2 - w1);
        bool const endOfFirst = near.s <= 0 || near.s >= 1;
        bool const endOfSecond = near.t <= 0 || near.t >= 1;
        if (endOfFirst && endOfSecond) {
            Vec2 const p = near.s <= 0 ? v1 : v2;
            Vec2 const q = near.t <= 0 ? w1 : w2;
            Vec2 const way = q - p;
            double const distance = length(way);
            if (distance - radii > margin) {
                return {};
            }
            // Exactly beyond the side's end the direction is the side's, and the clipped points are better.
            if (distance > separated * (1 + 1e-6) + 1e-12) {
                Vec2 const direction = way / distance;
                std::uint32_t const feature =
                    0x8000U | sides | (near.s <= 0 ? 1U : 0U) | (near.t <= 0 ? 2U : 0U);
                return flip ? single(-direction, q, p, shiftB, distance - radii, feature)
                            : single(direction, p, q, shiftB, distance - radii, feature);
            }
        }
    }
    // Clips the other's side to the reference side's ends.
    Vec2 const along = (v2 - v1) / length(v2 - v1);
    double const lower = dot(along, v1);
    double const upper = dot(along, v2);
    double const s1 = dot(along, w1);
    double const s2 = dot(along, w2);
    if ((s1 < lower && s2 < lower) || (s1 > upper && s2 > upper)) {
        return {};
    }
    Meeting meeting;
    meeting.normal = flip ? -normal : normal;
    (flip ? meeting.sideOfB : meeting.sideOfA) = true;
    auto const clipped = [&](Vec2 w, Vec2 other, double s, double t) {
        double const bound = std::clamp(s, lower, upper);
        return s == bound || s == t ? w : w + (bound - s) / (t - s) * (other - w);
    };
    for (int i = 0; i < 2; ++i) {
        Vec2 const w = i == 0 ? clipped(w1, w2, s1, s2) : clipped(w2, w1, s2, s1);
        double const gap = dot(normal, w - v1);
        if (gap - radii > margin) {
            continue;
        }
        Vec2 const onFirst = w - gap * normal;
        MeetingPoint& point = meeting.points[at(meeting.count++)];
        point.armA = flip ? w : onFirst;
        point.armB = (flip ? onFirst : w) - shiftB;
        point.separation = gap - radii;
        point.feature = sides | static_cast<std::uint32_t>(i);
    }
    return meeting;
}

Meeting mirrored(Meeting meeting) {
    meeting.normal = -meeting.normal;
    std::swap(meeting.sideOfA, meeting.sideOfB);
    for (MeetingPoint& point : meeting.points) {
        std::swap(point.armA, point.armB);
    }
    return meeting;
}

class PieceMaker {
public:
    explicit PieceMaker(BodySpec const& spec) : spec_(spec) {}

    void add(ShapePiece const& piece) {
        Convex& made = pieces_.emplace_back();
        made.piece = static_cast<std::uint32_t>(pieces_.size() - 1);
        switch (piece.form) {
        case ShapeForm::circle:
            made.radius = piece.radius;
            take(made, piece, {{}});
            break;
        case ShapeForm::box: {
            double const x = piece.width / 2;
            double const y = piece.height / 2;
            take(made, piece, {{-x, -y}, {x, -y}, {x, y}, {-x, y}});
            break;
        }
        case ShapeForm::polygon:
            take(made, piece, piece.corners);
            break;
        case ShapeForm::capsule: {
            double const half = piece.width / 2 - piece.radius;
            made.radius = piece.radius;
            if (half > shortest) {
                take(made, piece, {{-half, 0}, {half, 0}});
            } else {
                take(made, piece, {{}});
            }
            break;
        }
        }
    }
    [[nodiscard]] std::vector<Convex> finish() { return std::move(pieces_); }

private:
    static constexpr double shortest = 1e-6; // m, of a capsule's straight half

    void take(Convex& made, ShapePiece const& piece, std::vector<Vec2> const& corners) const {
        made.count = static_cast<int>(corners.size());
        for (std::size_t i = 0; i < corners.size(); ++i) {
            made.corners[i] = piece.at + rotated(corners[i], piece.angle) - spec_.spread.centre;
            if (corners.size() > 1) {
                Vec2 const side = corners[(i + 1) % corners.size()] - corners[i];
                made.normals[i] = rotated(-perpendicular(side) / length(side), piece.angle);
            }
        }
    }

    BodySpec const& spec_;
    std::vector<Convex> pieces_;
};

} // namespace

std::vector<Convex> convexPieces(BodySpec const& spec) {
    PieceMaker maker(spec);
    for (ShapePiece const& piece : spec.shape->pieces) {
        maker.add(piece);
    }
    return maker.finish();
}

Meeting meet(Convex const& a, Pose const& atA, Convex const& b, Pose const& atB, double margin) {
    if (a.disc() && !b.disc()) {
        return mirrored(meet(b, atB, a, atA, margin));
    }
    Vec2 const shift = atB.at - atA.at;
    Turned const first(a, atA, atA.at);
    Turned const second(b, atB, atA.at);
    if (a.disc()) {
        return meetDiscs(first, second, shift, margin);
    }
    return b.disc() ? meetDisc(first, second, shift, margin) : meetSides(first, second, shift, margin);
}

double gapBetween(Convex const& a, Pose const& atA, Convex const& b, Pose const& atB) {
    if (a.disc() && !b.disc()) {
        return gapBetween(b, atB, a, atA);
    }
    Turned const first(a, atA, atA.at);
    Turned const second(b, atB, atA.at);
    double const radii = a.radius + b.radius;
    if (a.disc()) {
        return length(second.corners[0] - first.corners[0]) - radii;
    }
    double gap = farthestSide(first, second).separation;
    if (!b.disc()) {
        return std::max(gap, farthestSide(second, first).separation) - radii;
    }
    // Beyond a corner the distance is that of the corner.
    for (int i = 0; i < first.count; ++i) {
        Vec2 const way = second.corners[0] - first.corners[at(i)];
        Vec2 const before = first.corners[at(i)] - first.corners[at(i == 0 ? first.count - 1 : i - 1)];
        Vec2 const after = first.corners[at(first.after(i))] - first.corners[at(i)];
        if (dot(way, before) > 0 && dot(way, after) < 0) {
            gap = std::max(gap, length(way));
        }
    }
    return gap - radii;
}

} // namespace trembler::native
