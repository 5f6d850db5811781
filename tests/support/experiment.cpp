#include "tests/support/experiment.hpp"

#include "physics/electricity/properties/electrical.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace trembler {
namespace {

bool isIn(std::vector<TouchingPair> const& pairs, ObjectId a, ObjectId b) {
    return std::binary_search(pairs.begin(), pairs.end(), TouchingPair{std::min(a, b), std::max(a, b), {}});
}

} // namespace

LevelFile Experiment::load(std::string const& file) {
    return loadLevel(gameData().registry, gameData().home / "levels/experiments" / file);
}

void Experiment::open(std::string const& file, std::string const& solution, bool trace) {
    open(load(file), solution, trace);
}

void Experiment::open(LevelFile level, std::string const& solution, bool trace) {
    WorldOptions options;
    options.trace = trace;
    session_ = std::make_unique<Session>(gameData().registry, gameData().parts, std::move(level), options);
    if (!solution.empty()) {
        Solution const* const recorded = session_->level().findSolution(solution);
        ASSERT_NE(recorded, nullptr) << solution;
        session_->load(*recorded);
    }
}

void Experiment::runTo(std::uint64_t frame) {
    while (world().frame() < frame) {
        step();
    }
}

std::vector<std::uint64_t> Experiment::hits(std::string const& a, std::string const& b, std::uint64_t frame) {
    std::vector<std::uint64_t> frames;
    while (world().frame() < frame) {
        step();
        auto const& contacts = *world().find<Contacts>();
        if (isIn(contacts.begun, id(a), id(b)) || isIn(contacts.brief, id(a), id(b))) {
            frames.push_back(world().frame());
        }
    }
    return frames;
}

ObjectId Experiment::id(std::string const& name) const {
    return world().store().find(name);
}

Vec2 Experiment::at(std::string const& name) const {
    return world().find<Position>(id(name))->value;
}

double Experiment::angle(std::string const& name) const {
    return world().find<Rotation>(id(name))->angle;
}

double Experiment::spin(std::string const& name) const {
    return world().find<AngularVelocity>(id(name))->value;
}

bool Experiment::on(std::string const& name) const {
    return world().find<ElectricalState>()->isOn(id(name));
}

bool Experiment::touching(std::string const& a, std::string const& b) const {
    return isIn(world().find<Contacts>()->current, id(a), id(b));
}

std::vector<Event const*> Experiment::events(std::string const& event,
                                             std::vector<std::string> const& objects) const {
    std::vector<Event const*> found;
    for (Event const& e : world().tracer()->events()) {
        bool const all = std::all_of(objects.begin(), objects.end(), [&](std::string const& name) {
            return std::find(e.objects.begin(), e.objects.end(), name) != e.objects.end();
        });
        if (e.event == event && all) {
            found.push_back(&e);
        }
    }
    return found;
}

Event const& Experiment::first(std::string const& event, std::vector<std::string> const& objects,
                               std::uint64_t frame) const {
    for (Event const* const e : events(event, objects)) {
        if (e->frame >= frame) {
            return *e;
        }
    }
    static Event const none{};
    ADD_FAILURE() << "no " << event << " of " << objects.front() << " from frame " << frame;
    return none;
}

bool Experiment::led(Event const& from, Event const& to) const {
    std::vector<EventId> const chain = world().tracer()->chain(to.id);
    return std::binary_search(chain.begin(), chain.end(), from.id);
}

double mean(std::vector<double> const& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

double relativeDeviation(std::vector<double> const& values) {
    double const middle = mean(values);
    double squares = 0;
    for (double const value : values) {
        squares += (value - middle) * (value - middle);
    }
    return std::sqrt(squares / static_cast<double>(values.size())) / std::abs(middle);
}

std::vector<double> intervals(std::vector<std::uint64_t> const& frames) {
    std::vector<double> between;
    for (std::size_t i = 1; i < frames.size(); ++i) {
        between.push_back(static_cast<double>(frames[i] - frames[i - 1]));
    }
    return between;
}

} // namespace trembler
