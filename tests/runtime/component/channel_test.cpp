// Recorded calls: held calls and calls that are carried out once, the order in which they are drained, and
// that a resolver's result does not depend on the order of recording.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <set>

namespace trembler {
namespace {

using heat::AddHeat;
using heat::Heat;
using heat::HeatRole;
using heat::Strike;

using Source = CallSource<HeatRole>;

void strike(Source& source, std::size_t chunk, double energy) {
    std::get<CallBuffer<Strike>>(source.chunks[chunk]).push(Strike{{}, energy});
}
void hold(Source& source, std::size_t chunk, double power) {
    std::get<CallBuffer<AddHeat>>(source.chunks[chunk]).push(AddHeat{{}, power});
}
std::vector<double> strikes(Channel<HeatRole> const& channel) {
    std::vector<double> all;
    channel.forCalls<Strike>([&](Strike const& call, CallOrigin) { all.push_back(call.energy); });
    return all;
}
std::vector<double> holds(Channel<HeatRole> const& channel) {
    std::vector<double> all;
    channel.forCalls<AddHeat>([&](AddHeat const& call, CallOrigin) { all.push_back(call.power); });
    return all;
}

TEST(CallBuffer, KeepsCausesBesideTheirCalls) {
    CallBuffer<Strike> buffer;
    buffer.push(Strike{{}, 1});
    buffer.push(Strike{{}, 2});
    buffer.setCauseOfLast(EventId{7});
    buffer.push(Strike{{}, 3});
    ASSERT_EQ(buffer.calls().size(), 3U);
    EXPECT_EQ(buffer.cause(0), EventId{});
    EXPECT_EQ(buffer.cause(1), EventId{7});
    EXPECT_EQ(buffer.cause(2), EventId{});
    buffer.clear();
    EXPECT_TRUE(buffer.calls().empty());
    EXPECT_EQ(buffer.cause(1), EventId{});
}

TEST(CallAlgebra, StatesWhichCallsAreHeld) {
    EXPECT_TRUE(isHeld(Algebra::sumOfRates));
    EXPECT_TRUE(isHeld(Algebra::anyOf));
    EXPECT_TRUE(isHeld(Algebra::least));
    EXPECT_TRUE(isHeld(Algebra::greatest));
    EXPECT_FALSE(isHeld(Algebra::sumOfAmounts));
    EXPECT_FALSE(isHeld(Algebra::countedSet));
    EXPECT_FALSE(isHeld(Algebra::create));
    EXPECT_FALSE(isHeld(Algebra::destroy));
    EXPECT_FALSE(isHeld(Algebra::sequence));
    std::set<std::string_view> names;
    for (Algebra const a :
         {Algebra::sumOfRates, Algebra::sumOfAmounts, Algebra::anyOf, Algebra::least, Algebra::greatest,
          Algebra::countedSet, Algebra::create, Algebra::destroy, Algebra::sequence}) {
        names.insert(nameOf(a));
    }
    EXPECT_EQ(names.size(), 9U) << "each has a different text in the notation";
}

TEST(Channel, DrainsBySourceThenChunkThenCall) {
    Callers callers;
    Source first;
    Source second;
    first.caller = callers.add("first");
    second.caller = callers.add("second");
    first.chunks.resize(2);
    Channel<HeatRole> channel;
    channel.add(&first);
    channel.add(&second);
    strike(second, 0, 5);
    strike(first, 1, 3);
    strike(first, 0, 1);
    strike(first, 1, 4);
    strike(first, 0, 2);
    EXPECT_EQ(strikes(channel), (std::vector<double>{1, 2, 3, 4, 5}));
    std::vector<CallerId> origins;
    channel.forCalls<Strike>([&](Strike const&, CallOrigin origin) { origins.push_back(origin.caller); });
    EXPECT_EQ(origins, (std::vector{first.caller, first.caller, first.caller, first.caller, second.caller}));
}

TEST(Channel, ClearsSingleCallsOnceCarriedOutAndHeldOnesByTheirSource) {
    Source source;
    Channel<HeatRole> channel;
    channel.add(&source);
    strike(source, 0, 1);
    hold(source, 0, 2);
    channel.clearOnce();
    EXPECT_TRUE(strikes(channel).empty());
    EXPECT_EQ(holds(channel), std::vector<double>{2});
    strike(source, 0, 3);
    source.clearHeld();
    EXPECT_EQ(strikes(channel), std::vector<double>{3});
    EXPECT_TRUE(holds(channel).empty());
}

// Only sources with calls since the last time are examined; of a new set of sources, all are.
TEST(Channel, ClearsWhatEachSourceHasMadeSinceTheLastTime) {
    Source first;
    Source second;
    Channel<HeatRole> channel;
    channel.add(&first);
    channel.add(&second);
    strike(first, 0, 1);
    ++first.version;
    hold(second, 0, 2);
    ++second.version;
    channel.clearOnce();
    strike(second, 0, 3);
    ++second.version;
    channel.clearOnce();
    EXPECT_TRUE(strikes(channel).empty());
    EXPECT_EQ(holds(channel), std::vector<double>{2});

    Source third; // in the place of the first one, with its version
    third.version = first.version;
    strike(third, 0, 4);
    channel.clearSources();
    channel.add(&third);
    channel.add(&second);
    EXPECT_EQ(strikes(channel), std::vector<double>{4});
    channel.clearOnce();
    EXPECT_TRUE(strikes(channel).empty());
}

// No sequence of changes to the sources repeats a version.
TEST(Channel, NoVersionIsRepeated) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint8_t> const& deeds) {
        std::deque<Source> sources(4);
        std::set<std::size_t> present;
        Channel<HeatRole> channel;
        std::set<std::uint64_t> seen{channel.version()};
        for (std::uint8_t const deed : deeds) {
            std::size_t const n = deed % sources.size();
            if (deed & 0x80U) { // an interaction is constructed or removed: all are bound again
                if (!present.erase(n)) {
                    present.insert(n);
                    sources[n].version = 1;
                }
                channel.clearSources();
                for (std::size_t const p : present) {
                    channel.add(&sources[p]);
                }
            } else if (present.contains(n)) { // an interaction is applied
                ++sources[n].version;
            } else {
                continue;
            }
            RC_ASSERT(seen.insert(channel.version()).second);
        }
    }));
}

