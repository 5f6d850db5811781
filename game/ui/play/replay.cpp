#include "game/ui/play/replay.hpp"

namespace trembler::ui {

void Replay::beforeStep(Session& session) const {
    World const& world = session.world();
    for (RecordedChange const& change : changes_) {
        if (change.frame == world.frame() + 1) {
            session.change(change);
        }
    }
    for (RecordedInput const& input : inputs_) {
        if (input.frame != world.frame() + 1) {
            continue;
        }
        PlayerInput const known{input.kind, world.store().find(input.object), world.store().find(input.other),
                                input.at};
        bool const there =
            (input.object.empty() || known.object.valid()) && (input.other.empty() || known.other.valid());
        if (there) {
            session.feed(known);
        }
    }
}

} // namespace trembler::ui
