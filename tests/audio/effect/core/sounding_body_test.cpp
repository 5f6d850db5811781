// The modes of bodies, and their excitation by impacts.
#include "audio/effect/core/contact_pulse.hpp"
#include "audio/effect/core/mode_shapes.hpp"
#include "audio/effect/core/sounding_body.hpp"
#include "audio/effect/properties/decibel.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace {

SoundingBody modelOf(ShapePiece const& piece, Material material, double mass, int modes = 8,
                     Acoustics const* acoustics = nullptr, bool fixed = false) {
    Shape const shape{{piece}};
    return SoundingBody({&shape, material, acoustics, mass, fixed}, modes);
}

TEST(SoundingBody, ALongBoxIsABarOfEulerAndBernoulli) {
    SoundingBody const bar = modelOf(boxPiece(1.0, 0.02), Material::steel, 15.7);
    double const lowest =
        1.0277 * 0.02 / 1.0 * std::sqrt(200e9 / 7850); // Fletcher and Rossing (2.63), 1.028 h c / L²
    ASSERT_GE(bar.modes().size(), 5U);
    EXPECT_NEAR(bar.modes()[0].frequency, lowest, 0.002 * lowest);
    double const ratios[] = {1, 2.7565, 5.4039, 8.9330, 13.3443};
    for (std::size_t i = 0; i < 5; ++i) {
        EXPECT_NEAR(bar.modes()[i].frequency / bar.modes()[0].frequency, ratios[i], 1e-3 * ratios[i]);
    }
}

TEST(SoundingBody, TurningTheBoxChangesNothing) {
    SoundingBody const lying = modelOf(boxPiece(1.0, 0.05), Material::steel, 10);
    SoundingBody const standing = modelOf(boxPiece(0.05, 1.0), Material::steel, 10);
    SoundingBody const slanting = modelOf(boxPiece(1.0, 0.05, {0.3, -0.2}, 0.7), Material::steel, 10);
    for (std::size_t i = 0; i < lying.modes().size(); ++i) {
        double const expected = std::abs(lying.mobility(lying.modes()[i], {0.3, 0.025}, {0, 1}));
        EXPECT_NEAR(std::abs(standing.mobility(standing.modes()[i], {-0.025, 0.3}, {1, 0})), expected, 1e-9);
        Vec2 const point = Vec2{0.3, -0.2} + rotated({0.3, 0.025}, 0.7);
        EXPECT_NEAR(std::abs(slanting.mobility(slanting.modes()[i], point, rotated({0, 1}, 0.7))), expected,
                    1e-9);
    }
}

TEST(SoundingBody, ABarStruckInItsNodeLacksThatMode) {
    SoundingBody const bar = modelOf(boxPiece(1.0, 0.02), Material::steel, 15.7);
    double const atNode = std::abs(bar.mobility(bar.modes()[0], {-0.5 + 0.2242, 0.01}, {0, -1}));
    double const atEnd = std::abs(bar.mobility(bar.modes()[0], {-0.5, 0.01}, {0, -1}));
    EXPECT_LT(atNode, 0.01 * atEnd);
    EXPECT_NEAR(atEnd, 2 / 15.7, 1e-9) << "twice its mean, over the mass";
}

TEST(SoundingBody, BiggerIsLowerAndMetalRingsLongest) {
    auto const lowest = [](double size, Material material) {
        return modelOf(boxPiece(size, size), material, 5).modes().at(0).frequency;
    };
    EXPECT_LT(lowest(1.0, Material::steel), lowest(0.5, Material::steel));
    // Two plates of the same proportions and half the size, thickness included: twice the frequency.
    EXPECT_NEAR(lowest(0.1, Material::steel), 2 * lowest(0.2, Material::steel),
                1e-6 * lowest(0.1, Material::steel));
    auto const decayPerCycle = [](Material material) {
        Mode const mode = modelOf(boxPiece(0.5, 0.3), material, 50).modes().at(0);
        return mode.decay / mode.frequency;
    };
    EXPECT_LT(decayPerCycle(Material::steel), decayPerCycle(Material::glass));
    EXPECT_LT(decayPerCycle(Material::glass), decayPerCycle(Material::wood));
    EXPECT_LT(decayPerCycle(Material::wood), decayPerCycle(Material::plastic));
    EXPECT_LT(decayPerCycle(Material::plastic), decayPerCycle(Material::rubber));
}