struct OtherRole {
    static constexpr std::string_view name = "Heat"; // the type counts, not the name
    using Calls = CallList<Strike>;
};

TEST(Channels, AreOnePerRole) {
    Callers callers;
    Channels channels(callers);
    Source source;
    channels.of<HeatRole>().add(&source);
    EXPECT_EQ(channels.of<HeatRole>().sources().size(), 1U);
    EXPECT_EQ(&channels.of<HeatRole>(), &channels.of<HeatRole>());
    EXPECT_TRUE(channels.of<OtherRole>().sources().empty());
    channels.clearSources();
    EXPECT_TRUE(channels.of<HeatRole>().sources().empty());
}

// --- the results of a resolver
// ------------------------------------------------------------------------------

// One call of every keyed algebra, and a resolver that carries them out by their algebra.
template <Algebra a>
struct Keyed {
    static constexpr CallText text{"keyed", "(key, value)", "For tests."};
    static constexpr Algebra algebra = a;
    std::uint32_t about = 0;
    int amount = 1;
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {ObjectId{about, 0}}; }
    [[nodiscard]] std::uint32_t key() const { return about; }
    [[nodiscard]] int delta() const { return amount; }
    [[nodiscard]] int value() const { return amount; }
};
using Count = Keyed<Algebra::countedSet>;
using Any = Keyed<Algebra::anyOf>;
using Least = Keyed<Algebra::least>;
using Greatest = Keyed<Algebra::greatest>;

struct KeyedRole {
    static constexpr std::string_view name = "Keyed";
    using Calls = CallList<Count, Any, Least, Greatest>;
};

struct Outcome {
    std::map<std::uint32_t, int> counts; // carried from frame to frame
    std::set<std::uint32_t> any;
    std::map<std::uint32_t, int> least;
    std::map<std::uint32_t, int> greatest;
    friend bool operator==(Outcome const&, Outcome const&) = default;
};
Outcome outcomeOf(Channel<KeyedRole> const& channel) {
    Outcome out;
    channel.forCalls<Count>([&](Count const& c, CallOrigin) { out.counts[c.key()] += c.delta(); });
    channel.forCalls<Any>([&](Any const& c, CallOrigin) { out.any.insert(c.key()); });
    channel.forCalls<Least>([&](Least const& c, CallOrigin) {
        auto const [at, isNew] = out.least.emplace(c.key(), c.value());
        at->second = std::min(at->second, c.value());
    });
    channel.forCalls<Greatest>([&](Greatest const& c, CallOrigin) {
        auto const [at, isNew] = out.greatest.emplace(c.key(), c.value());
        at->second = std::max(at->second, c.value());
    });
    return out;
}

// 5.7.2: which interaction called, in which chunk, and in which order does not matter.
TEST(CallAlgebra, MakesTheOrderOfCallsIrrelevant) {
    struct Deed {
        int kind;
        std::uint32_t key;
        int value;
    };
    EXPECT_TRUE(rc::check([] {
        auto const deeds = *rc::gen::container<std::vector<Deed>>(
            rc::gen::build<Deed>(rc::gen::set(&Deed::kind, rc::gen::inRange(0, 4)),
                                 rc::gen::set(&Deed::key, rc::gen::inRange(0U, 5U)),
                                 rc::gen::set(&Deed::value, rc::gen::inRange(-2, 3))));
        auto const record = [&](std::vector<std::size_t> const& order, std::size_t spread) {
            std::deque<CallSource<KeyedRole>> sources(spread);
            Channel<KeyedRole> channel;
            for (auto& source : sources) {
                source.chunks.resize(spread);
                channel.add(&source);
            }
            for (std::size_t i = 0; i < order.size(); ++i) {
                Deed const& d = deeds[order[i]];
                auto& chunk = sources[order[i] % spread].chunks[(order[i] / spread) % spread];
                switch (d.kind) {
                case 0:
                    std::get<CallBuffer<Count>>(chunk).push({d.key, d.value < 0 ? -1 : 1});
                    break;
                case 1:
                    std::get<CallBuffer<Any>>(chunk).push({d.key, 1});
                    break;
                case 2:
                    std::get<CallBuffer<Least>>(chunk).push({d.key, d.value});
                    break;
                default:
                    std::get<CallBuffer<Greatest>>(chunk).push({d.key, d.value});
                    break;
                }
            }
            return outcomeOf(channel);
        };
        std::vector<std::size_t> order(deeds.size());
        for (std::size_t i = 0; i < order.size(); ++i) {
            order[i] = i;
        }
        Outcome const straight = record(order, 1);
        auto shuffled = order;
        std::reverse(shuffled.begin(), shuffled.end());
        RC_ASSERT(record(shuffled, 3) == straight);
        RC_ASSERT(record(order, 2) == straight);
        // The sums, which do not depend on the order, computed by hand.
        std::map<std::uint32_t, int> expected;
        for (Deed const& d : deeds) {
            if (d.kind == 0) {
                expected[d.key] += d.value < 0 ? -1 : 1;
            }
        }
        RC_ASSERT(straight.counts == expected);
    }));
}

} // namespace
} // namespace trembler
