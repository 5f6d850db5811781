// The components that a scene activates, and why: random components and scenes compared with a literal
// implementation of the definition.
#include "runtime/world/registry.hpp"
#include "tests/runtime/world/descriptions.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <iterator>
#include <tuple>
#include <utility>

namespace trembler {
namespace {

using namespace descriptions;

/// A literal implementation of the definition of selectComponents(): sets of names; each round examines
/// everything again and removes one component on demand, in an order that must not matter.
class Definition {
public:
    Definition(std::vector<ComponentInfo const*> infos, MadeUpScene const& scene)
        : infos_(std::move(infos)), scene_(scene) {}

    /// `order`: in which components are tried for removal.
    [[nodiscard]] std::set<std::size_t> chosen(std::vector<std::size_t> const& order) const {
        std::set<std::size_t> out;
        for (;;) {
            std::set<std::size_t> const now = chosenWithout(out);
            auto const unread = std::find_if(order.begin(), order.end(), [&](std::size_t number) {
                return now.contains(number) && infos_[number]->onDemand && !isRead(number, now);
            });
            if (unread == order.end()) {
                return now;
            }
            for (std::size_t other = 0; other < infos_.size(); ++other) {
                if (other == *unread || areAlternatives(*infos_[other], *infos_[*unread])) {
                    out.insert(other);
                }
            }
        }
    }
    /// The components that are possible without `out`: the least closed set.
    [[nodiscard]] std::set<std::size_t> candidates(std::set<std::size_t> const& out) const {
        std::set<std::size_t> all;
        for (bool more = true; more;) {
            more = false;
            for (std::size_t number = 0; number < infos_.size(); ++number) {
                if (!all.contains(number) && !out.contains(number) && isActivated(number) &&
                    hasAllItReads(number, all) && hasResolver(number, all)) {
                    all.insert(number);
                    more = true;
                }
            }
        }
        return all;
    }
    [[nodiscard]] bool isActivated(std::size_t number) const {
        auto const there = [&](PropertyInfo const* p) {
            return scene_.inhabited.contains(std::string(p->text.key));
        };
        auto const& all = infos_[number]->neededAll;
        auto const& any = infos_[number]->neededAny;
        return std::all_of(all.begin(), all.end(), there) &&
               (any.empty() || std::any_of(any.begin(), any.end(), there));
    }
    [[nodiscard]] bool hasResolver(std::size_t number, std::set<std::size_t> const& among) const {
        ComponentInfo const& info = *infos_[number];
        return info.kind != ComponentKind::interaction ||
               std::any_of(among.begin(), among.end(), [&](std::size_t other) {
                   return infos_[other]->kind == ComponentKind::resolver && infos_[other]->role == info.role;
               });
    }

private:
    [[nodiscard]] static bool lists(std::vector<PropertyInfo const*> const& list,
                                    PropertyInfo const* property) {
        return std::find(list.begin(), list.end(), property) != list.end();
    }
    [[nodiscard]] bool hasAllItReads(std::size_t number, std::set<std::size_t> const& among) const {
        auto const& reads = infos_[number]->reads;
        return std::all_of(reads.begin(), reads.end(), [&](PropertyInfo const* read) {
            return read->kind == PropertyKind::object ||
                   std::any_of(among.begin(), among.end(),
                               [&](std::size_t other) { return lists(infos_[other]->offers, read); });
        });
    }
    [[nodiscard]] bool isRead(std::size_t number, std::set<std::size_t> const& among) const {
        auto const& offers = infos_[number]->offers;
        return std::any_of(offers.begin(), offers.end(), [&](PropertyInfo const* offer) {
            return scene_.subscribed.contains(std::string(offer->text.key)) ||
                   std::any_of(among.begin(), among.end(),
                               [&](std::size_t other) { return lists(infos_[other]->reads, offer); });
        });
    }
    /// Whether one alternative takes precedence over another: requested, then suitable, then rank, then
    /// registration.
    [[nodiscard]] bool isBefore(std::size_t a, std::size_t b) const {
        auto const asked = [&](std::size_t number) {
            auto const at = scene_.detail.find(std::string(infos_[number]->text.effect));
            return at != scene_.detail.end() && at->second == infos_[number]->text.level;
        };
        auto const place = [&](std::size_t number) {
            bool const suits = !scene_.unsuitable.contains(number);
            int const rank = asked(number) || !suits ? 0 : infos_[number]->text.rank;
            return std::tuple(!asked(number), !asked(number) && !suits, rank, number);
        };
        return place(a) < place(b);
    }
    [[nodiscard]] std::set<std::size_t> chosenWithout(std::set<std::size_t> const& out) const {
        std::set<std::size_t> const all = candidates(out);
        std::set<std::size_t> best;
        for (std::size_t const number : all) {
            if (std::none_of(all.begin(), all.end(), [&](std::size_t other) {
                    return other != number && areAlternatives(*infos_[other], *infos_[number]) &&
                           isBefore(other, number);
                })) {
                best.insert(number);
            }
        }
        return best;
    }

