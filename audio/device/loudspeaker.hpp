// Plays the sounds of a world, with one call per frame.
#pragma once

#include "audio/device/output.hpp"
#include "audio/device/sample_files.hpp"
#include "audio/synth/interface_sounds.hpp"
#include "runtime/world/subscription.hpp"

#include <functional>
#include <map>
#include <vector>

namespace trembler {

class World;

struct LoudspeakerOptions {
    SynthesiserOptions synthesiser;
    OutputSettings output;
    std::vector<std::filesystem::path> sampleFolders; ///< searched for recordings, in order
};

/// Listens to one world at a time and changes nothing in it. Used by one thread at a time.
class Loudspeaker {
public:
    using Report = std::function<void(std::string const&)>;

    /// Opens the machine's sound device. If there is none, reports that through `report` and stays silent.
    explicit Loudspeaker(LoudspeakerOptions options, Report report = {});
    /// Plays to the given output instead.
    Loudspeaker(LoudspeakerOptions options, std::unique_ptr<Output> output, Report report = {});
    ~Loudspeaker();
    Loudspeaker(Loudspeaker const&) = delete;
    Loudspeaker& operator=(Loudspeaker const&) = delete;

    /// Begins to listen to a world, which may be running already, instead of the previous one, which may no
    /// longer exist. To be called once for each world. Without a sound device the world's sounds are not
    /// requested.
    void enter(World const& world);
    /// Stops listening, if it does. The world may continue without sound, or no longer exist.
    void leave();
    /// To be called after every step() of the world: plays new sounds.
    void frame(World const& world, Listener const& listener);
    /// To be called instead for every sixtieth of a second in which the world is paused: ringing bodies
    /// decay.
    void pause(Listener const& listener);

    /// Plays a sound of the interface at once, whether it listens to a world or not.
    void touch(InterfaceSound sound);
    /// How often that was asked for, heard or not.
    [[nodiscard]] std::uint64_t touched() const { return touched_; }

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
    std::map<InterfaceSound, std::vector<float>> touches_; // the sounds that were heard already
    std::uint64_t touched_ = 0;
    Subscription sounds_;          // of the world that it listens to
    World const* world_ = nullptr; // the same: only compared, never dereferenced, as it may no longer exist
    std::optional<Vec2> roomAt_;   // where the room was last computed
    std::uint64_t roomFrame_ = 0;
};

} // namespace trembler
