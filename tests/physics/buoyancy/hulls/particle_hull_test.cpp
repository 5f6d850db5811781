// Particles approximate the body that they are made from, better with their number.
#include "physics/buoyancy/hulls/exact_hull.hpp"
#include "physics/buoyancy/hulls/particle_hull.hpp"
#include "physics/dynamics/properties/shapes/mass_properties.hpp"
#include "tests/physics/buoyancy/generators.hpp"

#include <gtest/gtest.h>

namespace trembler::test {
namespace {

TEST(ParticleHull, HasTheAreaAndTheCentroidOfTheShape) {
    EXPECT_TRUE(rc::check([] {
        Shape shape{{*piece()}};
        if (*rc::gen::arbitrary<bool>()) {
            shape.pieces.push_back(*piece());
        }
        int const count = *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(4, 257));
        ParticleHull const hull(shape, count);
        double area = 0;
        double reach = 0;
        for (ParticleHull::Particle const& particle : hull.particles()) {
            area += pi * particle.radius * particle.radius;
            reach = std::max(reach, length(particle.at) + particle.radius);
        }
        MassProperties const expected = massPropertiesOf(shape);
        RC_ASSERT(std::abs(area - expected.area) < 1e-9);
        RC_ASSERT(reach <= hull.radius() + 1e-12);
        RC_ASSERT(std::abs(static_cast<int>(hull.particles().size()) - count) <= 6);
        // Completely immersed, by a side that meets its circle but cuts off nothing.
        Side const far{{0, 1}, hull.radius()};
        Displacement const whole = hull.displaced(std::span(&far, 1), {0, 1});
        RC_ASSERT(std::abs(whole.wet.area - expected.area) < 1e-9);
        // The numbers of particles of a compound's pieces are rounded; within a piece all have equal areas.
        RC_ASSERT(length(whole.wet.centroid() - expected.centre) < 1e-9);
    }));
}

TEST(ParticleHull, IsReproducible) {
    Shape const shape{{boxPiece(0.7, 0.3), circlePiece(0.2, {0.4, 0})}};
    ParticleHull const a(shape, 100);
    ParticleHull const b(shape, 100);
    ASSERT_EQ(a.particles().size(), b.particles().size());
    for (std::size_t i = 0; i < a.particles().size(); ++i) {
        EXPECT_EQ(a.particles()[i].at, b.particles()[i].at);
    }
}

TEST(ParticleHull, ASymmetricShapeHasItsCentreInTheMiddle) {
    for (ShapePiece const& piece : {boxPiece(0.8, 0.3), circlePiece(0.4), capsulePiece(0.9, 0.15)}) {
        ParticleHull const hull(Shape{{piece}}, 52);
        for (double const level : {-0.1, -0.02, 0.0, 0.07}) {
            Side const surface{{0, 1}, level};
            Displacement const found = hull.displaced(std::span(&surface, 1), {0, 1});
            EXPECT_NEAR(found.wet.centroid().x, 0, 1e-12);
            EXPECT_NEAR(found.waterline.first, 0, 1e-12);
        }
    }
}

// The greatest error of the area (as a share of the whole) and of the centre's place (of the reach) over many
// surfaces and shapes.
std::pair<double, double> errors(int count) {
    std::pair<double, double> worst;
    std::vector<ShapePiece> const shapes{boxPiece(0.8, 0.3), circlePiece(0.4), capsulePiece(0.9, 0.15),
                                         polygonPiece({{-0.4, -0.2}, {0.5, -0.3}, {0.3, 0.4}, {-0.2, 0.35}}),
                                         boxPiece(0.2, 0.6, {0.1, 0.1}, 0.4)};
    for (ShapePiece const& shape : shapes) {
        ExactHull const exact(Shape{{shape}});
        ParticleHull const hull(Shape{{shape}}, count);
        for (int i = 0; i < 24; ++i) {
            for (double const level : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
                Vec2 const normal = rotated({0, 1}, i * pi / 12);
                Side const surface{normal, dot(normal, exact.whole().centroid()) + level * 0.3};
                Displacement const a = exact.displaced(std::span(&surface, 1), normal);
                Displacement const b = hull.displaced(std::span(&surface, 1), normal);
                double const whole = exact.whole().area;
                worst.first = std::max(worst.first, std::abs(a.wet.area - b.wet.area) / whole);
                // The moment, not the centroid itself, which is inexact for tiny areas.
                worst.second =
                    std::max(worst.second, length(a.wet.first - b.wet.first) / (whole * exact.radius()));
            }
        }
    }
    return worst;
}

TEST(ParticleHull, ErrorsDecreaseWithMoreParticles) {
    auto const few = errors(16);
    auto const some = errors(64);
    auto const many = errors(256);
    EXPECT_LT(few.first, 0.12);
    EXPECT_LT(some.first, 0.08);
    EXPECT_LT(many.first, 0.02);
    EXPECT_LT(many.first, some.first);
    EXPECT_LT(some.first, few.first);
    EXPECT_LT(many.second, 0.02);
}

TEST(ParticleHull, ASingleSurfaceCutsParticlesAsItCutsDiscs) {
    // Compared with a body that consists of those discs.
    ParticleHull const hull(Shape{{boxPiece(0.5, 0.3)}}, 16);
    Shape discs;
    for (ParticleHull::Particle const& particle : hull.particles()) {
        discs.pieces.push_back(circlePiece(particle.radius, particle.at));
    }
    ExactHull const exact(discs);
    for (double const angle : {0.0, 0.7, 2.0}) {
        Side const surface{rotated({0, 1}, angle), 0.03};
        Displacement const a = hull.displaced(std::span(&surface, 1), {0, 1});
        Displacement const b = exact.displaced(std::span(&surface, 1), {0, 1});
        EXPECT_NEAR(a.wet.area, b.wet.area, 1e-12);
        EXPECT_NEAR(a.wet.xx, b.wet.xx, 1e-12);
        EXPECT_NEAR(a.waterline.length, b.waterline.length, 1e-12);
        EXPECT_NEAR(a.waterline.second, b.waterline.second, 1e-12);
    }
}

} // namespace
} // namespace trembler::test
