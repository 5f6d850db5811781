// The schedule compared with an independent implementation of the three conditions of 5.7.1 with plain sets,
// and with the apportionment of 6.13 as printed in the thesis.
#include "runtime/placement.hpp"
#include "runtime/population/population_resolver.hpp"
#include "runtime/schedule/schedule.hpp"
#include "runtime/world/registry.hpp"
#include "tests/runtime/schedule/apportionment.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <set>
#include <string>

namespace trembler {
namespace {

using namespace apportionment;

std::vector<PropertyInfo const*> const& alphabet() {
    static std::vector<PropertyInfo const*> const all = {
        &propertyInfo<Position>(),        &propertyInfo<Rotation>(), &propertyInfo<Velocity>(),
        &propertyInfo<AngularVelocity>(), &propertyInfo<Shape>(),    &propertyInfo<Mass>(),
        &propertyInfo<Density>(),         &propertyInfo<Liquid>()};
    return all;
}

// A resolver whose sets are given as bits over the alphabet.
ComponentInfo infoOf(unsigned reads, unsigned writes) {
    ComponentInfo info{.type = typeid(int), .kind = ComponentKind::resolver, .text = {}};
    for (std::size_t i = 0; i < alphabet().size(); ++i) {
        if ((reads >> i) & 1U) {
            info.reads.push_back(alphabet()[i]);
        }
        if ((writes >> i) & 1U) {
            info.writes.push_back(alphabet()[i]);
        }
    }
    return info;
}

TEST(Schedule, RunsResolversTogetherExactlyIfTheThreeConditionsHold) {
    EXPECT_TRUE(rc::check([](std::uint8_t r1, std::uint8_t w1, std::uint8_t r2, std::uint8_t w2) {
        bool const allowed = (w1 & w2) == 0 && (w1 & r2) == 0 && (w2 & r1) == 0;
        RC_ASSERT(mayRunTogether(infoOf(r1, w1), infoOf(r2, w2)) == allowed);
        RC_ASSERT(mayRunTogether(infoOf(r2, w2), infoOf(r1, w1)) == allowed);
    }));
}

TEST(Schedule, NamesEveryConflictWithItsKindAndProperty) {
    // A reads Position, writes Rotation and Velocity; B reads Rotation, writes Position and Velocity.
    auto const found = conflicts(infoOf(0b001, 0b110), infoOf(0b010, 0b101));
    std::set<std::pair<Conflict::Kind, PropertyInfo const*>> kinds;
    for (Conflict const& c : found) {
        kinds.emplace(c.kind, c.property);
    }
    EXPECT_EQ(found.size(), 3U);
    EXPECT_TRUE(kinds.contains({Conflict::Kind::bothWrite, &propertyInfo<Velocity>()}));
    EXPECT_TRUE(kinds.contains({Conflict::Kind::firstWritesRead, &propertyInfo<Rotation>()}));
    EXPECT_TRUE(kinds.contains({Conflict::Kind::secondWritesRead, &propertyInfo<Position>()}));
}

TEST(Schedule, ReadingTheSamePropertyIsNoConflict) {
    EXPECT_TRUE(conflicts(infoOf(0xff, 0), infoOf(0xff, 0)).empty());
}

TEST(Schedule, DerivesAnEdgeForEveryConflictInRegistrationOrderAndNoOther) {
    EXPECT_TRUE(rc::check([](std::vector<std::pair<std::uint8_t, std::uint8_t>> const& sets) {
        std::vector<ComponentInfo> infos;
        for (auto const& [reads, writes] : sets) {
            infos.push_back(infoOf(reads, writes));
        }
        std::vector<ComponentInfo const*> pointers;
        for (ComponentInfo const& info : infos) {
            pointers.push_back(&info);
        }
        auto const derived = deriveEdges(pointers);
        std::set<std::pair<std::size_t, std::size_t>> const edges(derived.begin(), derived.end());
        RC_ASSERT(edges.size() == derived.size());
        for (std::size_t i = 0; i < sets.size(); ++i) {
            for (std::size_t j = 0; j < sets.size(); ++j) {
                auto const [r1, w1] = sets[i];
                auto const [r2, w2] = sets[j];
                bool const clash = ((w1 & w2) | (w1 & r2) | (w2 & r1)) != 0;
                RC_ASSERT(edges.contains({i, j}) == (i < j && clash));
            }
        }
    }));
}

TEST(Schedule, AWriterOfEverythingRunsBesideNoComponentThatTouchesObjects) {
    ComponentInfo const& population = PopulationResolver::describeSelf();
    EXPECT_FALSE(mayRunTogether(population, infoOf(1, 0)));
    EXPECT_FALSE(mayRunTogether(infoOf(0, 1), population));
    EXPECT_TRUE(mayRunTogether(population, infoOf(0, 0)));
}

// 6.13.5: "The Electricity Resolver and Magnetics Resolver are independent, both from one another and the
// other resolvers ... The Dynamics Resolver and Buoyancy Resolver cannot be run in parallel".
TEST(Schedule, OfTheBetterApportionmentIsTheThesiss) {
    ComponentInfo const& dynamics = Dynamics::describeSelf();
    ComponentInfo const& electricity = Electricity::describeSelf();
    ComponentInfo const& magnetics = Magnetics::describeSelf();
    ComponentInfo const& buoyancy = Buoyancy::describeSelf();
    EXPECT_TRUE(mayRunTogether(electricity, magnetics));
    EXPECT_TRUE(mayRunTogether(electricity, dynamics));
    EXPECT_TRUE(mayRunTogether(magnetics, dynamics));
    EXPECT_TRUE(mayRunTogether(electricity, buoyancy));
    EXPECT_TRUE(mayRunTogether(magnetics, buoyancy));
    EXPECT_FALSE(mayRunTogether(dynamics, buoyancy));

    std::vector<ComponentInfo const*> const inOrder = {&dynamics, &electricity, &magnetics, &buoyancy};
    EXPECT_EQ(deriveEdges(inOrder), (std::vector<std::pair<std::size_t, std::size_t>>{{0, 3}}));

    // Equation 6.2 also lists Shape, which both only read; a conflict needs a property that Dynamics writes.
    std::set<PropertyInfo const*> why;
    for (Conflict const& c : conflicts(dynamics, buoyancy)) {
        EXPECT_EQ(c.kind, Conflict::Kind::firstWritesRead);
        why.insert(c.property);
    }
    EXPECT_EQ(why, (std::set<PropertyInfo const*>{&propertyInfo<Position>(), &propertyInfo<Rotation>()}));
}

TEST(Schedule, OfTheBetterApportionmentPassesTheRegistrysRules) {
    Registry registry;
    registerApportionment(registry);
    EXPECT_NO_THROW(registry.check());
}

} // namespace
} // namespace trembler
