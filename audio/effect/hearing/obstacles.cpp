#include "audio/effect/hearing/obstacles.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <queue>

namespace trembler {
namespace {

constexpr double graze = 1e-3;     // m: a line with a shorter part inside an obstacle does not meet it
constexpr double clearance = 2e-3; // m, distance of a way from a corner
constexpr int roundSides = 16;

void addArc(std::vector<Vec2>& corners, Vec2 centre, double radius, double from, double to, int sides) {
    // The corners lie outside of the circle, so that the sides touch it.
    double const step = (to - from) / sides;
    double const reach = radius / std::cos(step / 2);
    for (int i = 0; i < sides; ++i) {
        double const angle = from + (i + 0.5) * step;
        corners.push_back(centre + rotated({reach, 0}, angle));
    }
}

std::vector<Vec2> outlineOf(ShapePiece const& piece) {
    std::vector<Vec2> corners;
    switch (piece.form) {
    case ShapeForm::circle:
        addArc(corners, {}, piece.radius, 0, 2 * pi, roundSides);
        break;
    case ShapeForm::capsule: {
        double const half = std::max(0.0, piece.width / 2 - piece.radius);
        addArc(corners, {half, 0}, piece.radius, -pi / 2, pi / 2, roundSides / 2);
        addArc(corners, {-half, 0}, piece.radius, pi / 2, 3 * pi / 2, roundSides / 2);
        break;
    }
    case ShapeForm::box: {
        Vec2 const half{piece.width / 2, piece.height / 2};
        corners = {{-half.x, -half.y}, {half.x, -half.y}, half, {-half.x, half.y}};
        break;
    }
    case ShapeForm::polygon:
        corners = piece.corners;
        break;
    }
    return corners;
}

bool mayCross(Obstacle const& obstacle, Vec2 from, Vec2 to) {
    return std::max(from.x, to.x) >= obstacle.low.x && std::min(from.x, to.x) <= obstacle.high.x &&
           std::max(from.y, to.y) >= obstacle.low.y && std::min(from.y, to.y) <= obstacle.high.y;
}

} // namespace

void addObstacles(std::vector<Obstacle>& obstacles, ObjectId object, Shape const& shape, Vec2 at,
                  double angle, double density) {
    for (ShapePiece const& piece : shape.pieces) {
        Obstacle obstacle;
        obstacle.object = object;
        obstacle.density = density;
        obstacle.corners = outlineOf(piece);
        double const most = std::numeric_limits<double>::max();
        obstacle.low = {most, most};
        obstacle.high = {-most, -most};
        Vec2 const middle = at + rotated(piece.at, angle);
        double const turn = angle + piece.angle;
        double const c = std::cos(turn);
        double const s = std::sin(turn);
        for (Vec2& corner : obstacle.corners) {
            corner = middle + Vec2{c * corner.x - s * corner.y, s * corner.x + c * corner.y};
            obstacle.low = {std::min(obstacle.low.x, corner.x), std::min(obstacle.low.y, corner.y)};
            obstacle.high = {std::max(obstacle.high.x, corner.x), std::max(obstacle.high.y, corner.y)};
        }
        obstacles.push_back(std::move(obstacle));
    }
}

bool contains(Obstacle const& obstacle, Vec2 point) {
    std::size_t const n = obstacle.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec2 const corner = obstacle.corners[i];
        if (cross(obstacle.corners[i + 1 < n ? i + 1 : 0] - corner, point - corner) < 0) {
            return false;
        }
    }
    return true;
}

// Clips the line by the half planes of the sides (Cyrus and Beck).
double chordOf(Obstacle const& obstacle, Vec2 from, Vec2 to) {
    if (!mayCross(obstacle, from, to)) {
        return 0;
    }
    double enter = 0;
    double leave = 1;
    Vec2 const way = to - from;
    std::size_t const n = obstacle.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
        Vec2 const corner = obstacle.corners[i];
        Vec2 const side = obstacle.corners[i + 1 < n ? i + 1 : 0] - corner;
        double const inside = cross(side, from - corner); // above zero: inside of this side
        double const change = cross(side, way);
        if (change == 0) {
            if (inside <= 0) {
                return 0;
            }
        } else if (change > 0) {
            enter = std::max(enter, -inside / change);
        } else {
            leave = std::min(leave, -inside / change);
        }
    }
    return leave > enter ? (leave - enter) * length(way) : 0;
}

