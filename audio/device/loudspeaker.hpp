// From a world to the player's ears, with one call a frame.
#pragma once

#include "audio/device/output.hpp"
#include "audio/device/sample_files.hpp"
#include "runtime/world/subscription.hpp"

#include <functional>

namespace trembler {

class World;

struct LoudspeakerOptions {
    SynthesiserOptions synthesiser;
    OutputSettings output;
    std::vector<std::filesystem::path> sampleFolders; ///< where recordings are looked for, in order
};

/// Listens to one world at a time and changes nothing in it. Used by one thread at a time.
class Loudspeaker {
public:
    using Report = std::function<void(std::string const&)>;

    /// Opens the machine's sound device. Where there is none it reports that through `report` and goes on
    /// without.
    explicit Loudspeaker(LoudspeakerOptions options, Report report = {});
    /// Plays to that output instead.
    Loudspeaker(LoudspeakerOptions options, std::unique_ptr<Output> output, Report report = {});
    ~Loudspeaker();
    Loudspeaker(Loudspeaker const&) = delete;
    Loudspeaker& operator=(Loudspeaker const&) = delete;

    /// Begins, once, to listen to a world, which may be running already, instead of the one before, which may
    /// be gone. Where there is no device to hear it by, the world is not asked for its sounds.
    void enter(World const& world);
    /// Stops listening, if it does: the world goes on without being heard, or is gone.
    void leave();
    /// After every step() of the world: plays new sounds.
    void frame(World const& world, Listener const& listener);
    /// Instead, for every sixtieth of a second in which the world stands still: bodies that ring die away.
    void pause(Listener const& listener);

    void set(OutputSettings const& settings);
    [[nodiscard]] OutputSettings const& settings() const { return options_.output; }
    [[nodiscard]] Output const& output() const { return *output_; }
    [[nodiscard]] SynthesiserCounts const& counts() const { return synthesiser_.counts(); }

private:
    void startAfresh();
    void followRoom(World const& world, Listener const& listener);

    LoudspeakerOptions options_;
    std::unique_ptr<Output> output_;
    SampleFiles recordings_;
    Synthesiser synthesiser_;
    Subscription sounds_;          // of the world that it listens to
    World const* world_ = nullptr; // that one: compared, never looked into, as it may be gone
    std::optional<Vec2> roomAt_;   // where the room was last looked at
    std::uint64_t roomFrame_ = 0;
};

} // namespace trembler
