// The output to the loudspeakers, with real input events.
#include "audio/device/loudspeaker.hpp"
#include "game/ui/app/menu/settings_page.hpp"
#include "tests/game/ui/player.hpp"

#include <algorithm>

namespace trembler::ui::test {
namespace {

constexpr render::Size small{960, 540}; // the pictures do not matter
auto const doorbell = levelsFolder() / "experiments/2-doorbell.json";

/// The calls that a loudspeaker has received.
struct Heard {
    int blocks = 0;
    double loudest = 0; ///< Pa at 1 m, of the last block
    double height = 0;  ///< m, of the listener above the drawing
    OutputSettings settings;
    bool silenced = false; ///< by the last call
    int touches = 0;
    double touchGain = 0;
};

class Ear final : public Output {
public:
    explicit Ear(Heard& heard) : heard_(heard) {}
    void play(std::span<Voice const> voices, Listener const& listener) override {
        ++heard_.blocks;
        heard_.loudest = 0;
        heard_.silenced = false;
        heard_.height = listener.height;
        for (Voice const& voice : voices) {
            for (float const sample : voice.samples) {
                heard_.loudest = std::max(heard_.loudest, std::abs(static_cast<double>(sample)));
            }
        }
    }
    void playOnce(std::span<float const> samples, double gain) override {
        ++heard_.touches;
        heard_.touchGain = gain;
        EXPECT_FALSE(samples.empty());
    }
    void set(OutputSettings const& settings) override { heard_.settings = settings; }
    void set(RoomAcoustics const& /*room*/) override {}
    void stop() override { heard_.silenced = true; }
    [[nodiscard]] std::string name() const override { return "test"; }
    [[nodiscard]] bool audible() const override { return true; }

private:
    Heard& heard_;
};

TEST(SoundInTheWindow, TheDoorbellRingsUntilItIsStopped) {
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    Player player(small, {}, levelsFolder(), &loudspeaker);
    player.open(doorbell);
    player.frames(10);
    EXPECT_EQ(heard.blocks, 0) << "nothing runs yet";
    player.clickItem("run");
    double loudest = 0;
    for (int i = 0; i < 300; ++i) {
        player.frame();
        loudest = std::max(loudest, heard.loudest);
    }
    EXPECT_GT(loudest, 0.02) << "the bell should be as loud as speech";
    EXPECT_GT(heard.blocks, 290);
    EXPECT_GT(heard.height, 0.5);
    player.clickItem("stop");
    EXPECT_TRUE(heard.silenced);
    int const blocks = heard.blocks;
    player.frames(10);
    EXPECT_EQ(heard.blocks, blocks);
}

TEST(SoundInTheWindow, EveryTouchIsHeardUnlessThatIsSwitchedOff) {
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    Player player(small, {}, levelsFolder(), &loudspeaker);
    player.open(levelsFolder() / "first/1-first-contact.json");
    EXPECT_EQ(heard.touches, 0);
    player.clickItem("part steel bar");
    EXPECT_EQ(heard.touches, 1) << "taken";
    EXPECT_EQ(heard.touchGain, 0.5);
    player.click(player.at({-1.8, 1.5}));
    EXPECT_EQ(heard.touches, 2) << "placed";
    player.clickItem("run");
    EXPECT_EQ(heard.touches, 3);
    player.frames(2);
    player.clickItem("stop");
    EXPECT_EQ(heard.touches, 4);
    player.frames(2);
    Settings settings = player.app().context().profile.settings();
    settings.touches = 0;
    changeSettings(player.app().context(), settings);
    player.clickItem("run");
    EXPECT_EQ(heard.touches, 4);
}

TEST(SoundInTheWindow, EveryButtonIsHeardOnce) {
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    Player player(small, {}, levelsFolder(), &loudspeaker);
    player.clickItem("settings");
    EXPECT_EQ(heard.touches, 1) << "a button of the title";
    player.click({5, 5}); // beside all buttons
    EXPECT_EQ(heard.touches, 1);
    player.frames(2);
    player.key(SDLK_DOWN);
    EXPECT_EQ(heard.touches, 1) << "the ring moves without a sound";
    player.key(SDLK_RETURN);
    EXPECT_EQ(heard.touches, 2) << "a button pressed by a key";
    player.key(SDLK_ESCAPE);
    player.frames(2);
    player.clickItem("editor");
    player.frames(3);
    EXPECT_EQ(heard.touches, 3);
    player.key(SDLK_2);
    player.key(SDLK_2);
    EXPECT_EQ(heard.touches, 4) << "an object is placed";
    player.key(SDLK_6);
    player.key(SDLK_7);
    player.key(SDLK_7); // a wire needs two objects
    EXPECT_EQ(heard.touches, 4) << "news are no refusal";
    Settings settings = player.app().context().profile.settings();
    settings.touches = 0;
    changeSettings(player.app().context(), settings);
    player.key(SDLK_3);
    player.key(SDLK_3);
    EXPECT_EQ(heard.touches, 4) << "switched off";
}

TEST(SoundInTheWindow, ARingingObjectDiesAwayInAPause) {
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    Player player(small, {}, levelsFolder(), &loudspeaker);
    player.open(doorbell);
    player.clickItem("run");
    double loudest = 0;
    for (int i = 0; i < 300; ++i) {
        player.frame();
        loudest = std::max(loudest, heard.loudest);
    }
    player.session().pause();
    player.frames(600);
    EXPECT_LT(heard.loudest, loudest / 100);
}

TEST(SoundInTheWindow, VolumeAndHrtfComeFromThePlayersSettings) {
    auto const file = testFolder() / "profile.json";
    std::filesystem::remove(file);
    Profile profile(file);
    Settings settings;
    settings.volume = 25;
    settings.hrtf = true;
    profile.setSettings(settings);
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    Player player(small, file, levelsFolder(), &loudspeaker);
    EXPECT_NEAR(heard.settings.volume, 0.25, 1e-9);
    EXPECT_TRUE(heard.settings.hrtf);
}

TEST(SoundInTheWindow, ListeningChangesNothing) {
    Heard heard;
    Loudspeaker loudspeaker({}, std::make_unique<Ear>(heard));
    auto const hashAfter = [](Loudspeaker* listening) {
        Player player(small, {}, levelsFolder(), listening);
        player.open(doorbell);
        player.clickItem("run");
        while (player.session().world().frame() < 200) {
            player.frame();
        }
        return player.session().world().stateHash();
    };
    EXPECT_EQ(hashAfter(&loudspeaker), hashAfter(nullptr));
}

} // namespace
} // namespace trembler::ui::test
