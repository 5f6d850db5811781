#include "insight/miss/aftermath.hpp"

#include "insight/miss/lift/lift.hpp"

#include <algorithm>
#include <string_view>
#include <utility>

namespace trembler::insight {

void Aftermath::addParts(ConditionMiss const& one) {
    if (!one.state().condition().kind->needsAllChildren()) {
        parts_.push_back({&one, std::nullopt, std::nullopt});
        return;
    }
    for (ConditionMiss const& child : one.children()) {
        addParts(child);
    }
}

void Aftermath::begin(ConditionMiss const& goal, std::uint64_t frame, std::uint64_t missing) {
    parts_.clear();
    addParts(goal);
    until_ = frame + missing;
}

void Aftermath::look(World const& world, CircuitSight& circuits) {
    std::uint64_t const frame = world.frame();
    if (frame > until_) {
        return;
    }
    for (Part& part : parts_) {
        if (part.condition->state().holds()) {
            if (part.now && (!part.longest || part.now->frames > part.longest->frames)) {
                part.longest = std::move(part.now);
            }
            part.now.reset();
            continue;
        }
        Miss miss = part.condition->now(world, circuits);
        if (!part.now) {
            Miss first = miss;
            first.besides.clear();
            addLift(first, world, Rise::any); // in one frame it has hardly sunk
            for (Miss& other : first.besides) {
                other.frame = frame;
                nameObjects(other, world.store());
            }
            part.now = Break{frame, 0, {}, std::move(first.besides)};
            part.now->worst.measure = -1;
        }
        ++part.now->frames;
        if (miss.measure > part.now->worst.measure) {
            miss.frame = frame;
            nameObjects(miss, world.store());
            part.now->worst = std::move(miss);
        }
    }
}

Aftermath::Break const* Aftermath::longestOf(Part const& part) {
    Break const* const now = part.now ? &*part.now : nullptr;
    Break const* const before = part.longest ? &*part.longest : nullptr;
    return now == nullptr || (before != nullptr && before->frames >= now->frames) ? before : now;
}

std::vector<Miss> Aftermath::misses() const {
    std::vector<Break const*> breaks;
    for (Part const& part : parts_) {
        if (Break const* const one = longestOf(part)) {
            breaks.push_back(one);
        }
    }
    std::uint64_t longest = 0;
    for (Break const* const one : breaks) {
        longest = std::max(longest, one->frames);
    }
    std::erase_if(breaks, [&](Break const* one) { return one->frames < std::min(longest, bounce); });
    std::stable_sort(breaks.begin(), breaks.end(),
                     [](Break const* a, Break const* b) { return a->from < b->from; });
    std::vector<Miss> misses;
    for (Break const* const one : breaks) {
        misses.push_back(one->worst);
        misses.back().besides.insert(misses.back().besides.end(), one->lift.begin(), one->lift.end());
    }
    return misses;
}

} // namespace trembler::insight
