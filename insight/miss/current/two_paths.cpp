#include "insight/miss/current/two_paths.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <utility>

namespace trembler::insight {
namespace {

constexpr double tinyCost = 1e-12; // against endless improvements by rounding

} // namespace

TwoPaths::TwoPaths(std::size_t vertices) : sink_(2 * vertices + 2), edges_(2 * vertices + 3) {
    for (std::size_t v = 0; v < vertices; ++v) {
        edge(entry(v), exit(v), 1, 0, none);
    }
    edge(sink_ - 2, sink_, 1, 0, none); // all first ends
    edge(sink_ - 1, sink_, 1, 0, none); // all second ends
}

void TwoPaths::edge(std::size_t from, std::size_t to, int room, double cost, std::size_t name) {
    edges_[from].push_back({to, room, cost, edges_[to].size(), name});
    edges_[to].push_back({from, 0, -cost, edges_[from].size() - 1, none});
}

void TwoPaths::endsAt(std::size_t vertex, End end) {
    edge(exit(vertex), end == End::first ? sink_ - 2 : sink_ - 1, 1, 0, none);
}

void TwoPaths::link(std::size_t a, std::size_t b, double cost, std::size_t name) {
    edge(exit(a), entry(b), 1, cost, name);
    edge(exit(b), entry(a), 1, cost, name);
}

bool TwoPaths::augment(std::size_t source) {
    struct Reached {
        double cost = std::numeric_limits<double>::infinity();
        std::size_t before = none;
        std::size_t edge = none;
        bool waiting = false;
    };
    std::vector<Reached> reached(edges_.size());
    std::deque<std::size_t> open{source};
    reached[source].cost = 0;
    while (!open.empty()) {
        std::size_t const at = open.front();
        open.pop_front();
        reached[at].waiting = false;
        for (std::size_t i = 0; i < edges_[at].size(); ++i) {
            Edge const& next = edges_[at][i];
            double const cost = reached[at].cost + next.cost;
            if (next.room == 0 || !(cost < reached[next.to].cost - tinyCost)) {
                continue;
            }
            reached[next.to].cost = cost;
            reached[next.to].before = at;
            reached[next.to].edge = i;
            if (!std::exchange(reached[next.to].waiting, true)) {
                open.push_back(next.to);
            }
        }
    }
    if (reached[sink_].before == none) {
        return false;
    }
    for (std::size_t at = sink_; at != source; at = reached[at].before) {
        Edge& used = edges_[reached[at].before][reached[at].edge];
        --used.room;
        ++edges_[at][used.back].room;
    }
    return true;
}

std::optional<std::vector<std::size_t>> TwoPaths::from(std::size_t vertex, bool firstOnly) {
    if (firstOnly) { // no path may end at a second end
        edges_[sink_ - 1].front().room = 0;
    }
    for (int path = firstOnly ? 1 : 2; path > 0; --path) {
        if (!augment(exit(vertex))) {
            return std::nullopt;
        }
    }
    std::vector<std::size_t> used;
    for (auto const& edges : edges_) {
        for (Edge const& edge : edges) {
            if (edge.name != none && edge.room == 0) {
                used.push_back(edge.name);
            }
        }
    }
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    return used;
}

} // namespace trembler::insight
