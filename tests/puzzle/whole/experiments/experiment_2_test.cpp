// Experiment II, the doorbell: the thesis's account of frames (6.9.3), the alternatives that each needed
// another conventional script (6.9.4), and that it rings for ever.
#include "physics/magnetism/properties.hpp"
#include "tests/support/experiment.hpp"

namespace trembler {
namespace {

class ExperimentTwo : public Experiment {
protected:
    static constexpr char const* file = "2-doorbell.json";
    std::vector<std::uint64_t> rings(std::uint64_t frame) { return hits("striker", "bell", frame); }
    [[nodiscard]] double magnetism() const { return world().find<Magnet>(id("electromagnet"))->level; }
};

TEST_F(ExperimentTwo, FollowsTheAccountOfFrames) {
    open(file, "", true);
    std::vector<double> turned{angle("striker")};
    std::vector<double> magnet{magnetism()};
    while (world().frame() < 120) {
        step();
        turned.push_back(angle("striker"));
        magnet.push_back(magnetism());
    }
    std::uint64_t const f = std::max(first("contact begun", {"object 1", "switch"}).frame,
                                     first("contact begun", {"object 2", "switch"}).frame);
    EXPECT_NEAR(turned[f + 2], turned[f], 1e-4) << "the striker should rest on the contact";
    // "Frame 100": the connections enter the graph; the electromagnet is to become a magnet.
    EXPECT_EQ(first("connected", {"object 1", "switch"}).frame, f + 1);
    EXPECT_EQ(first("on", {"electromagnet"}).frame, f + 1);
    EXPECT_EQ(first("enableMagnet", {"electromagnet"}).frame, f + 1);
    // "Frame 101": it starts to work, and the force is applied.
    EXPECT_EQ(first("magnet on", {"electromagnet"}).frame, f + 2);
    EXPECT_EQ(first("addForceToPoint", {"striker"}).frame, f + 2);
    // "Frame 102": the striker starts to move, is off the contact, and the connection is to be removed.
    EXPECT_GT(turned[f + 3], turned[f + 2] + 1e-3);
    Event const& ended = first("contact ended", {"contact", "striker"}, f);
    EXPECT_EQ(ended.frame, f + 3);
    EXPECT_EQ(first("removeConnection", {"contact", "striker"}, f).frame, f + 3);
    // "Frame 103": the connection is severed, the electromagnet is off and begins to cool down.
    Event const& severed = first("disconnected", {"contact", "striker"}, f);
    Event const& off = first("off", {"electromagnet"}, f);
    EXPECT_EQ(severed.frame, f + 4);
    EXPECT_EQ(off.frame, f + 4);
    EXPECT_EQ(first("disableMagnet", {"electromagnet"}, f).frame, f + 4);
    // It cools down rapidly, but not instantly.
    EXPECT_EQ(magnet[f + 4], 1);
    EXPECT_GT(magnet[f + 5], 0);
    EXPECT_LT(magnet[f + 5], 1);
    EXPECT_LT(magnet[f + 6], magnet[f + 5]);
    EXPECT_EQ(magnet[f + 10], 0);
    // "Frame 110": by its momentum alone it goes on to the bell.
    Event const* ring = nullptr;
    for (Event const& e : world().tracer()->events()) {
        bool const pair = e.objects.size() == 2 && e.objects[0] == "bell" && e.objects[1] == "striker";
        if (ring == nullptr && pair && (e.event == "contact begun" || e.event == "contact brief")) {
            ring = &e;
        }
    }
    ASSERT_NE(ring, nullptr);
    EXPECT_GT(ring->frame, f + 4);
    EXPECT_LT(ring->frame, f + 15);
    // It falls back; now the striker closes the circuit.
    Event const& back = first("contact begun", {"contact", "striker"}, ring->frame);
    Event const& again = first("on", {"electromagnet"}, ring->frame);
    EXPECT_EQ(again.frame, back.frame + 1);

    EXPECT_TRUE(led(first("contact begun", {"object 1", "switch"}), *ring));
    EXPECT_TRUE(led(first("contact begun", {"object 2", "switch"}), *ring));
    EXPECT_TRUE(led(first("magnet on", {"electromagnet"}), *ring));
    EXPECT_TRUE(led(ended, severed));
    EXPECT_TRUE(led(severed, off));
    EXPECT_TRUE(led(back, again));
}

TEST_F(ExperimentTwo, RingsAtASteadyRateForTenMinutes) {
    open(file);
    constexpr std::uint64_t minute = 3600;
    EXPECT_TRUE(rings(20).empty()) << "the switch is still open";
    std::vector<double> rates; // rings per frame, minute by minute
    std::vector<double> all;
    std::uint64_t last = 0;
    for (std::uint64_t m = 1; m <= 10; ++m) {
        std::vector<std::uint64_t> frames = rings(m * minute);
        ASSERT_GT(frames.size(), 100U) << "minute " << m;
        if (last != 0) {
            frames.insert(frames.begin(), last);
        }
        last = frames.back();
        std::vector<double> const between = intervals(frames);
        rates.push_back(1 / mean(between));
        all.insert(all.end(), between.begin(), between.end());
    }
    double const drift =
        *std::max_element(rates.begin(), rates.end()) / *std::min_element(rates.begin(), rates.end()) - 1;
    RecordProperty("rings", static_cast<int>(all.size() + 1));
    RecordProperty("frames_between", std::to_string(mean(all)));
    RecordProperty("drift", std::to_string(drift));
    RecordProperty("relative_deviation", std::to_string(relativeDeviation(all)));
    EXPECT_LE(drift, 0.01);
    EXPECT_LE(relativeDeviation(all), 0.05);
    EXPECT_TRUE(session().solved());
}

TEST_F(ExperimentTwo, RingsWhileTheSwitchIsHeldDownAndStopsWhenItIsReleased) {
    open(file, "hold, then release");
    EXPECT_TRUE(rings(119).empty()) << "the hand still holds it up";
    std::vector<std::uint64_t> const held = rings(480);
    ASSERT_GT(held.size(), 10U);
    EXPECT_LT(held.front(), 160U);
    EXPECT_GT(held.back(), 450U) << "it should ring on for as long as the switch is held";
    EXPECT_LE(rings(510).size(), 1U) << "at most the stroke that had already begun";
    EXPECT_TRUE(rings(3600).empty());
    EXPECT_FALSE(touching("switch", "object 1"));
    EXPECT_TRUE(touching("striker", "contact"));
    EXPECT_FALSE(on("electromagnet"));
}

TEST_F(ExperimentTwo, TheSwitchItselfRingsTheBell) {
    open(file, "hit the bell with the switch", true);
    std::vector<std::uint64_t> const struck = hits("switch", "bell", 400);
    ASSERT_FALSE(struck.empty());
    EXPECT_TRUE(events("on", {"electromagnet"}).empty());
    EXPECT_TRUE(events("contact begun", {"striker", "bell"}).empty());
    // The hand caused it.
    Event const* hit = nullptr;
    for (Event const& e : world().tracer()->events()) {
        if (e.frame == struck.front() && e.objects == std::vector<std::string>{"bell", "switch"}) {
            hit = &e;
            break;
        }
    }
    ASSERT_NE(hit, nullptr);
    EXPECT_TRUE(led(first("grabbed", {"switch"}), *hit));
    EXPECT_FALSE(session().solved());
}

TEST_F(ExperimentTwo, AWedgeBetweenStrikerAndBellSilencesIt) {
    open(file, "a wedge in the way");
    std::vector<std::uint64_t> const struck = hits("striker", "wooden wedge 1", 3600);
    EXPECT_GT(struck.size(), 60U) << "the striker should hit the wedge instead";
    EXPECT_GT(struck.back(), 3000U);
    open(file, "a wedge in the way");
    EXPECT_TRUE(rings(3600).empty());
    EXPECT_TRUE(touching("switch", "object 1"));
}

TEST_F(ExperimentTwo, AWedgeSilencesItWhileItRings) {
    open(file, "a wedge while it rings");
    std::vector<std::uint64_t> const before = rings(200);
    ASSERT_GT(before.size(), 7U);
    EXPECT_GT(before.back(), 170U);
    EXPECT_FALSE(rings(290).empty());
    EXPECT_LE(rings(330).size(), 2U);
    EXPECT_TRUE(rings(3600).empty());
    EXPECT_TRUE(touching("switch", "object 1")) << "the switch still closes the contact";
}

TEST_F(ExperimentTwo, ANonConductorOnTheContactSilencesIt) {
    open(file, "a wooden clip on the contact", true);
    EXPECT_TRUE(rings(900).empty());
    EXPECT_TRUE(touching("striker", "wooden clip 1"));
    EXPECT_TRUE(touching("contact", "wooden clip 1"));
    EXPECT_TRUE(touching("switch", "object 1"));
    EXPECT_TRUE(events("contact begun", {"striker", "contact"}).empty());
    EXPECT_TRUE(events("on", {"electromagnet"}).empty());
}

TEST_F(ExperimentTwo, AConductorOnTheContactDoesNotSilenceIt) {
    open(file, "a copper clip on the contact", true);
    std::vector<std::uint64_t> const frames = rings(900);
    ASSERT_GT(frames.size(), 20U);
    EXPECT_GT(frames.back(), 860U);
    EXPECT_TRUE(events("contact begun", {"striker", "contact"}).empty());
    EXPECT_GT(events("contact begun", {"striker", "copper clip 1"}).size(), 20U);
    EXPECT_TRUE(session().solved());
}

} // namespace
} // namespace trembler
