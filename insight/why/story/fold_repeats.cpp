#include "insight/why/story/fold_repeats.hpp"

#include "insight/why/story/deed_steps.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace trembler::insight {
namespace fold_repeats {
namespace {

constexpr std::size_t longestCycle = 24; // steps
constexpr std::size_t leastTimes = 3;

struct Block {
    std::size_t begin = 0;
    std::size_t period = 0; ///< steps
    std::size_t times = 0;

    [[nodiscard]] std::size_t size() const { return period * times; }
    /// Where the last time begins.
    [[nodiscard]] std::size_t last() const { return begin + period * (times - 1); }
};

bool isSame(ChainStep const& a, ChainStep const& b, SceneFacts const& facts) {
    auto const alike = [&](std::string const& one, std::string const& other) {
        auto const role = facts.roles.find(one);
        auto const otherRole = facts.roles.find(other);
        return one == other || (role != facts.roles.end() && otherRole != facts.roles.end() &&
                                role->second == otherRole->second);
    };
    return a.step.kind == b.step.kind && a.step.what == b.step.what && a.proof == b.proof &&
           !isDeed(a.step.kind) &&
           std::equal(a.step.objects.begin(), a.step.objects.end(), b.step.objects.begin(),
                      b.step.objects.end(), alike);
}

/// The repetition that begins there and takes in the most steps; of none times if there is none.
Block blockAt(std::vector<ChainStep> const& chain, std::size_t begin, SceneFacts const& facts) {
    Block best{begin, 0, 0};
    for (std::size_t period = 1; period <= longestCycle && begin + period < chain.size(); ++period) {
        std::size_t same = 0; // steps equal to the step one period before
        while (begin + period + same < chain.size() &&
               isSame(chain[begin + same], chain[begin + period + same], facts)) {
            ++same;
        }
        Block const block{begin, period, 1 + same / period};
        if (block.times >= leastTimes && block.size() > best.size()) {
            best = block;
        }
    }
    return best;
}

} // namespace
} // namespace fold_repeats

void foldRepeats(std::vector<ChainStep>& chain, SceneFacts const& facts) {
    using fold_repeats::Block;
    std::vector<ChainStep> folded;
    std::vector<std::set<std::size_t>> standsFor(
        chain.size()); // places in `folded`, of each step of the chain
    std::size_t cycles = 0;
    auto const keep = [&](std::size_t i) {
        std::set<std::size_t> because;
        for (std::size_t const cause : chain[i].step.because) {
            because.insert(standsFor[cause].begin(), standsFor[cause].end());
        }
        standsFor[i] = {folded.size()};
        folded.push_back(chain[i]);
        folded.back().step.because.assign(because.begin(), because.end());
    };
    for (std::size_t i = 0; i < chain.size();) {
        Block const block = fold_repeats::blockAt(chain, i, facts);
        if (block.times == 0) {
            keep(i++);
            continue;
        }
        std::set<std::size_t> entries; // steps outside the block that led to it
        for (std::size_t at = block.begin; at < block.last(); ++at) {
            for (std::size_t const cause : chain[at].step.because) {
                if (cause < block.begin) {
                    entries.insert(standsFor[cause].begin(), standsFor[cause].end());
                }
            }
        }
        for (std::size_t at = block.begin; at < block.last(); ++at) {
            standsFor[at] = entries;
        }
        ++cycles;
        for (std::size_t at = block.last(); at < block.begin + block.size(); ++at) {
            keep(at);
            folded.back().times = block.times;
            folded.back().cycle = cycles;
        }
        i += block.size();
    }
    chain = std::move(folded);
}

} // namespace trembler::insight
