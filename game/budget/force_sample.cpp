#include "game/budget/force_sample.hpp"

#include "physics/dynamics/properties/body.hpp"
#include "physics/inverse_square/grid.hpp"
#include "physics/inverse_square/kernels.hpp"
#include "runtime/placement.hpp"

#include <algorithm>
#include <cmath>

namespace trembler::budget {
namespace {

void moveOnAll(World const& world, double seconds, inverse_square::Points& points) {
    auto const* const velocities = world.store().findColumn<Velocity>();
    auto const* const fixed = world.store().findColumn<Fixed>();
    for (std::size_t i = 0; velocities != nullptr && i < points.size(); ++i) {
        ObjectId const id = world.store().objects().at(static_cast<std::uint32_t>(points.owner[i]));
        Velocity const* const velocity = velocities->find(id);
        if (velocity != nullptr && (fixed == nullptr || !fixed->has(id))) {
            points.x[i] += seconds * velocity->value.x;
            points.y[i] += seconds * velocity->value.y;
        }
    }
}

} // namespace

int Sample::find(std::uint32_t index) const {
    auto const at = std::lower_bound(bodies.begin(), bodies.end(), index,
                                     [](Body const& body, std::uint32_t i) { return body.object.index < i; });
    return at == bodies.end() || at->object.index != index ? -1 : static_cast<int>(at - bodies.begin());
}

Sample sampleOf(World const& world, std::function<bool(ObjectId)> const& counts) {
    std::vector<Sample::Body> all;
    auto const* const masses = world.store().findColumn<Mass>();
    auto const* const fixed = world.store().findColumn<Fixed>();
    for (std::size_t row = 0; masses != nullptr && row < masses->size(); ++row) {
        ObjectId const id = masses->owners()[row];
        if ((fixed == nullptr || !fixed->has(id)) && counts(id)) {
            all.push_back({id, masses->values()[row].value});
        }
    }
    Sample sample;
    std::size_t const count = std::min(all.size(), sampleSize);
    for (std::size_t i = 0; i < count; ++i) {
        sample.bodies.push_back(all[(2 * i + 1) * all.size() / (2 * count)]);
    }
    return sample;
}

Error errorOf(Sample const& sample, std::span<Vec2 const> forces, std::span<Vec2 const> right,
              std::span<double const> stiffness) {
    if (sample.bodies.empty()) {
        return {};
    }
    double off = 0;
    double wrong = 0;
    double all = 0;
    for (std::size_t i = 0; i < sample.bodies.size(); ++i) {
        double const square = lengthSquared(forces[i] - right[i]);
        double const mass = sample.bodies[i].mass;
        double const yields = stiffness.empty() ? 0 : stiffness[i];
        // N/m: the force error that displaces the body by 1 m in the first second.
        double const give = std::max(2 * mass, yields);
        off += square / (give * give);
        wrong += square;
        all += lengthSquared(right[i]);
    }
    return {std::sqrt(off / static_cast<double>(sample.bodies.size())), all > 0 ? std::sqrt(wrong / all) : 0};
}

void SampledSum::receive(inverse_square::Points const& all, Sample const& sample) {
    receivers.clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (sample.find(static_cast<std::uint32_t>(all.owner[i])) >= 0) {
            receivers.add(all.at(i), all.weight[i], all.owner[i]);
        }
    }
}

void SampledSum::moveOn(World const& world, double seconds) {
    moveOnAll(world, seconds, sources);
    moveOnAll(world, seconds, receivers);
}

std::vector<Vec2> forcesOn(Sample const& sample, std::span<SampledSum const> sums, AddUp const& addUp) {
    std::vector<Vec2> forces(sample.bodies.size());
    for (SampledSum const& sum : sums) {
        if (sum.sources.empty() || sum.receivers.empty()) {
            continue;
        }
        std::vector<Vec2> totals(sum.receivers.size());
        addUp(sum, totals);
        for (std::size_t i = 0; i < totals.size(); ++i) {
            int const body = sample.find(static_cast<std::uint32_t>(sum.receivers.owner[i]));
            forces[static_cast<std::size_t>(body)] += totals[i];
        }
    }
    return forces;
}

void addPairs(SampledSum const& sum, std::span<Vec2> totals) {
    inverse_square::addAllPairs(sum.sources, sum.receivers, 0, sum.receivers.size(), sum.softening2, totals);
}

AddUp byGrid(double inner, double cutoff) {
    return [=](SampledSum const& sum, std::span<Vec2> totals) {
        inverse_square::Grid grid;
        grid.build(sum.sources, cutoff);
        grid.setReceivers(sum.receivers);
        grid.add(0, totals.size(), inner, sum.softening2, totals);
    };
}

Error Staleness::of(int period) {
    if (period <= 1) {
        return {};
    }
    auto const [at, isNew] = known_.try_emplace(period);
    if (isNew) {
        std::vector<SampledSum> moved(sums_.begin(), sums_.end());
        for (SampledSum& sum : moved) {
            sum.moveOn(world_, (period - 1) / 2.0 * frameDuration);
        }
        at->second = errorOf(sample_, forcesOn(sample_, moved, addPairs), right_);
    }
    return at->second;
}

} // namespace trembler::budget
