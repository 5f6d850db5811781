// Random worlds are shown as they were, whatever properties their objects have.
#include "insight/timeline/again.hpp"
#include "insight/timeline/recording.hpp"
#include "insight/timeline/stage.hpp"
#include "puzzle/goals/level_schema.hpp"
#include "runtime/level/json/json_document.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/levels/level_kit.hpp"
#include "tests/worlds/random_level.hpp"
#include "tests/worlds/trial.hpp"

#include <gtest/gtest.h>

#include <map>

namespace trembler::insight {
namespace {

TEST(RecordingOfRandomWorlds, ShowsThemBitForBit) {
    nlohmann::json const schema = levelSchema(levelKit().registry);
    worlds::RandomLevels const levels(schema, levelKit().parts.names());
    int played = 0;
    for (std::uint64_t seed = 0; seed < 24; ++seed) {
        worlds::Manner manner; // of ordinary sizes: engines take long over extreme ones
        manner.extremes = 0;
        manner.objects = 4 + static_cast<int>(seed % 9);
        manner.properties = 0.3;
        worlds::Outcome const outcome =
            worlds::tryOut(levels.make(seed, manner), schema, {.engines = {}, .threads = {1}});
        if (!outcome.played) {
            continue;
        }
        SCOPED_TRACE(seed);
        Session session(
            levelKit().registry, levelKit().parts,
            readLevel(levelKit().registry, JsonDocument::parse(outcome.level.dump(), "random.json")));
        Recording recording(16U << 10U); // so small that frames are left out
        recording.begin(session.world(), session.judge());
        std::map<std::uint64_t, std::uint64_t> hashes{{0, session.world().store().hash()}};
        for (int i = 0; i < 260; ++i) {
            session.step();
            recording.add(session.world(), session.judge());
            hashes[session.world().frame()] = session.world().store().hash();
        }
        Stage stage([&] { return buildAgain(levelKit().registry, session); });
        for (std::uint64_t const wanted : {260U, 0U, 259U, 100U, 128U, 5U, 200U, 1U}) {
            std::uint64_t const frame = recording.nearest(wanted);
            stage.show(recording, frame);
            ASSERT_EQ(stage.world().store().hash(), hashes.at(frame)) << frame;
        }
        ++played;
    }
    EXPECT_GT(played, 12);
}

} // namespace
} // namespace trembler::insight
