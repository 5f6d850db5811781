// Resolvers examine only the sources that have calls, and find every call in them.
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace sources_with_calls_test {
namespace {

using heat::AddHeat;
using heat::HeatRole;
using heat::Strike;

using Source = CallSource<HeatRole>;

void addStrike(Source& source, std::size_t chunk, double energy) {
    std::get<CallBuffer<Strike>>(source.chunks[chunk]).push(Strike{{}, energy});
}
void addHeld(Source& source, std::size_t chunk, double power) {
    std::get<CallBuffer<AddHeat>>(source.chunks[chunk]).push(AddHeat{{}, power});
}
std::vector<double> allStrikes(Channel<HeatRole> const& channel) {
    std::vector<double> all;
    channel.forCalls<Strike>([&](Strike const& call, CallOrigin) { all.push_back(call.energy); });
    return all;
}
std::vector<double> allHeld(Channel<HeatRole> const& channel) {
    std::vector<double> all;
    channel.forCalls<AddHeat>([&](AddHeat const& call, CallOrigin) { all.push_back(call.power); });
    return all;
}
std::vector<double> notedStrikes(Channel<HeatRole> const& channel) {
    std::vector<double> all;
    channel.forNotedCalls<Strike>([&](Strike const& call, CallOrigin) { all.push_back(call.energy); });
    return all;
}

TEST(SourcesWithCalls, AreTheOnlyOnesThatAnAdvanceLooksAt) {
    std::deque<Source> sources(5);
    Channel<HeatRole> channel;
    for (Source& source : sources) {
        channel.add(&source);
    }
    channel.noteSourcesWithCalls();
    EXPECT_TRUE(channel.sourcesWithCalls().empty());
    addStrike(sources[3], 0, 1);
    addHeld(sources[3], 0, 2);
    addStrike(sources[1], 0, 3);
    ++sources[3].version;
    ++sources[1].version;
    channel.noteSourcesWithCalls();
    ASSERT_EQ(channel.sourcesWithCalls().size(), 2U);
    EXPECT_EQ(notedStrikes(channel), (std::vector<double>{3, 1})) << "in the order of sources";
    channel.clearOnce();
    channel.noteSourcesWithCalls();
    EXPECT_TRUE(notedStrikes(channel).empty());
    ++sources[1].version; // a turn without calls, after one with calls
    channel.noteSourcesWithCalls();
    ASSERT_EQ(channel.sourcesWithCalls().size(), 1U);
    EXPECT_EQ(channel.sourcesWithCalls()[0], &sources[3]) << "its call is held while it sleeps";
    channel.clearSources();
    EXPECT_TRUE(channel.sourcesWithCalls().empty());
}

// Turns of sources in any order, with and without calls, and advances between them.
TEST(SourcesWithCalls, HaveAllCallsInEveryAdvance) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint8_t> const& deeds) {
        std::deque<Source> sources(4);
        Channel<HeatRole> channel;
        for (Source& source : sources) {
            channel.add(&source);
        }
        for (std::uint8_t const deed : deeds) {
            Source& source = sources[deed % 4U];
            if (deed >= 64) { // a turn
                bool const stood = !source.empty();
                source.startTurn();
                if ((deed & 4U) != 0) {
                    addStrike(source, 0, deed);
                }
                if ((deed & 8U) != 0) {
                    addHeld(source, 0, deed);
                }
                source.version += stood || !source.empty() ? 1 : 0;
            } else if (deed >= 8) { // an advance
                channel.noteSourcesWithCalls();
                RC_ASSERT(notedStrikes(channel) == allStrikes(channel));
                std::vector<double> held;
                channel.forNotedCalls<AddHeat>(
                    [&](AddHeat const& call, CallOrigin) { held.push_back(call.power); });
                RC_ASSERT(held == allHeld(channel));
                channel.clearOnce();
            } else { // components come or go
                channel.clearSources();
                for (std::size_t i = deed % 2U; i < sources.size(); ++i) {
                    channel.add(&sources[i]);
                }
            }
        }
    }));
}

} // namespace
} // namespace sources_with_calls_test
} // namespace trembler
