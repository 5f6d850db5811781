// The moment of inertia that a motor feels, against the formulas of simple bodies.
#include "physics/motor/rotor.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace trembler {
namespace rotor_test {
namespace {

constexpr ObjectId rotor{3, 0};
constexpr double mass = 2.5; // kg

/// The columns of one object.
struct Columns {
    Column<Mass> masses;
    Column<Shape> shapes;
    Column<Fixed> fixed;
    [[nodiscard]] double inertia(ObjectId id = rotor) const { return inertiaOf(id, masses, shapes, fixed); }
};

double inertiaWith(std::vector<ShapePiece> pieces) {
    Columns columns;
    columns.masses.set(rotor, {mass});
    columns.shapes.set(rotor, {std::move(pieces)});
    return columns.inertia();
}

TEST(InertiaOf, AgreesWithTheFormulasOfSimpleBodies) {
    EXPECT_NEAR(inertiaWith({circlePiece(0.4)}), mass * 0.4 * 0.4 / 2, 1e-12);
    EXPECT_NEAR(inertiaWith({boxPiece(0.6, 0.8)}), mass * (0.36 + 0.64) / 12, 1e-12);
    // A regular polygon of n corners at the distance R: m R² (2 + cos(2π/n)) / 6.
    for (int const n : {3, 4, 5, 6, 8}) {
        std::vector<Vec2> corners;
        for (int i = 0; i < n; ++i) {
            corners.push_back({0.5 * std::cos(2 * pi * i / n), 0.5 * std::sin(2 * pi * i / n)});
        }
        EXPECT_NEAR(inertiaWith({polygonPiece(corners)}), mass * 0.25 * (2 + std::cos(2 * pi / n)) / 6, 1e-12)
            << n;
    }
    // Two equal discs, by Steiner's theorem.
    EXPECT_NEAR(inertiaWith({circlePiece(0.2, {-1, 0}), circlePiece(0.2, {1, 0})}),
                mass * (0.2 * 0.2 / 2 + 1), 1e-12);
    // Two half boxes are the whole one.
    EXPECT_NEAR(inertiaWith({boxPiece(0.3, 0.8, {-0.15, 0}), boxPiece(0.3, 0.8, {0.15, 0})}),
                inertiaWith({boxPiece(0.6, 0.8)}), 1e-12);
}

TEST(InertiaOf, IsAboutTheCentreOfMass) {
    EXPECT_TRUE(rc::check("a piece may be anywhere in the object's frame, at any angle", [] {
        auto const number = [](int low, int high) {
            return *rc::gen::resize(rc::kNominalSize, rc::gen::inRange(low, high)) / 100.0;
        };
        Vec2 const at{number(-500, 501), number(-500, 501)};
        double const angle = number(-314, 315);
        double const radius = number(5, 50);
        double const width = 2 * radius + number(1, 100);
        double const height = number(5, 100);
        for (auto const& [centred, moved] :
             {std::pair(circlePiece(radius), circlePiece(radius, at)),
              std::pair(boxPiece(width, height), boxPiece(width, height, at, angle)),
              std::pair(capsulePiece(width, radius), capsulePiece(width, radius, at, angle)),
              std::pair(polygonPiece({{0, 0}, {width, 0}, {0, height}}),
                        polygonPiece({{0, 0}, {width, 0}, {0, height}}, at, angle))}) {
            double const own = inertiaWith({centred});
            RC_ASSERT(own > 0);
            RC_ASSERT(std::abs(inertiaWith({moved}) - own) < 1e-9);
        }
    }));
}

TEST(InertiaOf, FixedObjectsAndTheWorldAreInfinitelyHeavy) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Columns columns;
    EXPECT_EQ(columns.inertia(ObjectId{}), infinite) << "the world";
    columns.fixed.set(rotor, {});
    EXPECT_EQ(columns.inertia(), infinite);
    columns.masses.set(rotor, {mass});
    columns.shapes.set(rotor, {{circlePiece(1)}});
    EXPECT_EQ(columns.inertia(), infinite) << "whatever it weighs";
    columns.fixed.remove(rotor);
    EXPECT_NEAR(columns.inertia(), mass / 2, 1e-12);
}

TEST(InertiaOf, AnObjectThatIsNoBodyHasNone) {
    Columns columns;
    EXPECT_EQ(columns.inertia(), 0);
    columns.masses.set(rotor, {mass});
    EXPECT_EQ(columns.inertia(), 0) << "without a shape";
    columns.shapes.set(rotor, {});
    EXPECT_EQ(columns.inertia(), 0) << "without pieces";
    columns.shapes.set(rotor, {{circlePiece(1)}});
    columns.masses.remove(rotor);
    EXPECT_EQ(columns.inertia(), 0) << "without a mass";
}

} // namespace
} // namespace rotor_test
} // namespace trembler
