#include "insight/why/story/main_pulls.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/magnetism/properties.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <utility>

namespace trembler::insight {
namespace main_pulls {
namespace {

/// Of a pull and a push by the same magnet, one that is weaker than this share of the other is left out.
constexpr double leastShare = 0.1;

/// Of what several magnets do to a body, a force that is weaker than this share of the greatest is left out.
constexpr double leastShareOfAll = 0.05;

/// m/s². A force that gives its object less than this acceleration is left out.
constexpr double leastAcceleration = 0.01;

} // namespace
} // namespace main_pulls

MainPulls::Body MainPulls::bodyOf(std::string const& name, Groups const& tied) {
    auto const at = tied.find(name);
    return at == tied.end() ? Body{0, name} : Body{at->second + 1, ""};
}

void MainPulls::look(World const& world, Groups const& tied) {
    auto const* const magnetic = world.find<MagneticForce>();
    if (magnetic == nullptr || (magnetic->actions.empty() && histories_.empty())) {
        return;
    }
    tied_ = tied;
    struct Strongest {
        MagneticForce::Action const* pull = nullptr;
        MagneticForce::Action const* push = nullptr;
    };
    std::map<std::pair<Body, std::string>, Strongest> now;
    std::map<Body, double> greatest; // N
    for (MagneticForce::Action const& action : magnetic->actions) {
        std::string const by = world.store().nameOf(action.by);
        Mass const* const mass = world.find<Mass>(action.object);
        if (mass != nullptr && action.force < main_pulls::leastAcceleration * mass->value) {
            continue;
        }
        // That iron pulls the magnet that pulls it is told by the magnet's pull.
        if (world.find<Magnet>(action.by) == nullptr && world.find<Velocity>(action.by) != nullptr) {
            continue;
        }
        Body body = bodyOf(world.store().nameOf(action.object), tied);
        if (body.first > 0 && body == bodyOf(by, tied)) {
            continue;
        }
        double& ofBody = greatest[body];
        ofBody = std::max(ofBody, action.force);
        Strongest& most = now[{std::move(body), by}];
        auto const*& same = action.push ? most.push : most.pull;
        same = same == nullptr || action.force > same->force ? &action : same;
    }
    for (auto& [key, history] : histories_) {
        if (!now.contains(key) && history.back().acting) {
            Since ended = history.back();
            ended.frame = world.frame();
            ended.acting = false;
            history.push_back(ended);
        }
    }
    for (auto const& [key, most] : now) {
        double const pull = most.pull == nullptr ? 0 : most.pull->force;
        double const push = most.push == nullptr ? 0 : most.push->force;
        Since since{world.frame(), {}, {}, true, false};
        since.pull = pull > main_pulls::leastShare * push ? most.pull->event : EventId{};
        since.push = push > main_pulls::leastShare * pull ? most.push->event : EventId{};
        since.weak = std::max(pull, push) < main_pulls::leastShareOfAll * greatest[key.first];
        std::vector<Since>& history = histories_[key];
        if (history.empty() || !history.back().acting || history.back().pull != since.pull ||
            history.back().push != since.push || history.back().weak != since.weak) {
            history.push_back(since);
        }
        if (!since.weak) {
            main_.insert({since.pull, since.push});
        }
    }
    main_.erase(EventId{});
}

std::vector<MainPulls::Pull> MainPulls::on(std::string const& object, std::uint64_t frame) const {
    std::vector<Pull> all;
    Body const body = bodyOf(object, tied_);
    for (auto at = histories_.lower_bound({body, ""}); at != histories_.end() && at->first.first == body;
         ++at) {
        std::vector<Since> const& history = at->second;
        auto const after =
            std::lower_bound(history.begin(), history.end(), frame,
                             [](Since const& since, std::uint64_t f) { return since.frame < f; });
        if (after == history.begin()) {
            continue;
        }
        Since const& then = *(after - 1);
        for (EventId const event : {then.pull, then.push}) {
            if (event && !then.weak) {
                all.push_back({event, at->first.second, then.acting});
            }
        }
    }
    return all;
}

} // namespace trembler::insight