TEST(SoundingBody, FewerModesAreTheFirstOfMore) {
    EXPECT_TRUE(rc::check("the lowest modes are the same at every detail level", [] {
        auto const width = *rc::gen::inRange(5, 300) / 100.0;
        auto const height = *rc::gen::inRange(2, 300) / 100.0;
        auto const material = static_cast<Material>(*rc::gen::inRange(0, 11));
        SoundingBody const all = modelOf(boxPiece(width, height), material, 3, 32);
        RC_ASSERT(all.modes().size() <= 32U);
        for (int const count : {1, 4, 8, 16}) {
            SoundingBody const some = modelOf(boxPiece(width, height), material, 3, count);
            RC_ASSERT(some.modes().size() ==
                      std::min<std::size_t>(all.modes().size(), static_cast<std::size_t>(count)));
            for (std::size_t i = 0; i < some.modes().size(); ++i) {
                RC_ASSERT(some.modes()[i].frequency == all.modes()[i].frequency);
                RC_ASSERT(some.modes()[i].decay == all.modes()[i].decay);
            }
        }
        for (std::size_t i = 0; i < all.modes().size(); ++i) {
            RC_ASSERT(all.modes()[i].frequency >= lowestAudible);
            RC_ASSERT(all.modes()[i].frequency <= highestAudible);
            RC_ASSERT(all.modes()[i].decay > 0);
            RC_ASSERT(all.modes()[i].radiation > 0);
            if (i > 0) {
                RC_ASSERT(all.modes()[i].frequency >= all.modes()[i - 1].frequency);
            }
        }
    }));
}

TEST(SoundingBody, NeverRadiatesMoreEnergyThanItHas) {
    // Radiated power over stored energy, 2 p² 4π/(ρc) / (½ M v²), cannot exceed the rate at which the mode
    // loses energy.
    for (Material const material : {Material::steel, Material::wood, Material::glass, Material::rubber}) {
        double const mass = 2;
        SoundingBody const plate = modelOf(boxPiece(0.4, 0.4), material, mass);
        for (Mode const& mode : plate.modes()) {
            double const meanSquare = mode.radiation * mode.radiation / 2; // for 1 m/s
            double const power = 4 * pi * meanSquare / airImpedance;
            double const energy = mass / 2;
            EXPECT_LE(power / energy, 2 * mode.decay * (1 + 1e-9));
        }
    }
}

TEST(SoundingBody, AcousticsOverrideSizeAndMaterial) {
    Acoustics acoustics;
    acoustics.form = SoundingForm::bell;
    acoustics.frequency = 880;
    acoustics.ringing = 4;
    SoundingBody const bell = modelOf(boxPiece(0.3, 0.3), Material::gold, 5, 16, &acoustics);
    EXPECT_NEAR(bell.modes()[0].frequency, 440, 1e-6) << "the hum";
    EXPECT_NEAR(bell.modes()[1].frequency, 880, 1e-6) << "the prime";
    EXPECT_NEAR(bell.modes()[2].frequency, 1.2 * 880, 1e-6) << "the minor third";
    EXPECT_NEAR(bell.modes()[0].decay * 4, std::log(1000.0), 1e-9) << "60 dB in 4 s";
    double const rim = bell.mobility(bell.modes()[1], {0.1, -0.15}, {0, 1});
    double const crown = bell.mobility(bell.modes()[1], {0, 0.15}, {0, -1});
    EXPECT_GT(rim, 1.5 * crown);
    acoustics.partials = {1, 2, 3};
    SoundingBody const organ = modelOf(boxPiece(0.3, 0.3), Material::gold, 5, 16, &acoustics);
    ASSERT_EQ(organ.modes().size(), 3U);
    EXPECT_NEAR(organ.modes()[2].frequency, 2640, 1e-6);
}

