#include "runtime/schedule/schedule.hpp"

#include "runtime/world/registry.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace trembler {
namespace {

std::vector<PropertyInfo const*> shared(std::vector<PropertyInfo const*> const& a,
                                        std::vector<PropertyInfo const*> const& b) {
    std::vector<PropertyInfo const*> both;
    std::copy_if(a.begin(), a.end(), std::back_inserter(both),
                 [&](PropertyInfo const* p) { return std::find(b.begin(), b.end(), p) != b.end(); });
    return both;
}

bool touchesObjects(ComponentInfo const& info) {
    return !info.reads.empty() || !info.writes.empty() || info.writesEverything;
}

} // namespace

std::vector<Conflict> conflicts(ComponentInfo const& a, ComponentInfo const& b) {
    std::vector<Conflict> all;
    if ((a.writesEverything && touchesObjects(b)) || (b.writesEverything && touchesObjects(a))) {
        all.push_back({Conflict::Kind::bothWrite, nullptr});
        return all;
    }
    for (PropertyInfo const* p : shared(a.writes, b.writes)) {
        all.push_back({Conflict::Kind::bothWrite, p});
    }
    for (PropertyInfo const* p : shared(a.writes, b.reads)) {
        all.push_back({Conflict::Kind::firstWritesRead, p});
    }
    for (PropertyInfo const* p : shared(a.reads, b.writes)) {
        all.push_back({Conflict::Kind::secondWritesRead, p});
    }
    return all;
}

void refuseDoubleWriters(ComponentInfo const& a, ComponentInfo const& b) {
    if (a.writesEverything && b.writesEverything) {
        throw RuleBroken(
            fmt::format("the {} and the {} both write everything; objects come and go by one resolver",
                        title(a), title(b)));
    }
    // The resolver that writes everything only creates objects with their first values and destroys them: on
    // creation it passes every property to the resolver that simulates it.
    for (PropertyInfo const* property : shared(a.writes, b.writes)) {
        throw RuleBroken(fmt::format("the {} and the {} both write {}; one property has one writer (5.4)",
                                     title(a), title(b), property->text.name));
    }
}

std::vector<std::pair<std::size_t, std::size_t>>
deriveEdges(std::span<ComponentInfo const* const> resolvers) {
    std::vector<std::pair<std::size_t, std::size_t>> edges;
    for (std::size_t i = 0; i < resolvers.size(); ++i) {
        for (std::size_t j = i + 1; j < resolvers.size(); ++j) {
            if (!mayRunTogether(*resolvers[i], *resolvers[j])) {
                edges.emplace_back(i, j);
            }
        }
    }
    return edges;
}

} // namespace trembler
