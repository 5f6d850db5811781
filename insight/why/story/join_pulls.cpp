#include "insight/why/story/join_pulls.hpp"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <set>
#include <utility>

namespace trembler::insight {
namespace join_pulls {
namespace {

bool areAlike(ChainStep const& a, ChainStep const& b, SceneFacts const& facts) {
    if (!isPull(a.step.kind) || a.step.kind != b.step.kind || a.step.frame != b.step.frame ||
        a.proof != b.proof || a.step.objects.back() != b.step.objects.back()) {
        return false;
    }
    auto const role = facts.roles.find(a.step.objects.front());
    auto const other = facts.roles.find(b.step.objects.front());
    return role != facts.roles.end() && other != facts.roles.end() && role->second == other->second;
}

} // namespace
} // namespace join_pulls

void joinPulls(std::vector<ChainStep>& chain, SceneFacts const& facts) {
    std::vector<std::size_t> latestEffect(chain.size());
    for (std::size_t i = 0; i < chain.size(); ++i) {
        for (std::size_t const cause : chain[i].step.because) {
            latestEffect[cause] = i;
        }
    }
    std::vector<std::size_t> standsFor(chain.size()); // the step that stays
    std::iota(standsFor.begin(), standsFor.end(), std::size_t{0});
    for (std::size_t i = 0; i < chain.size(); ++i) {
        for (std::size_t other = 0; other < chain.size(); ++other) {
            if (latestEffect[other] > latestEffect[standsFor[i]] &&
                join_pulls::areAlike(chain[i], chain[other], facts)) {
                standsFor[i] = other;
            }
        }
    }
    std::vector<std::size_t> placeOf(chain.size());
    std::size_t count = 0;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        placeOf[i] = count;
        count += standsFor[i] == i ? 1 : 0;
    }
    std::vector<ChainStep> joined;
    for (std::size_t i = 0; i < chain.size(); ++i) {
        if (standsFor[i] != i) {
            continue;
        }
        std::set<std::size_t> because;
        for (std::size_t const cause : chain[i].step.because) {
            because.insert(placeOf[standsFor[cause]]);
        }
        joined.push_back(std::move(chain[i]));
        joined.back().step.because.assign(because.begin(), because.end());
    }
    chain = std::move(joined);
}

} // namespace trembler::insight