double detourAround(Obstacle const& obstacle, Vec2 from, Vec2 to) {
    // On each side: a taut string from one point to the other around the corners of that side. As the polygon
    // is convex, it is the hull of these corners and the two points, without the straight line.
    struct Passed {
        Vec2 corner;
        double along = 0;
    };
    thread_local std::vector<Vec2> string;   // both static to reuse their memory, as this function is called
    thread_local std::vector<Passed> passed; // very often
    Vec2 const way = to - from;
    auto const around = [&](double side) {
        passed.clear();
        for (Vec2 const corner : obstacle.corners) {
            if (side * cross(way, corner - from) > 0) {
                passed.push_back({corner, dot(way, corner - from)});
            }
        }
        std::sort(passed.begin(), passed.end(), [&](Passed const& a, Passed const& b) {
            return a.along != b.along ? a.along < b.along : side * cross(way, a.corner - b.corner) < 0;
        });
        passed.push_back({to});
        string.resize(passed.size() + 1);
        string[0] = from;
        std::size_t last = 0; // of the string
        for (Passed const& next : passed) {
            while (last >= 1 &&
                   side * cross(string[last] - string[last - 1], next.corner - string[last - 1]) >= 0) {
                --last;
            }
            string[++last] = next.corner;
        }
        double sum = 0;
        for (std::size_t i = 1; i <= last; ++i) {
            sum += length(string[i] - string[i - 1]);
        }
        return sum;
    };
    return std::min(around(1), around(-1));
}

double shortestWay(std::span<Obstacle const* const> obstacles, Vec2 from, Vec2 to, int patience) {
    std::vector<Vec2> nodes{from, to};
    for (Obstacle const* const solid : obstacles) {
        Obstacle const& obstacle = *solid;
        std::size_t const n = obstacle.corners.size();
        for (std::size_t i = 0; i < n; ++i) {
            Vec2 const corner = obstacle.corners[i];
            Vec2 const before = corner - obstacle.corners[(i + n - 1) % n];
            Vec2 const after = obstacle.corners[(i + 1) % n] - corner;
            Vec2 const outward = before / length(before) - after / length(after);
            double const size = length(outward);
            nodes.push_back(corner + (size > 0 ? clearance / size * outward : Vec2{}));
        }
    }
    auto const sees = [&](Vec2 a, Vec2 b) {
        return std::none_of(obstacles.begin(), obstacles.end(),
                            [&](Obstacle const* obstacle) { return chordOf(*obstacle, a, b) > graze; });
    };
    // A* over the visibility graph. The test whether two nodes see each other is expensive, so it is made
    // only for the first steps in the queue.
    struct Step {
        double estimate = 0; // of the whole way
        double gone = 0;
        std::uint32_t node = 0;
        std::uint32_t before = 0;
    };
    auto const later = [](Step const& a, Step const& b) {
        return a.estimate != b.estimate ? a.estimate > b.estimate
               : a.node != b.node       ? a.node > b.node
                                        : a.before > b.before;
    };
    std::priority_queue<Step, std::vector<Step>, decltype(later)> queue(later);
    std::vector<std::uint8_t> closed(nodes.size(), 0);
    queue.push({length(to - from), 0, 0, 0});
    while (!queue.empty() && patience > 0) {
        Step const step = queue.top();
        queue.pop();
        if (closed[step.node] != 0) {
            continue;
        }
        if (step.node != step.before) {
            --patience;
            if (!sees(nodes[step.before], nodes[step.node])) {
                continue;
            }
        }
        if (step.node == 1) {
            return step.gone;
        }
        closed[step.node] = 1;
        for (std::uint32_t next = 1; next < nodes.size(); ++next) {
            if (closed[next] == 0) {
                double const gone = step.gone + length(nodes[next] - nodes[step.node]);
                queue.push({gone + length(to - nodes[next]), gone, next, step.node});
            }
        }
    }
    return -1;
}

} // namespace trembler
