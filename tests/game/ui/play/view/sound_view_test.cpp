// The display of sound, which must not influence the world.
#include "game/ui/play/view/sound_view.hpp"
#include "physics/dynamics/properties/contacts.hpp"
#include "puzzle/session/session.hpp"
#include "puzzle/solutions/solution_file.hpp"
#include "runtime/level/read/read_level.hpp"
#include "runtime/placement.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace trembler::ui::test {
namespace {

std::unique_ptr<Session> opened(std::string const& level, std::string const& solution) {
    auto session =
        std::make_unique<Session>(gameData().registry, gameData().parts,
                                  loadLevel(gameData().registry, levelsFolder() / level), WorldOptions{});
    session->load(findOrLoadSolution(gameData().registry, session->level(), solution));
    return session;
}

void step(Session& session, SoundView& sounds) {
    sounds.beforeStep(session.world());
    session.step();
    sounds.afterStep(session.world());
}

/// Whether the two began to touch in the last frame, even if the contact ended within it.
bool beginsToTouch(World const& world, std::string const& a, std::string const& b) {
    ObjectId const first = world.store().find(a);
    ObjectId const second = world.store().find(b);
    auto const* const contacts = world.find<Contacts>();
    auto const theirs = [&](TouchingPair const& pair) {
        return (pair.a == first && pair.b == second) || (pair.a == second && pair.b == first);
    };
    return std::any_of(contacts->begun.begin(), contacts->begun.end(), theirs) ||
           std::any_of(contacts->brief.begin(), contacts->brief.end(), theirs);
}

TEST(SoundView, ARingBeginsWhereTheBellIsHit) {
    auto const session = opened("experiments/2-doorbell.json", "hold, then release");
    SoundView sounds;
    std::optional<std::uint64_t> hit;
    while (!hit && session->world().frame() < 600) {
        step(*session, sounds);
        if (beginsToTouch(session->world(), "striker", "bell")) {
            hit = session->world().frame();
        }
    }
    ASSERT_TRUE(hit) << "the doorbell does not ring";
    Vec2 const bell = session->world().find<Position>(session->world().store().find("bell"))->value;
    double nearest = 1e9;         // m, from the bell's middle to a ring that has just begun
    for (int i = 0; i < 4; ++i) { // the call of (Sound <- Dynamics) is carried out in a later frame
        for (render::Ripple const& ripple : sounds.ripples()) {
            if (ripple.radius < 0.1) {
                nearest = std::min(nearest, std::hypot(ripple.at.x - bell.x, ripple.at.y - bell.y));
            }
        }
        step(*session, sounds);
    }
    EXPECT_LT(nearest, 0.6);
}

TEST(SoundView, LookingChangesNoStateOfTheWorld) {
    auto const seen = opened("experiments/2-doorbell.json", "hold, then release");
    auto const unseen = opened("experiments/2-doorbell.json", "hold, then release");
    SoundView sounds;
    std::size_t most = 0;
    for (int frame = 0; frame < 400; ++frame) {
        step(*seen, sounds);
        unseen->step();
        most = std::max(most, sounds.ripples().size());
        ASSERT_EQ(seen->world().stateHash(), unseen->world().stateHash()) << frame;
    }
    EXPECT_GT(most, 0U);
}

TEST(SoundView, RingsOfAnEndedRunAreRemoved) {
    auto const session = opened("experiments/2-doorbell.json", "hold, then release");
    SoundView sounds;
    while (sounds.ripples().empty() && session->world().frame() < 600) {
        step(*session, sounds);
    }
    ASSERT_FALSE(sounds.ripples().empty());
    session->stop();
    EXPECT_TRUE(sounds.ripples().empty()) << "its world is gone";
    session->start();
    step(*session, sounds);
    EXPECT_TRUE(sounds.ripples().empty()) << "nothing has fallen yet";
}

} // namespace
} // namespace trembler::ui::test
