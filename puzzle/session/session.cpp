#include "puzzle/session/session.hpp"

#include "puzzle/session/check_solution.hpp"
#include "puzzle/session/refused_solution.hpp"
#include "runtime/level/build/placing.hpp"
#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/diagnostic.hpp"

#include <utility>

namespace trembler {

Session::Session(Registry const& registry, PartLibrary const& parts, LevelFile level, WorldOptions options)
    : registry_(registry), parts_(parts), level_(std::move(level)), options_(std::move(options)),
      placements_(level_, parts_), run_(runOf({}, {})) {}

Session::Session(Registry const& registry, PartLibrary const& parts, ReadyLevel ready)
    : registry_(registry), parts_(parts), level_(std::move(ready.level)), options_(std::move(ready.options)),
      placements_(level_, parts_),
      run_(std::make_unique<LevelRun>(registry_, level_, std::move(ready.built))) {}

std::unique_ptr<LevelRun> Session::runOf(Placements::List const& placed,
                                         std::vector<LaidWire> const& wires) const {
    return std::make_unique<LevelRun>(registry_, parts_, level_, placementsOf(placed), options_,
                                      connectionsOf(wires, WireEnds(level_, parts_, placed)));
}

std::unique_ptr<LevelRun> Session::runIfBuilt(Placements::List const& placed,
                                              std::vector<LaidWire> const& wires,
                                              std::optional<std::string>* why) const {
    try {
        return runOf(placed, wires);
    } catch (InputError const& error) {
        if (why != nullptr) {
            *why = error.diagnostics().front().print();
        }
        return nullptr;
    }
}

SessionMode Session::mode() const {
    if (building()) {
        return SessionMode::building;
    }
    return paused_ ? SessionMode::paused : SessionMode::running;
}

ObjectId Session::objectOf(int number) const {
    auto const index = placements_.indexOf(number);
    return index ? run_->objectOf(*index) : ObjectId{};
}

std::vector<ObjectId> Session::objectsOf(int number) const {
    auto const index = placements_.indexOf(number);
    return index ? run_->pieces(Origin::Kind::placement, *index) : std::vector<ObjectId>();
}

std::optional<int> Session::numberOf(ObjectId object) const {
    auto const index = run_->placementOf(object);
    return index ? std::optional(placed()[*index].number) : std::nullopt;
}

LastingObject Session::lasting(ObjectId object) const {
    Origin const origin = world().store().originOf(object);
    switch (origin.kind) {
    case Origin::Kind::placement:
        return {origin.kind, static_cast<std::uint64_t>(placed()[origin.number].number), {}, origin.piece};
    case Origin::Kind::object:
    case Origin::Kind::joint:
        return {origin.kind, origin.number, {}, origin.piece};
    case Origin::Kind::program:
    case Origin::Kind::world:
    case Origin::Kind::birth:
        break;
    }
    return world().store().alive(object) ? LastingObject{origin.kind, 0, world().store().nameOf(object)}
                                         : LastingObject{};
}

ObjectId Session::find(LastingObject const& object) const {
    Store const& store = world().store();
    auto const living = [&](ObjectId id) { return store.alive(id) ? id : ObjectId{}; };
    switch (object.kind) {
    case Origin::Kind::placement: {
        std::vector<ObjectId> const pieces = objectsOf(static_cast<int>(object.number));
        return object.piece < pieces.size() ? living(pieces[object.piece]) : ObjectId{};
    }
    case Origin::Kind::object:
        return living(run_->pieces(object.kind, object.number)[object.piece]);
    case Origin::Kind::joint:
        return living(run_->joints()[object.number]);
    case Origin::Kind::program:
    case Origin::Kind::world:
    case Origin::Kind::birth:
        break;
    }
    ObjectId const named = store.find(object.name);
    return store.originOf(named).kind == object.kind ? named : ObjectId{};
}

Verdict Session::check(Placement const& placement, std::optional<int> ignoring) const {
    return placements_.check(placement, world(), ignoring,
                             ignoring ? objectsOf(*ignoring) : std::vector<ObjectId>());
}

void Session::forgetOldest() {
    std::size_t const each = placements_.now().size() + wires_.now().size() + 1; // in one state
    std::size_t const states = std::clamp(mostUndoneEntries / each, leastUndo, mostUndo);
    placements_.forgetBefore(states);
    wires_.forgetBefore(states);
}

bool Session::keep(std::optional<Placements::List> next, std::vector<LaidWire> wires) {
    if (!next) {
        return false;
    }
    wires = stillLaid(std::move(wires), WireEnds(level_, parts_, *next));
    std::unique_ptr<LevelRun> run = runIfBuilt(*next, wires);
    if (run == nullptr) {
        return false;
    }
    placements_.keep(std::move(*next));
    wires_.change(std::move(wires));
    forgetOldest();
    solution_ = {}; // its inputs belong to the placements that it was loaded with
    use(std::move(run));
    return true;
}

std::optional<int> Session::place(Placement const& placement) {
    if (!building() || !check(placement).ok) {
        return {};
    }
    Placements::List next = placements_.with(placement);
    int const number = next.back().number;
    return keep(std::move(next)) ? std::optional(number) : std::nullopt;
}

bool Session::move(int number, Vec2 at, double angle, std::optional<bool> flipped) {
    auto next = building() ? placements_.moved(number, at, angle, flipped) : std::nullopt;
    return next && check((*next)[*placements_.indexOf(number)].placement, number).ok && keep(std::move(next));
}

bool Session::flip(int number) {
    auto const index = placements_.indexOf(number);
    if (!index) {
        return false;
    }
    Placement const& placement = placed()[*index].placement;
    return move(number, placement.at, placement.angle, !placement.flipped);
}

bool Session::putBack(int number) {
    return building() && keep(placements_.without(number));
}

bool Session::putAllBack() {
    return building() && !(placed().empty() && wires().empty()) && keep(Placements::List{}, {});
}

bool Session::undo() {
    if (!canUndo() || !placements_.undo() || !wires_.undo()) {
        return false;
    }
    placedOtherwise();
    return true;
}

bool Session::redo() {
    if (!canRedo() || !placements_.redo() || !wires_.redo()) {
        return false;
    }
    placedOtherwise();
    return true;
}

void Session::placedOtherwise() {
    auto run = runOf(placed(), wires());
    solution_ = {};
    use(std::move(run));
}

void Session::use(std::unique_ptr<LevelRun> run) {
    run_ = std::move(run);
    if (built_) {
        built_();
    }
}

std::optional<std::string> Session::whyNotBuilt() const {
    std::optional<std::string> why;
    (void)runIfBuilt(placed(), wires(), &why);
    return why;
}

void Session::rebuild() {
    if (building()) {
        use(runOf(placed(), wires()));
    }
}

void Session::start() {
    if (building()) {
        run_->begin();
        lastBegunWith_ = run_->begunWith();
        paused_ = false;
    }
}

void Session::pause() {
    paused_ = true;
}

void Session::resume() {
    paused_ = false;
}

void Session::stop() {
    if (!building()) {
        auto run = runOf(placed(), wires());
        played_.reset();
        use(std::move(run));
    }
}

void Session::step() {
    start();
    (played_ ? *played_ : solution_).feed(*run_);
    run_->step();
}

void Session::feed(PlayerInput const& input) {
    run_->feed(input);
}

void Session::startAgain() {
    stop();
    if (lastBegunWith_) {
        run_->takeOver(*lastBegunWith_);
    }
    start();
}

Playback Session::done() const {
    return {{inputs().begin(), inputs().end()}, {changes().begin(), changes().end()}};
}

void Session::play(Playback playback) {
    if (!building()) {
        played_ = std::move(playback);
        takenOver_ = false;
    }
}

void Session::takeOver() {
    if (played_) {
        played_ = Playback();
        takenOver_ = true;
    }
}

Solution Session::record(std::string name) const {
    Solution solution = run_->record();
    solution.name = std::move(name);
    solution.placements = inCanonicalOrder(placementsOf(placed()));
    solution.wires = connectionsOf(wires(), WireEnds(level_, parts_, placed()));
    return solution;
}

void Session::load(Solution const& solution) {
    stop();
    Placements::List next = placements_.those(solution);
    std::vector<LaidWire> wires = wiresOf(solution, next);
    std::unique_ptr<LevelRun> run;
    try {
        run = runOf(next, wires);
    } catch (InputError const& error) {
        auto const builds = [&](std::size_t count) {
            Placements::List const some(next.begin(), next.begin() + static_cast<std::ptrdiff_t>(count));
            return runIfBuilt(some, {}) != nullptr;
        };
        throw refusedSolution(level_, solution, builds, error);
    }
    Problems problems;
    checkSolution(registry_, level_, *run, solution, problems); // in the world with all placements
    problems.throwIfAny();
    placements_.keep(std::move(next));
    wires_.change(std::move(wires));
    forgetOldest();
    solution_ = Playback(solution.inputs, solution.changes);
    use(std::move(run));
}

} // namespace trembler
