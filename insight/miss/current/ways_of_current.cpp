#include "insight/miss/current/ways_of_current.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "physics/electricity/properties/graph.hpp"

#include <algorithm>
#include <deque>
#include <map>
#include <optional>
#include <set>
#include <utility>

namespace trembler::insight {
namespace {

using Way = std::pair<ObjectId, ObjectId>; // along a connection, from the first to the second

/// Paths from one object over connections, each of which is used once in each direction at most.
class WayFinder {
public:
    explicit WayFinder(Column<ElectricityGraph> const& graph) : graph_(graph) {}

    /// The connections that separate an object from those of the column if all of them are opened, as few as
    /// that takes: a minimum cut, the one nearest to the object. Empty if it is not connected with any.
    template <class End>
    [[nodiscard]] std::vector<CurrentWay> cut(ObjectId from, Column<End> const* ends) {
        used_.clear();
        while (ends != nullptr && add(from, *ends)) {
        }
        std::vector<CurrentWay> found;
        for (auto const& [a, b] : used_) {
            if (reached_.contains(a) && !reached_.contains(b)) {
                found.push_back({a, b});
            }
        }
        return found;
    }

private:
    /// Finds one more path, giving way on connections that earlier ones use in the other direction.
    template <class End>
    bool add(ObjectId from, Column<End> const& ends) {
        std::map<ObjectId, ObjectId>& before = reached_;
        before = {{from, from}};
        std::deque<ObjectId> open{from};
        std::optional<ObjectId> end;
        while (!open.empty() && !end) {
            ObjectId const at = open.front();
            open.pop_front();
            ElectricityGraph const* const row = graph_.find(at);
            if (row == nullptr) {
                continue;
            }
            for (ElectricityGraph::Connection const& next : row->connections) {
                if (used_.contains({at, next.to}) || !before.emplace(next.to, at).second) {
                    continue;
                }
                open.push_back(next.to);
                if (ends.has(next.to)) {
                    end = next.to;
                    break;
                }
            }
        }
        if (!end) {
            return false;
        }
        for (ObjectId at = *end; at != from; at = before.at(at)) {
            ObjectId const last = before.at(at);
            if (used_.erase({at, last}) == 0) {
                used_.emplace(last, at);
            }
        }
        return true;
    }

    Column<ElectricityGraph> const& graph_;
    std::set<Way> used_;
    std::map<ObjectId, ObjectId> reached_; // in the last search, each from another one
};

} // namespace

std::vector<CurrentWay> waysOfCurrent(World const& world, ObjectId object) {
    Store const& store = world.store();
    auto const* const graph = store.findColumn<ElectricityGraph>();
    auto const* const sources = store.findColumn<ElectricalSource>();
    auto const* const returns = store.findColumn<ElectricalReturn>();
    if (graph == nullptr || graph->find(object) == nullptr) {
        return {};
    }
    WayFinder finder(*graph);
    bool const isSource = sources != nullptr && sources->has(object);
    bool const isReturn = returns != nullptr && returns->has(object);
    auto toSources = finder.cut(object, sources);
    auto toReturns = finder.cut(object, returns);
    if (isSource && isReturn) {
        return {};
    }
    bool const bySources =
        isReturn ||
        (!isSource && (returns == nullptr || returns->size() == 0 || toSources.size() <= toReturns.size()));
    return bySources ? toSources : toReturns;
}

} // namespace trembler::insight
