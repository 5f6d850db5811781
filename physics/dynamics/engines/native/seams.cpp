#include "physics/dynamics/engines/native/seams.hpp"

#include "physics/dynamics/engines/native/near_pairs.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::native {
namespace {

// Half of the length of surface that is looked at about a point.
constexpr double around = 4 * seamStep;
// Sine of the angle by which a direction may point into a neighbour.
constexpr double intoNeighbour = 1e-3;
// Cosine of the angle between two surfaces beyond which neither hides a contact with the other.
constexpr double squeezed = -0.98;

// Distance of a point outside of a piece; negative inside.
double depthOutside(Convex const& piece, Pose const& pose, Vec2 point) {
    Vec2 const own = pose.back(point - pose.at);
    if (piece.count == 1) {
        return length(own - piece.corners[0]) - piece.radius;
    }
    double most = -1e300;
    for (int i = 0; i < piece.count; ++i) {
        auto const n = static_cast<std::size_t>(i);
        most = std::max(most, dot(piece.normals[n], own - piece.corners[n]));
    }
    return most - piece.radius;
}

// One piece that a body meets, as seen from that body.
struct Met {
    std::size_t contact = 0;
    SlotIndex own = noSlot;   ///< the body
    SlotIndex other = noSlot; ///< the body of the piece
    std::uint32_t piece = 0;  ///< of the other
    Vec2 normal;              ///< from the other to the body
    bool sideOfOther = false;
};

// The ends of the side of a piece to which the direction belongs, in the world.
struct Side {
    Vec2 from;
    Vec2 to;
};
Side sideTowards(Convex const& piece, Pose const& pose, Vec2 direction) {
    Vec2 const own = pose.back(direction);
    std::size_t best = 0;
    for (std::size_t i = 1; i < static_cast<std::size_t>(piece.count); ++i) {
        if (dot(piece.normals[i], own) > dot(piece.normals[best], own)) {
            best = i;
        }
    }
    std::size_t const next = best + 1 < static_cast<std::size_t>(piece.count) ? best + 1 : 0;
    return {pose.place(piece.corners[best]), pose.place(piece.corners[next])};
}

// Whether a direction at a point of the surface points along that surface, or into the piece.
bool pointsAlong(Convex const& piece, Pose const& pose, Vec2 point, Vec2 direction) {
    Vec2 const own = pose.back(point - pose.at);
    Vec2 const way = pose.back(direction);
    for (int i = 0; i < piece.count && piece.count > 1; ++i) {
        auto const n = static_cast<std::size_t>(i);
        Vec2 const from = piece.corners[n];
        Vec2 const whole = piece.corners[i + 1 < piece.count ? n + 1 : 0] - from;
        double const size = length(whole);
        Vec2 const along = whole / size;
        double const here = dot(own - from, along);
        bool const near = std::abs(dot(own - from, piece.normals[n]) - piece.radius) <= seamStep &&
                          here >= -seamStep && here <= size + seamStep;
        double const least = std::min(around, size / 2);
        if (near && ((size - here >= least && dot(way, along) > intoNeighbour) ||
                     (here >= least && dot(way, along) < -intoNeighbour))) {
            return true;
        }
    }
    return false;
}

class Seams {
public:
    Seams(std::span<Contact* const> contacts, std::span<BodyEntry const> bodies,
          std::vector<Pose> const& poses)
        : contacts_(contacts), bodies_(bodies), poses_(poses) {}

    void find() {
        std::vector<Met> met;
        for (std::size_t i = 0; i < contacts_.size(); ++i) {
            Contact const& contact = *contacts_[i];
            if (!contact.used) {
                continue;
            }
            if (!bodies_[contact.a].fixed) {
                met.push_back({i, contact.a, contact.b, pieceOf(secondOf(contact.key)),
                               -contact.meeting.normal, contact.meeting.sideOfB});
            }
            if (!bodies_[contact.b].fixed) {
                met.push_back({i, contact.b, contact.a, pieceOf(firstOf(contact.key)), contact.meeting.normal,
                               contact.meeting.sideOfA});
            }
        }
        std::stable_sort(met.begin(), met.end(), [](Met const& x, Met const& y) { return x.own < y.own; });
        std::vector<std::size_t> seams;
        for (std::size_t first = 0; first < met.size();) {
            std::size_t last = first;
            while (last < met.size() && met[last].own == met[first].own) {
                ++last;
            }
            for (std::size_t i = first; i < last; ++i) {
                for (std::size_t j = first; j < last; ++j) {
                    if (i != j && hides(met[j], met[i])) {
                        seams.push_back(met[i].contact);
                        break;
                    }
                }
            }
            first = last;
        }
        for (std::size_t const i : seams) {
            contacts_[i]->used = false;
        }
    }

private:
    [[nodiscard]] Convex const& pieceIn(Met const& met) const { return bodies_[met.other].pieces[met.piece]; }

    // Whether the surface that `by` meets hides the contact `met` of the same body.
    [[nodiscard]] bool hides(Met const& by, Met const& met) const {
        double const cosine = dot(by.normal, met.normal);
        // Surfaces that face the same way are one; those that face each other hold the body between them.
        if (cosine > 1 - 1e-9 || cosine < squeezed || (by.other == met.other && by.piece == met.piece)) {
            return false;
        }
        Contact const& contact = *contacts_[met.contact];
        bool const otherIsA = contact.a == met.other;
        for (int i = 0; i < contact.meeting.count; ++i) {
            MeetingPoint const& point = contact.meeting.points[static_cast<std::size_t>(i)];
            Convex const& own = pieceIn(met);
            Vec2 const surface =
                poses_[met.other].at + (otherIsA ? point.armA : point.armB) + own.radius * met.normal;
            if (!hidesPoint(by, met, surface)) {
                return false;
            }
        }
        return contact.meeting.count > 0;
    }

    [[nodiscard]] bool hidesPoint(Met const& by, Met const& met, Vec2 point) const {
        Convex const& neighbour = pieceIn(by);
        Pose const& pose = poses_[by.other];
        double const reach = bodies_[by.other].extent + seamStep;
        if (lengthSquared(point - pose.at) > reach * reach ||
            depthOutside(neighbour, pose, point) > seamStep) {
            return false;
        }
        if (!met.sideOfOther) {
            return pointsAlong(neighbour, pose, point, met.normal);
        }
        Side const side = sideTowards(pieceIn(met), poses_[met.other], met.normal);
        Vec2 const whole = side.to - side.from;
        double const size = length(whole);
        Vec2 const along = whole / size;
        double const here = dot(point - side.from, along);
        for (double const way : {around, -around}) {
            double const there = std::clamp(here + way, 0.0, size);
            if (depthOutside(neighbour, pose, side.from + there * along) > seamStep) {
                return false;
            }
        }
        return true;
    }

    std::span<Contact* const> contacts_;
    std::span<BodyEntry const> bodies_;
    std::vector<Pose> const& poses_;
};

} // namespace

void leaveOutSeams(std::span<Contact* const> contacts, std::span<BodyEntry const> bodies,
                   std::vector<Pose> const& poses) {
    Seams(contacts, bodies, poses).find();
}

} // namespace trembler::native
