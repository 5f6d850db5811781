// Compared with all pairs of paths, tried one by one.
#include "insight/miss/current/two_paths.hpp"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <functional>
#include <limits>
#include <set>

namespace trembler::insight {
namespace {

struct DrawnLink {
    std::size_t a;
    std::size_t b;
    double cost;
};

/// The least cost of two paths from vertex 0 to `first` and to `second` that share only vertex 0.
double leastCostByTrial(std::size_t vertices, std::vector<DrawnLink> const& links, std::size_t first,
                        std::size_t second) {
    double best = std::numeric_limits<double>::infinity();
    std::set<std::size_t> visited{0};
    std::function<void(std::size_t, bool, double)> go = [&](std::size_t at, bool onSecond, double cost) {
        if (!onSecond && at == first) {
            go(0, true, cost);
            return;
        }
        if (onSecond && at == second) {
            best = std::min(best, cost);
            return;
        }
        for (DrawnLink const& link : links) {
            for (auto const& [from, to] : {std::pair{link.a, link.b}, std::pair{link.b, link.a}}) {
                if (from == at && visited.insert(to).second) {
                    go(to, onSecond, cost + link.cost);
                    visited.erase(to);
                }
            }
        }
    };
    static_cast<void>(vertices);
    go(0, false, 0);
    return best;
}

RC_GTEST_PROP(TwoPaths, CostAsMuchAsTheBestOfAllPairsOfPaths, ()) {
    auto const vertices = *rc::gen::inRange<std::size_t>(3, 7);
    std::vector<DrawnLink> links;
    for (std::size_t a = 0; a < vertices; ++a) {
        for (std::size_t b = a + 1; b < vertices; ++b) {
            if (*rc::gen::inRange(0, 3) > 0) {
                links.push_back({a, b, static_cast<double>(*rc::gen::inRange(0, 20))});
            }
        }
    }
    TwoPaths paths(vertices);
    for (std::size_t i = 0; i < links.size(); ++i) {
        paths.link(links[i].a, links[i].b, links[i].cost, i);
    }
    paths.endsAt(1, TwoPaths::End::first);
    paths.endsAt(2, TwoPaths::End::second);
    auto const found = paths.from(0, false);
    double const best = leastCostByTrial(vertices, links, 1, 2);
    RC_ASSERT(found.has_value() == (best < std::numeric_limits<double>::infinity()));
    if (found) {
        double cost = 0;
        for (std::size_t const i : *found) {
            cost += links[i].cost;
        }
        RC_ASSERT(std::abs(cost - best) < 1e-9);
    }
}

TEST(TwoPaths, AnEndItselfNeedsNoLink) {
    TwoPaths paths(2);
    paths.endsAt(0, TwoPaths::End::first);
    paths.endsAt(1, TwoPaths::End::second);
    paths.link(0, 1, 3, 7);
    EXPECT_EQ(paths.from(0, false), std::vector<std::size_t>{7});
}

TEST(TwoPaths, OneOfThemSufficesIfAsked) {
    TwoPaths paths(3);
    paths.endsAt(2, TwoPaths::End::first);
    paths.link(0, 1, 1, 0);
    paths.link(1, 2, 1, 1);
    EXPECT_EQ(paths.from(0, true), (std::vector<std::size_t>{0, 1}));
}

} // namespace
} // namespace trembler::insight
