#include "puzzle/session/run.hpp"

#include "runtime/level/model/change_fault.hpp"
#include "runtime/level/model/world_change.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

namespace trembler {
namespace {

/// An input with names in place of object ids, for recording.
RecordedInput recorded(PlayerInput const& input, World const& world) {
    RecordedInput made;
    made.frame = world.frame() + 1;
    made.kind = input.kind;
    made.object = input.object.valid() ? world.store().nameOf(input.object) : "";
    made.other = input.other.valid() ? world.store().nameOf(input.other) : "";
    made.at = input.at;
    made.hand = input.hand;
    return made;
}

} // namespace

LevelRun::LevelRun(Registry const& registry, PartLibrary const& parts, LevelFile const& level,
                   std::span<Placement const> placements, WorldOptions const& options,
                   std::span<LevelConnection const> wires)
    : LevelRun(registry, level, buildLevel(registry, level, parts, placements, options, wires)) {}

LevelRun::LevelRun(Registry const& registry, LevelFile const& level, BuiltLevel built)
    : registry_(registry), level_(level), built_(std::move(built)), judge_(level, *built_.world) {}

std::optional<std::size_t> LevelRun::placementOf(ObjectId object) const {
    Origin const origin = world().store().originOf(object);
    return origin.kind == Origin::Kind::placement ? std::optional<std::size_t>(origin.number) : std::nullopt;
}

std::vector<ObjectId> LevelRun::pieces(Origin::Kind kind, std::size_t index) const {
    bool const placed = kind == Origin::Kind::placement;
    auto const& composites = placed ? built_.placementPieces : built_.objectPieces;
    if (auto const found = composites.find(index); found != composites.end()) {
        return found->second;
    }
    return {(placed ? built_.placements : built_.objects)[index]};
}

bool LevelRun::connectedAtStart(ObjectId a, ObjectId b) const {
    return std::binary_search(built_.connections.begin(), built_.connections.end(),
                              std::pair<ObjectId, ObjectId>(std::min(a, b), std::max(a, b)));
}

void LevelRun::takeOver(WorldOptions const& options) {
    for (RecordedChange const& back : differences(registry_, world().options(), options)) {
        if (back.kind == RecordedChange::Kind::detail) {
            built_.world->setDetail(back.subject, back.level);
        } else {
            built_.world->setPeriod(back.subject, static_cast<int>(back.value));
        }
    }
}

void LevelRun::step() {
    built_.world->step([this](World const& world) {
        judge_.update(world);
        noteGoals();
    });
}

void LevelRun::noteGoals() {
    World& world = *built_.world;
    if (world.tracer() == nullptr) {
        return;
    }
    for (std::size_t const goal : judge_.newlyMet()) {
        std::vector<ObjectId> const objects = judge_.objects(goal);
        std::vector<EventId> const causes = judge_.causes(world, goal);
        world.note("Goals", "goal met: " + judge_.status()[goal].id, objects, causes);
    }
    if (judge_.newlySolved()) {
        std::vector<EventId> const causes = judge_.causes(world);
        world.note("Goals", "solved", {}, causes);
    }
}

void LevelRun::feed(PlayerInput const& input) {
    if (begun()) {
        built_.world->feed(input);
        inputs_.push_back(recorded(input, world()));
    }
}

void LevelRun::change(RecordedChange change) {
    apply(registry_, *built_.world, change);
    if (begun()) {
        change.frame = world().frame() + 1;
        change.path.clear();
        changes_.push_back(std::move(change));
    }
}

void LevelRun::alter(std::string why, std::function<void(World&)> const& make) {
    if (make) {
        make(*built_.world);
    }
    if (!altered_) {
        altered_ = std::move(why);
    }
}

std::vector<RecordedChange> LevelRun::changesBefore() const {
    WorldOptions plain;
    plain.detail = level_.detail;
    return differences(registry_, plain, begunWith());
}

Solution LevelRun::record() const {
    std::uint64_t const last = world().frame();
    auto const wasSeen = [&](auto const& entry) { return entry.frame <= last; }; // by a frame
    Solution solution;
    std::copy_if(inputs_.begin(), inputs_.end(), std::back_inserter(solution.inputs), wasSeen);
    solution.changes = changesBefore();
    std::copy_if(changes_.begin(), changes_.end(), std::back_inserter(solution.changes), wasSeen);
    if (last > 0) {
        solution.frames = static_cast<int>(last);
    }
    solution.solves = judge_.solved() && !altered_;
    return solution;
}

std::optional<std::string> LevelRun::whyNotRecorded() const {
    if (altered_) {
        return altered_;
    }
    for (RecordedChange const& change : changesBefore()) {
        if (auto const fault = faultIn(registry_, world(), level_.detail, change)) {
            return inWords(*fault);
        }
    }
    return std::nullopt;
}

} // namespace trembler
