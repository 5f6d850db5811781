// Plotted numbers of long runs: bounded in sum, over the whole run, with the values that were there.
#include "insight/probe/series.hpp"
#include "tests/support/experiment.hpp"

namespace trembler::insight {
namespace {

class SeriesTest : public Experiment {
protected:
    SeriesTest() { open("1-switched-electromagnet.json"); }
    void add(Probes& probes, std::string const& what) const { probes.add(world(), fields_, what); }
    static std::size_t samplesOf(Probes const& probes) {
        std::size_t all = 0;
        for (Series const& series : probes.series()) {
            all += series.samples.size();
        }
        return all;
    }

private:
    std::vector<watch::WatchedField> const fields_ = watch::watchedFields(gameData().registry);
};

TEST_F(SeriesTest, KeepsARunOfAnyLengthWithinItsBound) {
    EXPECT_LE(Probes::mostSamples * sizeof(Sample), 64U << 20U);
    constexpr std::size_t most = 300;
    constexpr std::uint64_t frames = 20'000;
    Probes probes(most);
    add(probes, "world.gravity"); // a vector: two numbers
    add(probes, "switch.mass");
    for (std::uint64_t frame = 0; frame <= frames; ++frame) {
        probes.look(world(), frame);
        ASSERT_EQ(probes.last(), frame) << "whether it was kept or not";
        ASSERT_LE(samplesOf(probes), most + 3);
        ASSERT_LE(probes.frames().size(), most / 3 + 1);
    }
    std::vector<std::uint64_t> const& kept = probes.frames();
    ASSERT_GT(kept.size(), most / 3 / 4) << "about half of the room is in use";
    EXPECT_EQ(kept.front(), 0U);
    std::uint64_t const gap = kept[1];
    EXPECT_GT(kept.back() + gap, frames) << "up to the end";
    for (std::size_t i = 0; i < kept.size(); ++i) {
        ASSERT_EQ(kept[i], i * gap) << "with equal gaps";
        for (Series const& series : probes.series()) {
            ASSERT_EQ(series.samples[i].frame, kept[i]);
        }
    }
}

TEST_F(SeriesTest, KeepsEveryFrameBelowItsBound) {
    Probes probes(300);
    add(probes, "switch.mass");
    for (std::uint64_t frame = 1; frame <= 300; ++frame) {
        probes.look(world(), frame);
    }
    EXPECT_EQ(probes.frames().size(), 300U);
    probes.look(world(), 301);
    EXPECT_LT(probes.frames().size(), 160U);
    // What comes after the run begins again is as dense as before.
    probes.clearSamples();
    EXPECT_FALSE(probes.last());
    for (std::uint64_t frame = 1; frame <= 300; ++frame) {
        probes.look(world(), frame);
    }
    EXPECT_EQ(probes.frames().size(), 300U);
}

TEST_F(SeriesTest, GoesOnAfterFramesThatWereForgotten) {
    Probes probes(100);
    add(probes, "switch.mass");
    for (std::uint64_t frame = 0; frame <= 1000; ++frame) {
        probes.look(world(), frame);
    }
    probes.forgetAfter(501); // which was looked at, and perhaps thinned out
    EXPECT_EQ(probes.last(), 501U);
    EXPECT_LE(probes.frames().back(), 501U);
    for (std::uint64_t frame = 502; frame <= 1000; ++frame) {
        probes.look(world(), frame);
    }
    for (std::size_t i = 1; i < probes.frames().size(); ++i) {
        EXPECT_LT(probes.frames()[i - 1], probes.frames()[i]);
    }
    EXPECT_GT(probes.frames().back(), 950U);
    probes.forgetAfter(1000);
    EXPECT_EQ(probes.last(), 1000U);
}

} // namespace
} // namespace trembler::insight
