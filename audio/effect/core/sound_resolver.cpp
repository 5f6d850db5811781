#include "audio/effect/core/sound_resolver.hpp"

namespace trembler {
namespace {

template <class C>
void gather(SoundResolver::Access& access, std::vector<Received<C>>& into) {
    access.forCalls<C>([&](C const& call, CallOrigin const& origin) {
        into.push_back({call, origin.cause});
    });
}

} // namespace

void SoundResolver::advance(Access& access) {
    calls_.clear();
    gather<Strike>(access, calls_.strikes);
    gather<Rub>(access, calls_.rubs);
    gather<PlaySample>(access, calls_.plays);
    gather<HoldSample>(access, calls_.holds);
    SoundColumns const columns{access.read<Shape>(),   access.read<MadeOf>(),   access.read<Acoustics>(),
                               access.read<Sample>(),  access.read<Mass>(),     access.read<Fixed>(),
                               access.read<Liquid>(),  access.read<Position>(), access.read<Rotation>(),
                               access.read<Velocity>()};
    work_.follow(columns);
    if (calls_.empty() && !SoundWork::goesOn(access.provided<Sounds>())) {
        goesOn_ = false;
        return; // silence: components that read Sounds can continue to sleep
    }
    Sounds& sounds = access.provide<Sounds>();
    work_.advance(columns, calls_, access.duration(), sounds);
    sounds.frame = access.frame();
    goesOn_ = SoundWork::goesOn(sounds);
}

} // namespace trembler