TEST(SoundingBody, AFixedBodyVibratesOnlyAroundTheImpact) {
    SoundingBody const floor = modelOf(boxPiece(8, 0.3), Material::stone, 600, 8, nullptr, true);
    SoundingBody const slab = modelOf(boxPiece(8, 0.3), Material::stone, 600, 8);
    EXPECT_GT(floor.modes()[0].frequency, 100);
    EXPECT_NEAR(floor.mass(), 150, 1e-9);
    EXPECT_LT(slab.modes()[0].frequency, 100);
    EXPECT_GT(floor.modes()[0].decay, 40);
    EXPECT_EQ(floor.movedAir(), 0);
}

TEST(Impact, ContactTimeIsThatOfHertz) {
    // A ball on a half space: m a = -4/3 E* sqrt(R) d^(3/2), integrated in tiny steps.
    double const mass = 0.5;
    double const radius = 0.04;
    for (double const speed : {0.1, 1.0, 5.0}) {
        AcousticMaterial const& steel = acousticMaterial(Material::steel);
        AcousticMaterial const& glass = acousticMaterial(Material::glass);
        double const modulus = 1 / ((1 - steel.poissonRatio * steel.poissonRatio) / steel.youngsModulus +
                                    (1 - glass.poissonRatio * glass.poissonRatio) / glass.youngsModulus);
        double const stiffness = 4.0 / 3 * modulus * std::sqrt(radius);
        double depth = 0;
        double velocity = speed;
        double time = 0;
        double const step = 1e-9;
        while (depth >= 0) {
            velocity -= stiffness * depth * std::sqrt(depth) / mass * step;
            depth += velocity * step;
            time += step;
        }
        EXPECT_NEAR(contactTime(Material::steel, Material::glass, radius, 0, mass, speed), time,
                    0.005 * time);
    }
}

TEST(Impact, IsShorterAndBrighterForHarderAndFasterBodies) {
    double const gentle = contactTime(Material::steel, Material::stone, 0.1, 0, 1, 0.5);
    double const hard = contactTime(Material::steel, Material::stone, 0.1, 0, 1, 5);
    double const soft = contactTime(Material::rubber, Material::stone, 0.1, 0, 1, 5);
    EXPECT_LT(hard, gentle);
    EXPECT_GT(soft, 10 * hard);
    // The tilt between a low and a high mode.
    auto const tilt = [](double contact) { return spectrumOf(contact, 5000) / spectrumOf(contact, 500); };
    EXPECT_GT(tilt(hard), tilt(gentle));
    EXPECT_GT(tilt(hard), 10 * tilt(soft));
}

TEST(Impact, SpectrumFollowsTheSpectrumOfAHalfSine) {
    // |F(f)| / J of a half sine of duration T, by integration; at its maxima the envelope must meet it.
    double const contact = 0.002;
    auto const exact = [&](double f) {
        double re = 0;
        double im = 0;
        int const steps = 20000;
        for (int i = 0; i < steps; ++i) {
            double const t = (i + 0.5) * contact / steps;
            double const force = std::sin(pi * t / contact) * pi / (2 * contact);
            re += force * std::cos(2 * pi * f * t) * contact / steps;
            im += force * std::sin(2 * pi * f * t) * contact / steps;
        }
        return std::hypot(re, im);
    };
    EXPECT_NEAR(spectrumOf(contact, 1), exact(1), 0.01);
    for (int lobe = 2; lobe < 8; ++lobe) { // cos(π f T) is ±1
        double const f = lobe / contact;
        EXPECT_NEAR(spectrumOf(contact, f) / exact(f), 1, 0.1) << f;
    }
}

} // namespace
} // namespace trembler
