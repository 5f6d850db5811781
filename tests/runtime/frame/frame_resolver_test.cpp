// The number of parts of a frame: as stated, or as many as the shortest of all requests needs.
#include "runtime/component/interaction.hpp"
#include "runtime/frame/frame_resolver.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/property/for_each.hpp"
#include "runtime/world/world.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace trembler {
namespace frame_resolver_test {
namespace {

/// The longest part of a frame that the object requests.
struct PartLimit {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Part limit", "test_part_limit", "The longest part of a frame."};
    double longest = 0; // s

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "value", .unit = "s", .meaning = "longest"}, self.longest);
    }
};

struct FrameFromPartLimit final : Interaction<FrameFromPartLimit, FrameRole, Reads<PartLimit>> {
    static constexpr ComponentText text{
        .name = "Frame <- Part limit", .effect = "frame", .level = "", .work = "Passes limits on."};
    using Activation = NeedsAll<PartLimit>;
    void apply(Access& access) {
        forEach([&](ObjectId, PartLimit const& limit) { access.call(SplitFrame{limit.longest}); },
                access.read<PartLimit>());
    }
};

Registry const& registry() {
    static Registry const shared = [] {
        Registry made;
        registerRuntime(made);
        made.component<FrameFromPartLimit>();
        return made;
    }();
    return shared;
}

struct Scene {
    World world;
    explicit Scene(std::vector<double> const& limits, WorldOptions options = {})
        : world(registry(), std::move(options)) {
        world.store().create("world");
        for (std::size_t i = 0; i < limits.size(); ++i) {
            world.store().column<PartLimit>().set(world.store().create("limit " + std::to_string(i)),
                                                  {limits[i]});
        }
    }
    void state(std::int32_t parts) {
        world.store().column<FrameSettings>().set(world.store().find("world"), {parts});
    }
    [[nodiscard]] int parts() const { return world.find<FrameParts>()->parts; }
};

/// The fewest parts of which none is longer than any limit; 8 if there are not so many.
int fewestParts(std::vector<double> const& limits) {
    for (int const parts : {1, 2, 4}) {
        bool enough = true;
        for (double const limit : limits) {
            bool const requests = std::isfinite(limit) && limit > 0;
            enough = enough && (!requests || 1.0 / 60 / parts <= limit);
        }
        if (enough) {
            return parts;
        }
    }
    return 8;
}

// In tenths of a millisecond no limit is on the border: a frame is 16.67 ms, its parts 8.33, 4.17 and 2.08
// ms.
TEST(FrameResolver, MakesPartsAsShortAsTheShortestWish) {
    EXPECT_TRUE(rc::check("random limits, nonsense among them", [] {
        auto const below = [](int bound) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(0, bound));
        };
        double const nonsense[] = {0, -1, std::numeric_limits<double>::quiet_NaN(),
                                   std::numeric_limits<double>::infinity(),
                                   -std::numeric_limits<double>::infinity()};
        auto const random = [&] {
            std::vector<double> limits;
            for (int i = below(4); i > 0; --i) {
                limits.push_back(below(4) == 0 ? nonsense[below(5)] : (1 + below(250)) * 1e-4);
            }
            return limits;
        };
        std::vector<double> const limits = random();
        Scene scene(limits);
        scene.world.start();
        scene.world.step();
        RC_ASSERT(scene.parts() == 1); // no call has been made before the first frame
        scene.world.step();
        int const expected = fewestParts(limits);
        RC_ASSERT(scene.parts() == expected);
        // A stated number is used instead, whatever the limits are.
        int const stated = 1 << below(4);
        scene.state(stated);
        scene.world.step();
        RC_ASSERT(scene.parts() == stated);
        scene.state(FrameSettings::automatic);
        scene.world.step();
        RC_ASSERT(scene.parts() == expected);
        RC_TAG(expected);
    }));
}

TEST(FrameResolver, APartMayBeExactlyAsLongAsTheWish) {
    for (int const parts : {1, 2, 4, 8}) {
        Scene scene({frameDuration / parts});
        scene.world.start();
        scene.world.step();
        scene.world.step();
        EXPECT_EQ(scene.parts(), parts);
    }
    // The shortest limit of all is as good as any that is below an eighth of a frame.
    Scene scene({std::numeric_limits<double>::denorm_min()});
    scene.world.start();
    scene.world.step();
    scene.world.step();
    EXPECT_EQ(scene.parts(), 8);
}

TEST(FrameResolver, RecordsAnEventOnlyWhenTheNumberChanges) {
    WorldOptions options;
    options.trace = true;
    Scene scene({0.003}, options); // a quarter of a frame is too long, an eighth is not
    scene.world.start();
    for (int i = 0; i < 4; ++i) {
        scene.world.step();
    }
    scene.state(8);
    scene.world.step();
    scene.state(1);
    scene.world.step();
    std::vector<std::string> said;
    std::vector<std::uint64_t> frames;
    for (Event const& event : scene.world.tracer()->events()) {
        if (event.event.find("frame in") == 0) {
            said.emplace_back(event.event);
            frames.push_back(event.frame);
        }
    }
    EXPECT_EQ(said, (std::vector<std::string>{"frame in 8 parts", "frame in 1 part"}));
    EXPECT_EQ(frames, (std::vector<std::uint64_t>{2, 6}));
}

} // namespace
} // namespace frame_resolver_test
} // namespace trembler
