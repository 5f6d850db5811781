// An interaction makes a call whose order matters: such calls may only come from outside the world.
#include "runtime/input/player_input.hpp"
#include "tests/compile_fail/kit.hpp"

namespace trembler {

struct PlayerFromGlow final : Interaction<PlayerFromGlow, PlayerRole, Reads<Glow>> {
    static constexpr ComponentText text{
        .name = "Player <- Glow", .effect = "player", .level = "", .work = "Plays."};
    using Activation = NeedsAll<>;
    void apply(Access& access) {
#ifndef TREMBLER_CONTROL
        access.call(PlayerInput{});
#endif
        static_cast<void>(access.read<Glow>());
    }
};

template <class C>
Component* made() {
    return new C;
}
template Component* made<PlayerFromGlow>();

} // namespace trembler
