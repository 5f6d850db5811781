// The sounds of the player's own touches: taking, placing, refusal, run, success.
#pragma once

#include "audio/synth/interface_sounds.hpp"
#include "puzzle/session/session.hpp"

#include <cstdint>
#include <optional>

namespace trembler {
class Loudspeaker;
} // namespace trembler

namespace trembler::ui {

/// The parts of a level's screen that make sounds.
struct Touched {
    bool carrying = false; ///< a part, or several
    bool building = true;
    bool solved = false;        ///< by the player, in this run
    std::uint64_t troubles = 0; ///< messages of trouble so far
    World const* world = nullptr;
};

/// Compares one picture with the one before, so that the tools need no code for sounds. Window thread only;
/// the loudspeaker must outlive it.
class TouchSounds {
public:
    explicit TouchSounds(Loudspeaker* loudspeaker) : loudspeaker_(loudspeaker) {}

    /// To be called once for every picture.
    void look(Touched const& now);
    /// Nothing that happened since the last picture is heard: another page was shown.
    void forget() { before_.reset(); }

private:
    Loudspeaker* loudspeaker_;
    std::optional<Touched> before_;
};

/// The sound of the change from one picture to the next; nothing if none is heard.
[[nodiscard]] std::optional<InterfaceSound> soundBetween(Touched const& before, Touched const& now);

} // namespace trembler::ui
