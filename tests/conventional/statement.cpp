#include "tests/conventional/statement.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>

namespace trembler::conventional {

Pose Statement::pose(std::string const& object, std::uint64_t frame, Moved const& moved) const {
    if (auto const at = moved.find(object); at != moved.end()) {
        return at->second;
    }
    auto const& poses = bodies_.poses[std::min<std::size_t>(frame, bodies_.poses.size() - 1)];
    auto const at = poses.find(object);
    return at == poses.end() ? Pose{} : at->second;
}

bool Statement::touching(std::string const& a, std::string const& b, std::uint64_t frame,
                         Moved const& moved) const {
    Pose const poseA = pose(a, frame, moved);
    Pose const poseB = pose(b, frame, moved);
    Shape const& shapeA = facts_.at(a).shape;
    Shape const& shapeB = facts_.at(b).shape;
    return poseA.there && poseB.there && !shapeA.pieces.empty() && !shapeB.pieces.empty() &&
           distance(outlinesOf(shapeA, poseA), outlinesOf(shapeB, poseB)) < touchingGap;
}

std::map<std::string, std::set<std::string>> Statement::connections(std::uint64_t frame,
                                                                    Moved const& moved) const {
    std::map<std::string, std::set<std::string>> all;
    auto const connect = [&](std::string const& a, std::string const& b) {
        all[a].insert(b);
        all[b].insert(a);
    };
    for (auto const& wire : setting_.level.at("connections")) {
        std::string const a = wire.at(0);
        std::string const b = wire.at(1);
        bool const cut =
            std::any_of(setting_.cuts.begin(), setting_.cuts.end(), [&](Setting::Cut const& one) {
                return one.frame <= frame && ((one.a == a && one.b == b) || (one.a == b && one.b == a));
            });
        if (!cut && pose(a, frame, moved).there && pose(b, frame, moved).there) {
            connect(a, b);
        }
    }
    for (auto a = facts_.begin(); a != facts_.end(); ++a) {
        for (auto b = std::next(a); b != facts_.end(); ++b) {
            if (a->second.conductor && b->second.conductor && touching(a->first, b->first, frame, moved)) {
                connect(a->first, b->first);
            }
        }
    }
    return all;
}

bool Statement::inCircuit(std::string const& object, std::uint64_t frame, Moved const& moved) const {
    if (!moved.empty()) {
        return findCircuit(object, frame, moved);
    }
    auto const [at, isNew] = known_.emplace(std::pair(object, frame), false);
    if (isNew) {
        at->second = findCircuit(object, frame, moved);
    }
    return at->second;
}

bool Statement::findCircuit(std::string const& object, std::uint64_t frame, Moved const& moved) const {
    auto const graph = connections(frame, moved);
    std::vector<std::string> path;
    // Every path that uses no object twice.
    std::function<bool(std::string const&)> const reaches = [&](std::string const& from) {
        path.push_back(from);
        bool found = facts_.at(from).earth && std::find(path.begin(), path.end(), object) != path.end();
        if (auto const at = graph.find(from); at != graph.end()) {
            for (std::string const& next : at->second) {
                found = found || (std::find(path.begin(), path.end(), next) == path.end() && reaches(next));
            }
        }
        path.pop_back();
        return found;
    };
    return std::any_of(facts_.begin(), facts_.end(), [&](auto const& entry) {
        return entry.second.source && pose(entry.first, frame, moved).there && reaches(entry.first);
    });
}

Vec2 Statement::force(std::string const& object, Vec2 at, std::uint64_t frame, Moved const& moved) const {
    constexpr double constant = 1e-7; // N/A²: µ0/4π
    Vec2 sum;
    for (auto const& [name, fact] : facts_) {
        Pose const magnet = pose(name, frame, moved);
        if (name == object || !(fact.strength > 0) || !magnet.there ||
            (fact.electromagnet && !inCircuit(name, frame, moved))) {
            continue;
        }
        for (Vec2 const pole : fact.poles) {
            Vec2 const away = magnet.at + rotated(pole, magnet.angle) - at;
            double const square = dot(away, away);
            sum += constant * fact.strength * facts_.at(object).susceptibility /
                   (square * std::sqrt(square)) * away;
        }
    }
    return sum;
}

} // namespace trembler::conventional
