#include "tests/physics/electricity/oracle.hpp"

#include <algorithm>
#include <functional>
#include <numeric>

namespace trembler::test {

void Oracle::carryOut(std::vector<Script::Line> const& lines) {
    std::map<std::pair<Pair, std::size_t>, int> net;
    for (Script::Line const& line : lines) {
        if (line.a != line.b && parts.contains(line.a) && parts.contains(line.b)) {
            Pair const pair = std::minmax(line.a, line.b);
            net[{pair, line.script}] += line.add ? 1 : -1;
        }
    }
    for (auto const& [key, change] : net) {
        int& count = counts[key.first][key.second];
        count = std::max(0, count + change);
    }
}

void Oracle::destroy(ObjectId id) {
    parts.erase(id);
    std::erase_if(counts,
                  [&](auto const& entry) { return entry.first.first == id || entry.first.second == id; });
}

bool Oracle::connected(ObjectId a, ObjectId b) const {
    auto const at = counts.find(std::minmax(a, b));
    return at != counts.end() && std::accumulate(at->second.begin(), at->second.end(), 0) > 0;
}

std::set<std::string> Oracle::networks() const {
    std::set<std::string> names;
    for (auto const& [id, part] : parts) {
        if (part.source) {
            names.insert(*part.source);
        }
    }
    return names;
}

bool Oracle::takesPart(ObjectId id, std::string const& network) const {
    std::string const& own = parts.at(id).network;
    return own.empty() || own == network;
}

std::set<ObjectId> Oracle::onBySingleCable() const {
    std::set<ObjectId> on;
    for (std::string const& network : networks()) {
        std::map<ObjectId, ObjectId> leader;
        for (auto const& [id, part] : parts) {
            leader[id] = id;
        }
        std::function<ObjectId(ObjectId)> const find = [&](ObjectId id) {
            return leader[id] == id ? id : leader[id] = find(leader[id]);
        };
        for (auto const& [pair, count] : counts) {
            if (connected(pair.first, pair.second) && takesPart(pair.first, network) &&
                takesPart(pair.second, network)) {
                leader[find(pair.first)] = find(pair.second);
            }
        }
        std::set<ObjectId> live;
        for (auto const& [id, part] : parts) {
            if (part.source == network && takesPart(id, network)) {
                live.insert(find(id));
            }
        }
        for (auto const& [id, part] : parts) {
            if (live.contains(find(id))) {
                on.insert(id);
            }
        }
    }
    return on;
}

// Ford and Fulkerson (1956) with every object split into an entrance and an exit, joined by an arc for one
// unit.
bool Oracle::flowsFrom(ObjectId start, std::string const& network) const {
    std::vector<ObjectId> objects;
    for (auto const& [id, part] : parts) {
        if (takesPart(id, network)) {
            objects.push_back(id);
        }
    }
    std::size_t const n = objects.size();
    std::size_t const source = 2 * n;
    std::size_t const returning = 2 * n + 1;
    std::size_t const sink = 2 * n + 2;
    std::vector<std::vector<int>> room(sink + 1, std::vector<int>(sink + 1, 0));
    room[source][sink] = 1;
    room[returning][sink] = 1;
    std::size_t from = sink;
    for (std::size_t i = 0; i < n; ++i) {
        Part const& part = parts.at(objects[i]);
        if (objects[i] == start) {
            from = n + i;
        } else {
            room[i][n + i] = 1;
        }
        room[n + i][source] = part.source == network ? 1 : 0;
        room[n + i][returning] = part.returning == network ? 1 : 0;
        for (std::size_t j = 0; j < n; ++j) {
            if (i != j && connected(objects[i], objects[j]) && objects[j] != start) {
                room[n + i][j] = 1;
            }
        }
    }
    if (from == sink) {
        return false; // not part of this network
    }
    int flow = 0;
    while (true) {
        std::vector<std::size_t> cameFrom(sink + 1, sink + 1);
        std::vector<std::size_t> open{from};
        cameFrom[from] = from;
        while (!open.empty()) {
            std::size_t const here = open.back();
            open.pop_back();
            for (std::size_t next = 0; next <= sink; ++next) {
                if (room[here][next] > 0 && cameFrom[next] > sink) {
                    cameFrom[next] = here;
                    open.push_back(next);
                }
            }
        }
        if (cameFrom[sink] > sink) {
            return flow >= 2;
        }
        for (std::size_t at = sink; at != from; at = cameFrom[at]) {
            --room[cameFrom[at]][at];
            ++room[at][cameFrom[at]];
        }
        ++flow;
    }
}

std::set<ObjectId> Oracle::onByTwoWire() const {
    std::set<ObjectId> on;
    for (std::string const& network : networks()) {
        for (auto const& [id, part] : parts) {
            if (flowsFrom(id, network)) {
                on.insert(id);
            }
        }
    }
    return on;
}

} // namespace trembler::test
