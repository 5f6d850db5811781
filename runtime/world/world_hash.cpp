// The hash of a world's state: two worlds with equal hashes are equal bit for bit, and so are their later
// frames.
#include "runtime/world/world.hpp"

#include <algorithm>

namespace trembler {

// Whether a component that would be constructed without subscriptions reads the property.
bool World::readHere(PropertyInfo const& property) const {
    return std::any_of(entries_.begin(), entries_.end(), [&](Entry const& entry) {
        auto const& reads = entry.status.info->reads;
        return entry.own && entry.component &&
               std::find(reads.begin(), reads.end(), &property) != reads.end();
    });
}

std::uint64_t World::stateHash() const {
    StateHash hash;
    store_.hash(hash);
    // The requested levels are hashed in addition to the constructed components: two requests that lead to
    // the same components now may lead to different components when the scene changes.
    hash.integer(options_.detail.size());
    for (auto const& [effect, level] : options_.detail) {
        hash.value(effect);
        hash.value(level);
    }
    std::vector<std::pair<std::string, Entry const*>> sorted; // independent of the order of registration
    for (Entry const& entry : entries_) {
        if (entry.component && entry.own) {
            sorted.emplace_back(title(*entry.status.info), &entry);
        }
    }
    std::sort(sorted.begin(), sorted.end());
    for (auto const& [name, entry] : sorted) {
        hash.value(name);
        auto const period = static_cast<std::uint64_t>(entry->status.period);
        hash.integer(period);
        hash.integer(now_.frame % period);
        for (PropertyInfo const* offer : entry->status.info->offers) {
            Coverage::Kind const kind = offer->coverage.kind;
            bool const old = kind == Coverage::Kind::derived && period > 1 && readHere(*offer);
            SlotBase const* const slot = store_.findSlot(*offer);
            if (slot != nullptr && (kind == Coverage::Kind::hashed || old)) {
                hash.value(std::string(offer->text.key));
                slot->hash(hash);
            }
        }
        entry->component->hashState(hash);
    }
    return hash.digest();
}

} // namespace trembler
