#include "physics/dynamics/core/causes.hpp"

#include <algorithm>

namespace trembler {

void CauseBook::startActing(std::size_t slots) {
    causes_.resize(std::max(causes_.size(), slots));
    for (auto& causes : causes_) {
        for (Cause& cause : causes) {
            cause.acting = false;
        }
    }
}

bool CauseBook::insert(SlotIndex slot, EventId event, bool acting) {
    if (causes_.size() <= slot) {
        causes_.resize(slot + std::size_t{1});
    }
    auto& causes = causes_[slot];
    auto const at =
        std::find_if(causes.begin(), causes.end(), [&](Cause const& c) { return c.event == event; });
    if (at != causes.end()) {
        at->acting = at->acting || acting;
        return false;
    }
    changed_ = true;
    if (causes.size() == most) {
        causes.erase(std::min_element(causes.begin(), causes.end(), [](Cause const& x, Cause const& y) {
            return x.acting != y.acting ? y.acting : x.event < y.event;
        }));
    }
    causes.push_back({event, acting});
    return true;
}

void CauseBook::act(SlotIndex slot, EventId cause) {
    if (cause && insert(slot, cause, true)) {
        news_.push_back({slot, cause});
    }
}

void CauseBook::note(SlotIndex slot, EventId cause) {
    if (cause && insert(slot, cause, false)) {
        news_.push_back({slot, cause});
    }
}

void CauseBook::spread(BodyTable const& bodies, JointTable const& joints,
                       std::span<TouchingPair const> touching) {
    if (news_.empty()) {
        return;
    }
    std::vector<std::pair<SlotIndex, SlotIndex>> links;
    auto const link = [&](SlotIndex a, SlotIndex b) {
        if (a != noSlot && b != noSlot && !bodies[a].fixed && !bodies[b].fixed) {
            links.emplace_back(a, b);
            links.emplace_back(b, a);
        }
    };
    for (TouchingPair const& pair : touching) {
        link(bodies.slotOf(pair.a), bodies.slotOf(pair.b));
    }
    for (TiedJoint const& tied : joints.joints()) {
        if (tied.object.valid()) {
            link(tied.a, tied.b);
        }
    }
    std::sort(links.begin(), links.end());
    std::vector<SlotIndex> reached;
    for (News const& news : news_) {
        reached.assign(1, news.slot);
        for (std::size_t i = 0; i < reached.size() && reached.size() < reach; ++i) {
            auto at = std::lower_bound(links.begin(), links.end(), std::pair{reached[i], SlotIndex{0}});
            for (; at != links.end() && at->first == reached[i]; ++at) {
                if (std::find(reached.begin(), reached.end(), at->second) == reached.end()) {
                    reached.push_back(at->second);
                    insert(at->second, news.event, false);
                }
            }
        }
    }
    news_.clear();
}

void CauseBook::forget(SlotIndex slot) {
    if (slot < causes_.size()) {
        changed_ = changed_ || !causes_[slot].empty();
        causes_[slot].clear();
    }
    std::erase_if(news_, [&](News const& news) { return news.slot == slot; });
}

std::vector<EventId> CauseBook::of(SlotIndex a, SlotIndex b) const {
    std::vector<EventId> all;
    for (SlotIndex const slot : {a, b}) {
        if (slot < causes_.size()) {
            for (Cause const& cause : causes_[slot]) {
                all.push_back(cause.event);
            }
        }
    }
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
    return all;
}

} // namespace trembler
