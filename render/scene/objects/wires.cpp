#include "render/scene/objects/wires.hpp"

#include "physics/dynamics/properties/shape.hpp"
#include "physics/motor/properties.hpp"
#include "render/draw/path.hpp"
#include "render/scene/facts/pick.hpp"
#include "render/scene/facts/shape_geometry.hpp"
#include "render/scene/objects/body.hpp"
#include "render/scene/objects/device.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace trembler::render {
namespace {

constexpr double cableSag = 0.13;      // of the distance across
constexpr double beadSpacing = 0.16;   // m
constexpr double beadsPerSecond = 4.5; // how many pass a point

constexpr std::uint32_t unreached = 0xffffffffU;

// How many live connections lie between each object and the nearest of the ends given. Current runs from
// where the source is near to where the return is near: exact for chains, and a plausible direction for
// anything else.
std::vector<std::uint32_t> hopsFrom(FactsReader const& reader, Column<ElectricityGraph> const& graph,
                                    ElectricalState const& state, bool fromSource) {
    std::vector<std::uint32_t> hops;
    std::vector<ObjectId> queue;
    auto const reach = [&](ObjectId id, std::uint32_t distance) {
        hops.resize(std::max<std::size_t>(hops.size(), id.index + std::size_t{1}), unreached);
        if (hops[id.index] == unreached) {
            hops[id.index] = distance;
            queue.push_back(id);
        }
    };
    for (ObjectId const id : graph.owners()) {
        Facts const facts = reader.of(id);
        if (state.isOn(id) && (fromSource ? facts.source : facts.earth)) {
            reach(id, 0);
        }
    }
    std::size_t next = 0;
    while (next < queue.size()) { // the queue grows in the loop
        ObjectId const from = queue[next++];
        std::uint32_t const distance = hops[from.index];
        for (auto const& connection : graph[from].connections) {
            if (state.isOn(connection.to)) {
                reach(connection.to, distance + 1);
            }
        }
    }
    return hops;
}

double potential(std::vector<std::uint32_t> const& fromSource, std::vector<std::uint32_t> const& fromReturn,
                 ObjectId id) {
    auto const at = [&](std::vector<std::uint32_t> const& hops) {
        return id.index < hops.size() && hops[id.index] != unreached ? static_cast<double>(hops[id.index])
                                                                     : 1e9;
    };
    return at(fromReturn) / std::max(at(fromSource) + at(fromReturn), 1.0);
}

// Whether a joint holds its two objects against each other, so that a wire between them can run inside. A
// rope, say, may be the wire itself: it bounds how far the ends can move apart.
bool holdsTogether(JointForm form) {
    switch (form) {
    case JointForm::hinge:
    case JointForm::weld:
    case JointForm::slider:
    case JointForm::wheel:
        return true;
    case JointForm::distance:
    case JointForm::rope:
    case JointForm::pulley:
    case JointForm::gear:
    case JointForm::spring:
        return false;
    }
    return false;
}

// The pairs that a joint with the look "none" holds together, ascending.
std::vector<std::pair<ObjectId, ObjectId>> hiddenTies(World const& world) {
    std::vector<std::pair<ObjectId, ObjectId>> pairs;
    if (auto const* const joints = world.store().findColumn<Joint>()) {
        for (Joint const& joint : joints->values()) {
            if (hidesWires(joint)) {
                pairs.emplace_back(std::min(joint.a, joint.b), std::max(joint.a, joint.b));
            }
        }
    }
    std::sort(pairs.begin(), pairs.end());
    return pairs;
}

// A rectangle that the whole cable between two objects lies in.
Extent cableReach(Facts const& a, Pose const& poseA, Facts const& b, Pose const& poseB) {
    Extent around = extentOf(a, poseA);
    around.add(extentOf(b, poseB));
    for (Vec2 const* const axle : {a.axle, b.axle}) {
        if (axle != nullptr) {
            around.add(toPoint(*axle));
        }
    }
    return around.widened(around.empty() ? 0 : 2 * cableSag * around.half().x + cableWidth);
}

void drawEnd(Canvas& canvas, Facts const& facts, Point at, bool live) {
    if (facts.shape == nullptr || facts.coil != nullptr) {
        return; // signs need none, windings have their own
    }
    canvas.circle({at, 0}, std::min(0.85 * cableWidth, 0.45 * innerSize(facts)),
                  {.pattern = Pattern::Copper,
                   .tint = live ? mix(palette::copper, palette::live, 0.5F) : palette::copper,
                   .outline = 1.2F,
                   .height = 0.3F});
}

} // namespace

