#include "runtime/level/property/field_outline.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <cmath>

namespace trembler {
namespace field_outline_test {
namespace {

std::vector<std::string> keysIn(std::vector<FieldOutline> const& fields) {
    std::vector<std::string> keys;
    for (FieldOutline const& field : fields) {
        keys.emplace_back(field.info.key);
    }
    return keys;
}

TEST(FieldOutline, NamesEveryFieldWithItsTypeInOrder) {
    ValueOf<sample::Cake> cake;
    auto const fields = outlineOf(cake);
    EXPECT_EQ(keysIn(fields), (std::vector<std::string>{"flavour", "burnt", "note", "middle", "shift",
                                                        "eater", "toppings", "guests"}));
    std::vector<FieldType> const types{FieldType::choice, FieldType::boolean, FieldType::text,
                                       FieldType::vector, FieldType::number,  FieldType::object,
                                       FieldType::list,   FieldType::list};
    ASSERT_EQ(fields.size(), types.size());
    for (std::size_t i = 0; i < types.size(); ++i) {
        EXPECT_EQ(fields[i].type, types[i]) << fields[i].info.key;
    }
    EXPECT_FALSE(isBare(fields));
    // The fields depend on a choice.
    cake.value.flavour = Flavour::sour;
    EXPECT_EQ(outlineOf(cake)[4].info.key, "tilt_deg");
    EXPECT_TRUE(isAngle(outlineOf(cake)[4].info.unit));
}

TEST(FieldOutline, APropertyIsBareWithOneFieldThatIsItsValue) {
    ValueOf<sample::Weight> weight;
    EXPECT_TRUE(isBare(outlineOf(weight)));
    ValueOf<sample::Tag> tag;
    EXPECT_TRUE(outlineOf(tag).empty());
    EXPECT_FALSE(isBare(outlineOf(tag)));
    ValueOf<sample::Links> links; // one field, of another name
    EXPECT_EQ(outlineOf(links).size(), 1U);
    EXPECT_FALSE(isBare(outlineOf(links)));
}

TEST(FieldOutline, AnglesAreTheFieldsInRadians) {
    EXPECT_TRUE(isAngle("rad"));
    EXPECT_TRUE(isAngle("rad/s"));
    for (std::string_view const unit : {"", "m", "1/s", "N m/rad"}) {
        EXPECT_FALSE(isAngle(unit)) << unit;
    }
}

TEST(FieldOutline, AnglesAreWrittenAsTheFileStatedThem) {
    EXPECT_TRUE(rc::check("degrees survive the way to radians and back", [] {
        double const stated =
            *rc::gen::map(rc::gen::inRange(-3600000, 3600001), [](int i) { return i / 1e4; });
        RC_ASSERT(degrees(radians(stated)) == stated);
    }));
}

// Angles that were not read from a file, such as those of a turned body, keep their bits when written and
// read.
TEST(FieldOutline, RadiansKeepTheirBits) {
    EXPECT_TRUE(rc::check("what degrees() returns means the same angle", [] {
        double const stated =
            *rc::gen::map(rc::gen::inRange<std::int64_t>(-(std::int64_t{1} << 40U), std::int64_t{1} << 40U),
                          [](std::int64_t i) { return static_cast<double>(i) / 2e9; });
        double const angle = radians(stated);
        RC_ASSERT(radians(degrees(angle)) == angle);
        RC_ASSERT(std::abs(degrees(stated) * std::acos(-1.0) / 180 - stated) <= 1e-15 * std::abs(stated));
    }));
    EXPECT_EQ(degrees(std::acos(-1.0)), 180);
    EXPECT_EQ(degrees(0), 0);
    EXPECT_TRUE(std::isinf(degrees(HUGE_VAL)));
    EXPECT_TRUE(std::isnan(degrees(std::nan(""))));
}

} // namespace
} // namespace field_outline_test
} // namespace trembler
