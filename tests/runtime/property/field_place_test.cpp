#include "runtime/property/field_place.hpp"

#include <gtest/gtest.h>

#include <array>
#include <string>

namespace trembler {
namespace field_place_test {

enum class Form : int { round, square };
struct Sample {
    Form form = Form::round;
    bool on = false;
    double size = 1;
    Vec2 at;
    std::string name;
    std::vector<double> list;
    std::int32_t count = 0;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "form", .unit = "", .meaning = ""}, self.form);
        visit(FieldInfo{.key = "on", .unit = "", .meaning = ""}, self.on);
        bool const round = self.form == Form::round;
        visit(FieldInfo{.key = round ? "radius" : "side", .unit = "m", .meaning = ""}, self.size);
        visit(FieldInfo{.key = "at", .unit = "m", .meaning = ""}, self.at);
        visit(FieldInfo{.key = "name", .unit = "", .meaning = ""}, self.name);
        visit(FieldInfo{.key = "list", .unit = "", .meaning = ""}, self.list);
        visit(FieldInfo{.key = "count", .unit = "", .meaning = ""}, self.count);
        double const twice = 2 * self.size;
        visit(FieldInfo{.key = "twice", .unit = "m", .meaning = ""}, twice);
    }
};

} // namespace field_place_test

template <>
inline constexpr std::array<std::string_view, 2> choiceNames<field_place_test::Form>{"round", "square"};

namespace field_place_test {
namespace {

FieldPlace placeOf(std::string_view key) {
    for (FieldPlace const& place : fieldPlaces<Sample>()) {
        if (place.info.key == key) {
            return place;
        }
    }
    ADD_FAILURE() << key;
    return {};
}

template <class T>
T const& valueAt(Sample const& sample, std::string_view key) {
    return *reinterpret_cast<T const*>(reinterpret_cast<char const*>(&sample) +
                                       placeOf(key).offset); // NOLINT
}

TEST(FieldPlaces, LieWhereTheFieldsAre) {
    Sample sample;
    sample.on = true;
    sample.size = 7;
    sample.at = {3, 4};
    sample.name = "x";
    sample.count = -5;
    EXPECT_TRUE(valueAt<bool>(sample, "on"));
    EXPECT_EQ(valueAt<double>(sample, "radius"), 7);
    EXPECT_EQ(valueAt<Vec2>(sample, "at").y, 4);
    EXPECT_EQ(valueAt<std::string>(sample, "name"), "x");
    EXPECT_EQ(valueAt<std::int32_t>(sample, "count"), -5);
    EXPECT_EQ(placeOf("list").kind, FieldKind::list);
    EXPECT_EQ(placeOf("form").choices.size(), 2U);
}

TEST(FieldPlaces, AreThoseOfEveryChoice) {
    EXPECT_EQ(placeOf("side").offset, placeOf("radius").offset);
}

TEST(FieldPlaces, AreNowhereForWhatIsComputed) {
    EXPECT_EQ(placeOf("twice").offset, FieldPlace::nowhere);
}

} // namespace
} // namespace field_place_test
} // namespace trembler