    std::vector<ComponentInfo const*> infos_;
    MadeUpScene const& scene_;
};

Descriptions::Names someOf(std::vector<std::string> const& names, int most) {
    int const count = *rc::gen::inRange(0, most + 1);
    Descriptions::Names some;
    for (int i = 0; i < count && !names.empty(); ++i) {
        some.push_back(*rc::gen::elementOf(names));
    }
    return some;
}

std::set<std::string> subsetOf(std::vector<std::string> const& names, int percent) {
    std::set<std::string> some;
    for (std::string const& name : names) {
        if (*rc::gen::inRange(0, 100) < percent) {
            some.insert(name);
        }
    }
    return some;
}

/// Valid components or, with `circles`, components that may read everything; then none is on demand.
Descriptions randomDescriptions(bool circles) {
    std::vector<std::string> const objects{"o1", "o2", "o3", "o4"};
    std::vector<std::string> const levels{"", "rough", "fine"};
    std::vector<std::string> provided;
    std::vector<std::string> derived;
    for (int role = 0; role < 4; ++role) {
        provided.push_back("r" + std::to_string(role));
    }
    for (int set = 0; set < 4; ++set) {
        derived.push_back("d" + std::to_string(set));
    }
    std::vector<std::string> every = provided;
    every.insert(every.end(), derived.begin(), derived.end());
    every.emplace_back("nobody's");
    Descriptions made;
    int const count = *rc::gen::inRange(0, 24);
    for (int i = 0; i < count; ++i) {
        int const kind = *rc::gen::inRange(0, 3);
        auto const place = static_cast<std::size_t>(*rc::gen::inRange(0, 4));
        Descriptions::Stated stated{.name = std::to_string(i),
                                    .level = *rc::gen::elementOf(levels),
                                    .rank = *rc::gen::inRange(-1, 3),
                                    .needs = someOf(objects, 1),
                                    .needsAny = someOf(objects, 2),
                                    .reads = {},
                                    .offers = {},
                                    .role = static_cast<int>(place),
                                    .onDemand = *rc::gen::inRange(0, 2) == 1};
        stated.onDemand = stated.onDemand && !circles;
        if (kind == 0) {
            stated.reads = someOf(circles ? every : objects, 2);
            stated.offers = {provided[place]};
            made.resolver(stated);
        } else if (kind == 1) {
            stated.reads = someOf(circles ? every : provided, 2);
            stated.offers = {derived[place], "second of " + derived[place]};
            made.dps(stated);
        } else {
            stated.reads = someOf(every, 2);
            stated.onDemand = false;
            made.interaction(stated);
        }
    }
    return made;
}

MadeUpScene randomScene(std::size_t components) {
    MadeUpScene scene{.inhabited = subsetOf({"o1", "o2", "o3", "o4"}, 75),
                      .subscribed = subsetOf({"r0", "r1", "r2", "r3", "d0", "d1", "d2", "d3"}, 15)};
    if (*rc::gen::inRange(0, 2) == 1) {
        scene.detail["effect"] = *rc::gen::element<std::string>("rough", "fine", "none such");
    }
    for (std::size_t number = 0; number < components; ++number) {
        if (*rc::gen::inRange(0, 3) == 0) {
            scene.unsuitable.insert(number);
        }
    }
    return scene;
}

std::vector<std::size_t> randomOrder(std::size_t count) {
    std::vector<std::size_t> order;
    for (std::size_t number = 0; number < count; ++number) {
        order.insert(order.begin() + *rc::gen::inRange<std::ptrdiff_t>(0, std::ssize(order) + 1), number);
    }
    return order;
}

/// Checks each reason against the descriptions. (RC_ASSERT evaluates both sides of an && or || that is not in
/// parentheses.)
void expectTrueReasons(std::vector<ComponentInfo const*> const& infos, MadeUpScene const& scene,
                       std::vector<Choice> const& choices, Definition const& definition,
                       std::set<std::size_t> const& chosen) {
    std::set<std::size_t> const candidates = definition.candidates({});
    for (std::size_t number = 0; number < choices.size(); ++number) {
        Choice const& choice = choices[number];
        ComponentInfo const& info = *infos[number];
        auto const isAlternative = [&](std::size_t other) {
            return other != number && areAlternatives(info, *infos[other]);
        };
        std::set<std::size_t> rivals;
        std::copy_if(candidates.begin(), candidates.end(), std::inserter(rivals, rivals.end()),
                     isAlternative);
        auto const there = std::find_if(chosen.begin(), chosen.end(), isAlternative);
        RC_ASSERT(choice.alternative == (there == chosen.end() ? std::nullopt : std::optional(*there)));
        bool const asked = scene.detail.contains("effect") && scene.detail.at("effect") == info.text.level;
        auto const suits = [&](std::size_t other) { return !scene.unsuitable.contains(other); };
        switch (choice.reason) {
        case ChoiceReason::undecided:
            RC_FAIL("a component was forgotten");
            break;
        case ChoiceReason::levelAskedFor:
            RC_ASSERT(asked);
            break;
        case ChoiceReason::onlyCandidate:
            RC_ASSERT((!asked && rivals.empty()));
            break;
        case ChoiceReason::leastRank:
            RC_ASSERT((!asked && !rivals.empty() && suits(number)));
            for (std::size_t const rival : rivals) {
                RC_ASSERT((!suits(rival) || infos[rival]->text.rank >= info.text.rank));
            }
            break;
        case ChoiceReason::noneSuits:
            RC_ASSERT((!asked && !rivals.empty() && !suits(number)));
            RC_ASSERT(std::none_of(rivals.begin(), rivals.end(), suits));
            break;
        case ChoiceReason::noObjects:
            RC_ASSERT(!definition.isActivated(number));
            RC_ASSERT((choice.property == nullptr ||
                       !scene.inhabited.contains(std::string(choice.property->text.key))));
            break;
        case ChoiceReason::noResolver:
            RC_ASSERT((definition.isActivated(number) && !definition.hasResolver(number, chosen)));
            break;
        case ChoiceReason::noProvider:
            RC_ASSERT((definition.isActivated(number) && !candidates.contains(number)));
            RC_ASSERT(std::find(info.reads.begin(), info.reads.end(), choice.property) != info.reads.end());
            for (std::size_t const other : candidates) {
                auto const& offers = infos[other]->offers;
                RC_ASSERT(std::find(offers.begin(), offers.end(), choice.property) == offers.end());
            }
            break;
        case ChoiceReason::notRead:
            RC_ASSERT((candidates.contains(number) && there == chosen.end()));
            break;
        case ChoiceReason::alternativeChosen:
            RC_ASSERT((candidates.contains(number) && there != chosen.end()));
            break;
        }
    }
}

void expectTheDefinition(bool circles) {
    Descriptions const descriptions = randomDescriptions(circles);
    std::vector<ComponentInfo const*> const infos = descriptions.list();
    MadeUpScene const scene = randomScene(infos.size());
    Definition const definition(infos, scene);
    std::set<std::size_t> const expected = definition.chosen(randomOrder(infos.size()));
    std::vector<std::size_t> const chosen = chosenIn(descriptions, scene);
    RC_ASSERT(std::set<std::size_t>(chosen.begin(), chosen.end()) == expected);
    expectTrueReasons(infos, scene, choicesIn(descriptions, scene), definition, expected);
}

TEST(Selection, FollowsTheDefinitionForRandomComponents) {
    EXPECT_TRUE(rc::check([] { expectTheDefinition(false); }));
}

TEST(Selection, FollowsTheDefinitionForRandomComponentsInCircles) {
    EXPECT_TRUE(rc::check([] { expectTheDefinition(true); }));
}

} // namespace
} // namespace trembler