bool hidesWires(Joint const& joint) {
    return joint.look.drawn == JointDrawn::none && holdsTogether(joint.form);
}

std::vector<Link> linksOf(World const& world) {
    std::vector<Link> links;
    auto const* const graph = world.store().findColumn<ElectricityGraph>();
    if (graph == nullptr || graph->empty()) {
        return links;
    }
    auto const* const state = world.find<ElectricalState>();
    std::vector<std::uint32_t> fromSource;
    std::vector<std::uint32_t> fromReturn;
    if (state != nullptr) {
        FactsReader const reader(world);
        fromSource = hopsFrom(reader, *graph, *state, true);
        fromReturn = hopsFrom(reader, *graph, *state, false);
    }
    auto const hidden = hiddenTies(world);
    for (std::size_t row = 0; row < graph->size(); ++row) {
        ObjectId const a = graph->owners()[row];
        for (auto const& connection : graph->values()[row].connections) {
            if (a < connection.to && world.store().alive(connection.to)) {
                Link link{a, connection.to, connection.counts};
                link.live = state != nullptr && state->isOn(link.a) && state->isOn(link.b);
                link.forward =
                    potential(fromSource, fromReturn, link.a) >= potential(fromSource, fromReturn, link.b);
                link.inside = std::binary_search(hidden.begin(), hidden.end(), std::pair{link.a, link.b});
                links.push_back(link);
            }
        }
    }
    return links;
}

std::vector<Point> cablePath(Facts const& a, Pose const& poseA, Facts const& b, Pose const& poseB) {
    // The wires of a turning object leave through its axle, where they cross nothing and are not wound up.
    bool const apart = a.axle != b.axle;
    Vec2 const* const axleA = apart ? a.axle : nullptr;
    Vec2 const* const axleB = apart ? b.axle : nullptr;
    auto const endAt = [](Facts const& facts, Pose const& pose, Vec2 const* axle, Point towards) {
        return axle != nullptr ? toPoint(*axle) : terminalOf(facts, pose, towards);
    };
    Point const from = endAt(a, poseA, axleA, axleB != nullptr ? toPoint(*axleB) : poseB.at);
    Point const to = endAt(b, poseB, axleB, from);
    Point const start = endAt(a, poseA, axleA, to);
    // A cable a tenth longer than the way across hangs about this deep; one that hangs straight down does not
    // sag.
    Point const across = to - start;
    double const sag = cableSag * std::abs(across.x);
    double const parts = std::clamp(length(across) / 0.08, 6.0, 28.0);
    // A simulation with numbers that are not finite has no lengths.
    std::vector<Point> path = hangingWire(start, to, sag, std::isfinite(parts) ? static_cast<int>(parts) : 6);
    if (axleA != nullptr) {
        path.insert(path.begin(), terminalOf(a, poseA, start));
    }
    if (axleB != nullptr) {
        path.push_back(terminalOf(b, poseB, to));
    }
    return path;
}

void addGeneratorLines(World const& world, std::vector<Link>& links) {
    auto const* const generators = world.store().findColumn<Generator>();
    if (generators == nullptr) {
        return;
    }
    for (std::size_t row = 0; row < generators->size(); ++row) {
        ObjectId const own = generators->owners()[row];
        ObjectId const source = generators->values()[row].source;
        if (!world.store().alive(source) || world.find<Shape>(source) != nullptr) {
            continue;
        }
        Link const made{std::min(own, source), std::max(own, source), {}};
        auto const there = std::find_if(links.begin(), links.end(), [&](Link const& link) {
            return link.a == made.a && link.b == made.b;
        });
        Link& link = there != links.end() ? *there : links.emplace_back(made);
        link.line = true;
    }
}

