// Marks of a run compared with the events of its trace, which the marks do not read, and with speeds before
// touches.
#include "insight/timeline/marks.hpp"
#include "physics/electricity/properties/electrical.hpp"
#include "runtime/placement.hpp"
#include "runtime/trace/tracer.hpp"
#include "tests/support/experiment.hpp"

#include <algorithm>
#include <map>
#include <set>

namespace trembler::insight {
namespace {

class MarksTest : public Experiment {
protected:
    /// Runs a level, traced, with its first recorded solution.
    void run(std::string const& file, std::uint64_t frames) {
        LevelFile level = loadLevel(gameData().registry, gameData().home / "levels" / file);
        std::string const solution = level.solutions.front().name;
        open(std::move(level), solution, true);
        session().start();
        marks_.clear();
        few_.clear();
        speeds_.clear();
        std::map<std::string, Vec2> before;
        while (world().frame() < frames) {
            before = velocities();
            step();
            marks_.look(world(), session().judge());
            few_.look(world(), session().judge());
            speeds_.push_back(before);
        }
    }
    [[nodiscard]] std::set<std::pair<std::uint64_t, std::vector<std::string>>> marked(MarkKind kind) const {
        std::set<std::pair<std::uint64_t, std::vector<std::string>>> all;
        for (Mark const& mark : marks_.all()) {
            if (mark.kind == kind) {
                all.emplace(mark.frame, mark.objects);
            }
        }
        return all;
    }
    /// The events of that name after the first frame, whose state a run begins with; of the same objects only
    /// those at least Marks::quiet frames after the last one.
    [[nodiscard]] std::set<std::pair<std::uint64_t, std::vector<std::string>>>
    traced(std::string const& name) const {
        std::set<std::pair<std::uint64_t, std::vector<std::string>>> all;
        std::map<std::vector<std::string>, std::uint64_t> last;
        for (Event const& event : world().tracer()->events()) {
            if (event.event == name && event.frame > 1) {
                auto const at = last.find(event.objects);
                if (at == last.end() || event.frame > at->second + Marks::quiet) {
                    all.emplace(event.frame, event.objects);
                }
                last[event.objects] = event.frame;
            }
        }
        return all;
    }
    /// How fast one of the two moved relative to the other before a frame.
    [[nodiscard]] double speedBefore(std::uint64_t frame, std::string const& a, std::string const& b) const {
        auto const& all = speeds_.at(frame - 1);
        auto const of = [&](std::string const& name) { return all.contains(name) ? all.at(name) : Vec2{}; };
        return length(of(a) - of(b));
    }
    [[nodiscard]] bool conducts(std::string const& name) const {
        return world().find<Conductor>(world().store().find(name)) != nullptr;
    }

    Marks marks_;
    Marks few_{3};

private:
    [[nodiscard]] std::map<std::string, Vec2> velocities() const {
        std::map<std::string, Vec2> all;
        ObjectTable const& objects = world().store().objects();
        for (std::uint32_t index = 0; index < objects.indexBound(); ++index) {
            ObjectId const object = objects.at(index);
            if (auto const* const velocity = object.valid() ? world().find<Velocity>(object) : nullptr) {
                all[world().store().nameOf(object)] = velocity->value;
            }
        }
        return all;
    }
    std::vector<std::map<std::string, Vec2>> speeds_; // before each frame, from frame 1 on
};

TEST_F(MarksTest, SomethingDipsIntoALiquidAndLeavesIt) {
    run("4-water/6-drop-the-ballast.json", 400);
    EXPECT_EQ(marked(MarkKind::dips), traced("enters the liquid"));
    EXPECT_FALSE(marked(MarkKind::dips).empty());
    EXPECT_EQ(marked(MarkKind::leaves), traced("leaves the liquid"));
    EXPECT_FALSE(marked(MarkKind::leaves).empty());
}

TEST_F(MarksTest, SomethingBecomesMagneticAndCeasesToBe) {
    run("experiments/2-doorbell.json", 200);
    EXPECT_EQ(marked(MarkKind::magnetOn), traced("magnet on"));
    EXPECT_FALSE(marked(MarkKind::magnetOn).empty());
    EXPECT_EQ(marked(MarkKind::magnetOff), traced("magnet off"));
    EXPECT_FALSE(marked(MarkKind::magnetOff).empty()) << "the doorbell breaks its own circuit";
}

// Every first touch at that speed that is not one of two conductors, and no other.
TEST_F(MarksTest, TwoObjectsHitEachOther) {
    for (char const* const file : {"first/2-into-the-basket.json", "first/3-pass-it-on.json"}) {
        run(file, 400);
        std::set<std::pair<std::uint64_t, std::vector<std::string>>> expected;
        std::set<std::vector<std::string>> hit;
        std::size_t slow = 0;
        for (Event const& event : world().tracer()->events()) {
            if (!event.event.starts_with("contact") || event.event == "contact ended" || event.frame < 2 ||
                (conducts(event.objects[0]) && conducts(event.objects[1]))) {
                continue;
            }
            if (speedBefore(event.frame, event.objects[0], event.objects[1]) < Marks::leastSpeed) {
                ++slow;
            } else if (hit.insert(event.objects).second) {
                expected.emplace(event.frame, event.objects);
            }
        }
        EXPECT_FALSE(expected.empty()) << file;
        EXPECT_GT(slow, 0U) << file;
        EXPECT_EQ(marked(MarkKind::hit), expected) << file;
    }
}

// A frame that has been seen before is not marked again, and what begins later is.
TEST_F(MarksTest, GoOnFromAnEarlierFrame) {
    run("4-water/6-drop-the-ballast.json", 400);
    auto const whole = marks_.all();
    Marks continued;
    for (std::size_t pass = 0; pass < 2; ++pass) {
        Solution const solution = session().level().solutions.front();
        open(session().level(), solution.name);
        session().start();
        while (world().frame() < 400) {
            step();
            continued.look(world(), session().judge());
        }
        if (pass == 0) {
            continued.forgetAfter(200);
        }
    }
    ASSERT_EQ(continued.all().size(), whole.size());
    for (std::size_t i = 0; i < whole.size(); ++i) {
        EXPECT_EQ(continued.all()[i].frame, whole[i].frame);
        EXPECT_EQ(continued.all()[i].kind, whole[i].kind);
        EXPECT_EQ(continued.all()[i].objects, whole[i].objects);
    }
}

TEST_F(MarksTest, NoMoreAreKeptThanThereMayBe) {
    run("experiments/2-doorbell.json", 200);
    ASSERT_GT(marks_.all().size(), 3U);
    ASSERT_EQ(few_.all().size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(few_.all()[i].frame, marks_.all()[i].frame);
        EXPECT_EQ(few_.all()[i].objects, marks_.all()[i].objects);
    }
}

} // namespace
} // namespace trembler::insight
