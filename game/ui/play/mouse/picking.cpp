#include "game/ui/play/mouse/picking.hpp"

#include "render/scene/facts/pick.hpp"

namespace trembler::ui {
namespace {

/// The mouse points at an object within this distance of it, pixels at UI scale 1.
constexpr double pickReach = 6;

} // namespace

void Picking::pointAt(Pointer const& pointer) {
    bool const open = !pointer.overCard && pointer.inside;
    render::Point const at{pointer.world.x, pointer.world.y};
    hovered_ = open
                   ? render::pick(past_ != nullptr ? *past_ : session_.world(), at, pickReach * pointer.pixel)
                   : ObjectId{};
}

void Picking::inspect(ObjectId object) {
    inspector_.show(session_, object);
}

} // namespace trembler::ui