std::vector<Point> loopedCable(Point from, Point to, double length) {
    constexpr int pieces = 40;
    constexpr double slackForLoop = 0.6; // m
    Point const middle = 0.5 * (from + to);
    double const span = render::length(to - from);
    // Handles that lie crosswise make a loop. They are as deep as the cable is long.
    double const aside = (length - span > slackForLoop ? 0.9 : -0.3) * span;
    double shallow = 0;
    double deep = 4 * length;
    std::vector<Point> path;
    for (int i = 0; i < 24; ++i) {
        double const depth = 0.5 * (shallow + deep);
        path = bezier(from, middle + Point{aside, -depth}, middle + Point{-aside, -depth}, to, pieces);
        (pathLength(path) < length ? shallow : deep) = depth;
    }
    return path;
}

void drawCable(Canvas& canvas, Facts const& a, Pose const& poseA, Facts const& b, Pose const& poseB,
               CableCurrent const& current) {
    drawCableAlong(canvas, cablePath(a, poseA, b, poseB), a, b, cableWidth, current);
}

void drawCableAlong(Canvas& canvas, std::vector<Point> path, Facts const& a, Facts const& b, double width,
                    CableCurrent const& current) {
    Stroke cable{.colour = current.live ? mix(palette::deadWire, palette::live, 0.75F) : palette::deadWire,
                 .width = width,
                 .pixels = 2.F,
                 .outline = 1.2F,
                 .round = true,
                 .height = 0.9F};
    if (width < canvas.metres(2)) { // seen from afar it is only a line
        cable.outline = 0;
        cable.round = false;
        cable.height = 0;
    }
    if (current.live) {
        cable.glow = {palette::live, 0.13, 0.75F};
    }
    canvas.polyline(path, cable);
    if (current.live) {
        if (!current.forward) {
            std::reverse(path.begin(), path.end());
        }
        canvas.beads(path, beadSpacing, current.time * beadsPerSecond, 0.55 * width, palette::liveCore);
        if (!current.forward) {
            std::reverse(path.begin(), path.end());
        }
    }
    drawEnd(canvas, a, path.front(), current.live);
    drawEnd(canvas, b, path.back(), current.live);
}

void drawWires(Canvas& canvas, FactsReader const& reader, std::vector<Link> const& links,
               PoseOf const& poseOf, double time) {
    Extent const view = viewOf(canvas.camera());
    for (Link const& link : links) {
        Facts const a = reader.of(link.a);
        Facts const b = reader.of(link.b);
        bool const laid = link.line || link.counts.of(CallerId::level()) > 0;
        if (link.inside || !laid || !a.visible() || !b.visible()) {
            continue;
        }
        Pose const poseA = poseOf(a);
        Pose const poseB = poseOf(b);
        if (!cableReach(a, poseA, b, poseB).widened(canvas.metres(20)).overlaps(view)) {
            continue;
        }
        drawCable(canvas, a, poseA, b, poseB, {link.live, link.forward, time});
    }
}

Link pickWire(World const& world, Point at, double tolerance) {
    FactsReader const reader(world);
    Link nearest;
    double least = tolerance;
    for (Link const& link : linksOf(world)) {
        Facts const a = reader.of(link.a);
        Facts const b = reader.of(link.b);
        if (link.inside || link.counts.of(CallerId::level()) <= 0 || !a.visible() || !b.visible()) {
            continue;
        }
        Pose const poseA = poseOf(a);
        Pose const poseB = poseOf(b);
        if (!cableReach(a, poseA, b, poseB).widened(tolerance).contains(at)) {
            continue;
        }
        std::vector<Point> const path = cablePath(a, poseA, b, poseB);
        for (std::size_t i = 1; i < path.size(); ++i) {
            Point const along = path[i] - path[i - 1];
            double const t =
                std::clamp(dot(at - path[i - 1], along) / std::max(dot(along, along), 1e-300), 0.0, 1.0);
            double const distance = length(at - path[i - 1] - t * along) - 0.5 * cableWidth;
            if (distance <= least) {
                least = distance;
                nearest = link;
            }
        }
    }
    return nearest;
}

} // namespace trembler::render
