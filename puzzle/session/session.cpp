#include "puzzle/session/session.hpp"

#include "puzzle/session/fit.hpp"
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/model/world_change.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <map>
#include <stdexcept>
#include <string_view>
#include <tuple>

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

/// Those of a frame, out of all in order of their frames.
template <class Recorded>
std::span<Recorded const> ofFrame(std::vector<Recorded> const& all, std::uint64_t frame) {
    auto const first =
        std::partition_point(all.begin(), all.end(), [&](Recorded const& r) { return r.frame < frame; });
    auto const last = std::find_if(first, all.end(), [&](Recorded const& r) { return r.frame != frame; });
    return {first, last};
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
    std::map<std::tuple<std::string, double, double, double>, std::size_t> places; // the first of equals
    for (std::size_t i = 0; i < ordered.size(); ++i) {
        Placement const& placement = ordered[i];
        places.try_emplace({placement.part, placement.at.x, placement.at.y, placement.angle}, i);
    }
    objects_.clear();
    for (PlacedPart const& part : placed()) {
        Placement const& placement = part.placement;
        auto const at = places.find({placement.part, placement.at.x, placement.at.y, placement.angle});
        if (at != places.end()) {
            objects_.emplace_back(part.number, world_->store().find(names[at->second]));
        }
    }
}

std::vector<ToolboxSlot> Session::toolbox() const {
    std::map<std::string_view, int> used;
    for (PlacedPart const& part : placed()) {
        ++used[part.placement.part];
    }
    std::vector<ToolboxSlot> slots;
    for (ToolboxEntry const& entry : level_.toolbox) {
        slots.push_back({entry.part, entry.count, entry.count - used[entry.part]});
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
    world_->step([this](World const& world) {
        judge_->update(world);
        noteGoals();
    });
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
            if (back.kind == RecordedChange::Kind::detail) { // whatever it was, it is not for us to judge
                world_->setDetail(back.subject, back.level);
            } else {
                world_->setPeriod(back.subject, static_cast<int>(back.value));
            }
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
    std::uint64_t const next = world_->frame() + 1;
    for (RecordedChange const& recorded : ofFrame(scriptChanges_, next)) {
        change(recorded);
    }
    for (RecordedInput const& input : ofFrame(script_, next)) {
        if (std::optional<PlayerInput> const known = resolved(input)) {
            feed(*known);
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
    if (judge_->newlySolved()) {
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
    std::uint64_t const last = world_->frame();
    std::copy_if(
        inputs_.begin(), inputs_.end(), std::back_inserter(solution.inputs),
        [&](RecordedInput const& input) { return input.frame <= last; }); // no frame has seen the others
    WorldOptions plain;
    plain.detail = level_.detail;
    solution.changes =
        differences(registry_, plain, mode_ == SessionMode::building ? world_->options() : *startOptions_);
    std::copy_if(changes_.begin(), changes_.end(), std::back_inserter(solution.changes),
                 [&](RecordedChange const& change) { return change.frame <= last; });
    if (last > 0) {
        solution.frames = static_cast<int>(last);
    }
    solution.solves = solved();
    return solution;
}

void Session::load(Solution const& solution) {
    stop();
    Placed next;
    Problems problems;
    auto const complain = [&](std::string const& path, std::string message, std::string expected) {
        addProblem(problems, [&] {
            return solution.document
                       ? solution.document->diagnostic(path, std::move(message), std::move(expected))
                       : level_.diagnostic(path, std::move(message), std::move(expected));
        });
    };
    PlacementCount count(level_, parts_);
    for (Placement const& placement : solution.placements) {
        if (auto const why = count.add(placement)) {
            complain(placement.path, *why, "a placement that the level allows");
        }
        next.push_back({nextNumber_++, placement});
    }
    problems.throwIfAny();
    Placed const previous = placed();
    history_.change(std::move(next));
    try {
        rebuild();
        for (RecordedChange const& change : solution.changes) { // of the world with all that is placed
            if (auto const fault = faultIn(registry_, *world_, change)) {
                complain(change.path, fault->message, fault->expected);
            }
        }
        problems.throwIfAny();
    } catch (InputError const&) {
        history_.change(previous);
        rebuild();
        throw;
    }
    auto const earlier = [](auto const& a, auto const& b) { return a.frame < b.frame; };
    script_ = solution.inputs;
    scriptChanges_ = solution.changes;
    std::stable_sort(script_.begin(), script_.end(), earlier);
    std::stable_sort(scriptChanges_.begin(), scriptChanges_.end(), earlier);
}

void Session::setDetail(std::string const& effect, std::string const& level) {
    RecordedChange made;
    made.kind = RecordedChange::Kind::detail;
    made.subject = effect;
    made.level = level;
    apply(registry_, *world_, made);
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
    apply(registry_, *world_, made);
    options_.periods[made.subject] = period;
    remember(std::move(made));
}

std::optional<std::string> Session::whyNotDetail(std::string const& effect, std::string const& level) const {
    RecordedChange asked;
    asked.kind = RecordedChange::Kind::detail;
    asked.subject = effect;
    asked.level = level;
    auto const fault = faultIn(registry_, *world_, asked);
    return fault ? std::optional(inWords(*fault)) : std::nullopt;
}

std::optional<std::string> Session::whyNotRecorded() const {
    WorldOptions plain;
    plain.detail = level_.detail;
    WorldOptions const& begun =
        mode_ == SessionMode::building || !startOptions_ ? world_->options() : *startOptions_;
    for (RecordedChange const& change : differences(registry_, plain, begun)) {
        if (auto const fault = faultIn(registry_, *world_, level_.detail, change)) {
            return inWords(*fault);
        }
    }
    return std::nullopt;
}

bool Session::solved() const {
    return judge_->solved();
}

} // namespace trembler
