// A level that is run without a window.
#pragma once

#include "game/ui/play/run/run_control.hpp"
#include "runtime/level/read/read_level.hpp"
#include "tests/game/ui/player.hpp"

namespace trembler::ui::test {

/// The electromagnet level, which solves itself within two seconds.
struct Controlled {
    Session session{
        gameData().registry, gameData().parts,
        loadLevel(gameData().registry, levelsFolder() / "experiments/1-switched-electromagnet.json")};
    render::Toasts toasts;
    PlacingTool placing{session, toasts};
    HandTool hand{session, toasts};
    budget::BudgetMode budget{gameData().registry};
    LevelAudio audio{nullptr};
    CameraControl view;
    std::string callbacks;
    std::vector<SlowFrame> slowFrames;
    RunControl run{session,
                   placing,
                   hand,
                   budget,
                   audio,
                   view,
                   {.newWorld = [this] { callbacks += "n"; },
                    .beforeStep = [this] { callbacks += "b"; },
                    .afterStep = [this] { callbacks += "a"; },
                    .stopping = [] {},
                    .stopped = [this] { callbacks += "s"; },
                    .slow = [this](SlowFrame const& slow) { slowFrames.push_back(slow); }}};

    void pictures(int count, double seconds = 1.0 / 60, bool oneFrame = false, bool fastHeld = false) {
        for (int i = 0; i < count; ++i) {
            run.beginPicture(fastHeld);
            run.advance(seconds, oneFrame);
        }
    }
    [[nodiscard]] std::uint64_t frame() const { return session.world().frame(); }
};

} // namespace trembler::ui::test
