#include "game/ui/play/mouse/turn_handle.hpp"

namespace trembler::ui {
namespace {

/// How far from a part's own edge its handle stands, pixels at UI scale 1.
constexpr double handleGap = 26;

} // namespace

std::optional<TurnHandle> turnHandle(Session const& session, PlacingTool const& placing, PartCatalog& catalog,
                                     double pixel, std::function<bool(Vec2)> const& covered) {
    if (session.mode() != SessionMode::building || !placing.selected()) {
        return {};
    }
    auto const& carried = placing.carried();
    if (carried && !carried->turning) {
        return {};
    }
    Placement const* const placement = carried ? &carried->landing : placing.placementOf(*placing.selected());
    if (placement == nullptr) {
        return {};
    }
    double const arm = catalog.radius(placement->part) + handleGap * pixel;
    Vec2 const above = placement->at + rotated({0, arm}, placement->angle);
    Vec2 const below = placement->at - rotated({0, arm}, placement->angle);
    bool const atBelow = carried ? carried->handleBelow : covered(above) && !covered(below);
    return TurnHandle{atBelow ? below : above, placement->angle + (atBelow ? -pi / 2 : pi / 2), *placement};
}

} // namespace trembler::ui
