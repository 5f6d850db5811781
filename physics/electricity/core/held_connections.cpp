#include "physics/electricity/core/held_connections.hpp"

#include <algorithm>
#include <string>
#include <tuple>
#include <utility>

namespace trembler {
namespace {

using Held = HeldConnections::Held;

auto identityOf(Held const& held) {
    return std::tie(held.a, held.b, held.caller);
}

} // namespace

std::vector<HeldConnections::Difference> HeldConnections::replace(std::vector<Held> now) {
    std::sort(now.begin(), now.end(), [](Held const& x, Held const& y) {
        return std::tie(x.a, x.b, x.caller, x.event) < std::tie(y.a, y.b, y.caller, y.event);
    });
    auto const same = [](Held const& x, Held const& y) { return identityOf(x) == identityOf(y); };
    now.erase(std::unique(now.begin(), now.end(), same), now.end());
    std::vector<Difference> differences;
    auto was = held_.begin();
    for (Held const& held : now) {
        for (; was != held_.end() && identityOf(*was) < identityOf(held); ++was) {
            differences.push_back({*was, -1});
        }
        if (was != held_.end() && identityOf(*was) == identityOf(held)) {
            ++was;
        } else {
            differences.push_back({held, 1});
        }
    }
    for (; was != held_.end(); ++was) {
        differences.push_back({*was, -1});
    }
    for (Difference& difference : differences) {
        if (difference.delta < 0) {
            difference.held.event = {}; // a held call that ends has no event
        }
    }
    held_ = std::move(now);
    return differences;
}

void HeldConnections::hash(StateHash& hash) const {
    if (held_.empty()) {
        return;
    }
    hash.integer(held_.size());
    for (Held const& held : held_) {
        hash.value(held.a);
        hash.value(held.b);
        hash.value(std::string(held.caller.name()));
    }
}

} // namespace trembler
