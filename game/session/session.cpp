#include "game/session/session.hpp"

#include "game/session/fit.hpp"
#include "runtime/level/build_world.hpp"
#include "runtime/level/world_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

namespace trembler {
namespace {

std::vector<Placement> placementsOf(std::vector<PlacedPart> const& placed) {
    std::vector<Placement> all;
    all.reserve(placed.size());
    for (PlacedPart const& part : placed) {
        all.push_back(part.placement);
    }
    return all;
}

auto withNumber(std::vector<PlacedPart>& placed, int number) {
    return std::find_if(placed.begin(), placed.end(),
                        [&](PlacedPart const& p) { return p.number == number; });
}

} // namespace

Session::Session(Registry const& registry, PartLibrary const& parts, LevelFile level, WorldOptions options)
    : registry_(registry), parts_(parts), level_(std::move(level)), options_(std::move(options)) {
    rebuild();
}

Session::~Session() = default;

void Session::rebuild() {
    std::vector<Placement> const placements = placementsOf(placed());
    world_ = buildWorld(registry_, level_, parts_, placements, options_);
    judge_ = std::make_unique<GoalJudge>(level_, *world_);
    // The world knows the parts by names that follow from their places, not from the order of placing.
    std::vector<Placement> const ordered = inCanonicalOrder(placements);
    std::vector<std::string> const names = placementNames(level_, placements);
    objects_.clear();
    for (PlacedPart const& part : placed()) {
        for (std::size_t i = 0; i < ordered.size(); ++i) {
            if (ordered[i].part == part.placement.part && ordered[i].at == part.placement.at &&
                ordered[i].angle == part.placement.angle) {
                objects_.emplace_back(part.number, world_->store().find(names[i]));
                break;
            }
        }
    }
}

std::vector<ToolboxSlot> Session::toolbox() const {
    std::vector<ToolboxSlot> slots;
    for (ToolboxEntry const& entry : level_.toolbox) {
        auto const used = std::count_if(placed().begin(), placed().end(),
                                        [&](PlacedPart const& p) { return p.placement.part == entry.part; });
        slots.push_back({entry.part, entry.count, entry.count - static_cast<int>(used)});
    }
    return slots;
}

ObjectId Session::objectOf(int number) const {
    auto const at =
        std::find_if(objects_.begin(), objects_.end(), [&](auto const& p) { return p.first == number; });
    return at == objects_.end() ? ObjectId{} : at->second;
}

std::optional<int> Session::numberOf(ObjectId object) const {
    auto const at =
        std::find_if(objects_.begin(), objects_.end(), [&](auto const& p) { return p.second == object; });
    return at == objects_.end() ? std::optional<int>{} : at->first;
}

Verdict Session::check(Placement const& placement, std::optional<int> ignoring) const {
    std::vector<Placement> others;
    std::vector<ObjectId> ignored;
    for (PlacedPart const& part : placed()) {
        if (part.number != ignoring) {
            others.push_back(part.placement);
        } else {
            ignored.push_back(objectOf(part.number));
        }
    }
    auto const why = checkPlacement(level_, parts_, others, placement, [&](Placement const& p) {
        return whyItDoesNotFit(*world_, parts_, p, ignored);
    });
    return why ? Verdict{false, *why} : Verdict{};
}

bool Session::changePlaced(Placed next) {
    scriptChanges_.clear();
    script_.clear(); // a solution that was loaded is not the player's any more
    history_.change(std::move(next));
    try {
        rebuild();
        return true;
    } catch (InputError const&) {
        history_.undo(); // a world that cannot be built is no place to be: stay where we were
        rebuild();
        return false;
    }
}

std::optional<int> Session::place(Placement const& placement) {
    if (mode_ != SessionMode::building || !check(placement).ok) {
        return {};
    }
    Placed next = placed();
    int const number = nextNumber_++;
    next.push_back({number, placement});
    return changePlaced(std::move(next)) ? std::optional<int>{number} : std::nullopt;
}

bool Session::move(int number, Vec2 at, double angle) {
    Placed next = placed();
    auto const part = withNumber(next, number);
    if (mode_ != SessionMode::building || part == next.end()) {
        return false;
    }
    Placement moved = part->placement;
    moved.at = at;
    moved.angle = angle;
    if (!check(moved, number).ok) {
        return false;
    }
    part->placement = std::move(moved);
    return changePlaced(std::move(next));
}

bool Session::putBack(int number) {
    Placed next = placed();
    auto const part = withNumber(next, number);
    if (mode_ != SessionMode::building || part == next.end()) {
        return false;
    }
    next.erase(part);
    return changePlaced(std::move(next));
}

bool Session::putAllBack() {
    return mode_ == SessionMode::building && !placed().empty() && changePlaced({});
}

bool Session::undo() {
    if (!canUndo() || !history_.undo()) {
        return false;
    }
    rebuild();
    return true;
}

bool Session::redo() {
    if (!canRedo() || !history_.redo()) {
        return false;
    }
    rebuild();
    return true;
}

void Session::start() {
    if (mode_ == SessionMode::building) {
        inputs_.clear();
        changes_.clear();
        startOptions_ = world_->options(); // what the level states is in it
        mode_ = SessionMode::running;
    }
}

void Session::pause() {
    if (mode_ == SessionMode::running) {
        mode_ = SessionMode::paused;
    }
}

void Session::resume() {
    if (mode_ == SessionMode::paused) {
        mode_ = SessionMode::running;
    }
}

void Session::stop() {
    if (mode_ != SessionMode::building) {
        mode_ = SessionMode::building;
        rebuild();
    }
}

void Session::step() {
    if (mode_ == SessionMode::building) {
        start();
    }
    feedRecorded();
    world_->step();
    judge_->update(*world_);
    noteGoals();
}

void Session::feed(PlayerInput const& input) {
    if (mode_ == SessionMode::building) {
        return;
    }
    world_->feed(input);
    inputs_.push_back(named(input));
}

void Session::startAgain() {
    stop();
    if (startOptions_) {
        for (RecordedChange const& back : differences(registry_, world_->options(), *startOptions_)) {
            apply(registry_, *world_, back);
        }
    }
    start();
}

void Session::change(RecordedChange change) {
    if (mode_ == SessionMode::building) {
        return;
    }
    apply(registry_, *world_, change);
    remember(std::move(change));
}

void Session::remember(RecordedChange change) {
    if (mode_ != SessionMode::building) {
        change.frame = world_->frame() + 1;
        change.path.clear();
        changes_.push_back(std::move(change));
    }
}

void Session::feedRecorded() {
    for (RecordedChange const& recorded : scriptChanges_) {
        if (recorded.frame == world_->frame() + 1) {
            change(recorded);
        }
    }
    for (RecordedInput const& input : script_) {
        if (input.frame == world_->frame() + 1) {
            if (std::optional<PlayerInput> const known = resolved(input)) {
                feed(*known);
            }
        }
    }
}

void Session::noteGoals() {
    if (world_->tracer() == nullptr) {
        return;
    }
    for (std::size_t const goal : judge_->newlyMet()) {
        std::vector<ObjectId> const objects = judge_->objects(goal);
        std::vector<EventId> const causes = judge_->causes(*world_, goal);
        world_->note("Goals", "goal met: " + judge_->status()[goal].id, objects, causes);
    }
    if (judge_->solvedFrame() == world_->frame()) {
        std::vector<EventId> const causes = judge_->causes(*world_);
        world_->note("Goals", "solved", {}, causes);
    }
}

RecordedInput Session::named(PlayerInput const& input) const {
    RecordedInput recorded;
    recorded.frame = world_->frame() + 1;
    recorded.kind = input.kind;
    recorded.object = input.object.valid() ? world_->store().nameOf(input.object) : "";
    recorded.other = input.other.valid() ? world_->store().nameOf(input.other) : "";
    recorded.at = input.at;
    return recorded;
}

std::optional<PlayerInput> Session::resolved(RecordedInput const& input) const {
    PlayerInput found{input.kind, world_->store().find(input.object), world_->store().find(input.other),
                      input.at};
    // What was grabbed or cut then may not exist any more in a run that took another course.
    bool const known =
        (input.object.empty() || found.object.valid()) && (input.other.empty() || found.other.valid());
    return known ? std::optional<PlayerInput>{found} : std::nullopt;
}

Solution Session::record(std::string name) const {
    Solution solution;
    solution.name = std::move(name);
    solution.placements = inCanonicalOrder(placementsOf(placed()));
    solution.inputs = inputs_;
    WorldOptions plain;
    plain.detail = level_.detail;
    solution.changes =
        differences(registry_, plain, mode_ == SessionMode::building ? world_->options() : *startOptions_);
    solution.changes.insert(solution.changes.end(), changes_.begin(), changes_.end());
    solution.frames = static_cast<int>(world_->frame());
    solution.solves = solved();
    return solution;
}

void Session::load(Solution const& solution) {
    stop();
    Placed next;
    Problems problems;
    std::vector<Placement> before;
    for (Placement const& placement : solution.placements) {
        if (auto const why = checkPlacement(level_, parts_, before, placement)) {
            problems.add(level_.diagnostic(placement.path, *why, "a placement that the level allows"));
        }
        before.push_back(placement);
        next.push_back({nextNumber_++, placement});
    }
    auto const faults = faultsIn(registry_, solution.changes);
    for (std::size_t i = 0; i < faults.size(); ++i) {
        if (faults[i]) {
            problems.add(level_.diagnostic(solution.changes[i].path, *faults[i], ""));
        }
    }
    problems.throwIfAny();
    Placed const previous = placed();
    history_.change(std::move(next));
    try {
        rebuild();
    } catch (InputError const&) {
        history_.change(previous);
        rebuild();
        throw;
    }
    script_ = solution.inputs;
    scriptChanges_ = solution.changes;
}

void Session::setDetail(std::string const& effect, std::string const& level) {
    RecordedChange made;
    made.kind = RecordedChange::Kind::detail;
    made.subject = effect;
    made.level = level;
    world_->setDetail(effect, level);
    if (level.empty()) {
        options_.detail.erase(effect);
    } else {
        options_.detail[effect] = level;
    }
    remember(std::move(made));
}

void Session::setPeriod(std::string const& component, int period) {
    RecordedChange made;
    made.kind = RecordedChange::Kind::period;
    made.value = period;
    world_->setPeriod(component, period);
    made.subject = component;
    for (ComponentStatus const& status : world_->status()) { // a bare name will do as well
        std::string const full = title(*status.info);
        if (full == component) {
            made.subject = full;
            break;
        }
        if (status.info->text.name == component) {
            made.subject = full;
        }
    }
    options_.periods[made.subject] = period;
    remember(std::move(made));
}

bool Session::solved() const {
    return judge_->solved();
}

} // namespace trembler
