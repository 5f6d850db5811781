#include "puzzle/session/placements.hpp"

#include "puzzle/session/fit.hpp"
#include "puzzle/session/zone.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/json/add_problem.hpp"

#include <algorithm>
#include <map>
#include <string_view>

namespace trembler {

std::vector<Placement> placementsOf(Placements::List const& placed) {
    std::vector<Placement> all;
    all.reserve(placed.size());
    for (PlacedPart const& part : placed) {
        all.push_back(part.placement);
    }
    return all;
}

Placements::Placements(LevelFile const& level, PartLibrary const& parts) : level_(level), parts_(parts) {}

std::optional<std::size_t> Placements::indexOf(int number) const {
    auto const at = std::find_if(now().begin(), now().end(),
                                 [&](PlacedPart const& part) { return part.number == number; });
    return at == now().end() ? std::nullopt : std::optional(static_cast<std::size_t>(at - now().begin()));
}

std::vector<ToolboxSlot> Placements::toolbox() const {
    std::map<std::string_view, int> used;
    for (PlacedPart const& part : now()) {
        ++used[part.placement.part];
    }
    std::vector<ToolboxSlot> slots;
    for (ToolboxEntry const& entry : level_.toolbox) {
        slots.push_back({entry.part, entry.count, leftOf(entry.count, used[entry.part])});
    }
    return slots;
}

Verdict Placements::check(Placement const& placement, World const& world, std::optional<int> moved,
                          std::span<ObjectId const> ignored) const {
    std::vector<Placement> others;
    for (PlacedPart const& part : now()) {
        if (part.number != moved) {
            others.push_back(part.placement);
        }
    }
    std::optional<std::string> why = checkPlacement(level_, parts_, others, placement);
    if (!why) {
        why = whyItSticksOut(level_, parts_, placement);
    }
    if (!why) {
        why = whyItDoesNotFit(world, parts_, placement, ignored);
    }
    return why ? Verdict{false, *why} : Verdict{};
}

Placements::List Placements::with(Placement placement) {
    List next = now();
    next.push_back({nextNumber_++, std::move(placement)});
    return next;
}

Placements::List Placements::withAll(std::span<Placement const> added) {
    List next = now();
    for (Placement const& placement : added) {
        next.push_back({nextNumber_++, placement});
    }
    return next;
}

std::optional<Placements::List> Placements::moved(int number, Vec2 at, double angle,
                                                  std::optional<bool> flipped) const {
    auto const index = indexOf(number);
    if (!index) {
        return std::nullopt;
    }
    List next = now();
    next[*index].placement.at = at;
    next[*index].placement.angle = angle;
    next[*index].placement.flipped = flipped.value_or(next[*index].placement.flipped);
    return next;
}

std::optional<Placements::List> Placements::without(int number) const {
    auto const index = indexOf(number);
    if (!index) {
        return std::nullopt;
    }
    List next = now();
    next.erase(next.begin() + static_cast<std::ptrdiff_t>(*index));
    return next;
}

Placements::List Placements::those(Solution const& solution) {
    List next;
    Problems problems;
    PlacementCount count(level_, parts_);
    for (Placement const& placement : solution.placements) {
        if (auto const why = count.add(placement)) {
            addProblem(problems, [&] {
                return level_.diagnostic(solution, placement.path, *why, "a placement that the level allows");
            });
        }
        next.push_back({nextNumber_++, placement});
    }
    problems.throwIfAny();
    return next;
}

} // namespace trembler
