// Any value of a property is bit for bit the same after writing it to a file and reading it back.
#include "runtime/level/property/field_outline.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/property/property_writer.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <bit>

namespace trembler {
namespace {

using sample::Cake;
using sample::Topping;
using sample::Weight;

/// Every field as text, numbers by their bits: equal texts, equal values.
class Dump final : public FieldVisitor {
public:
    std::string all;
    void boolean(FieldInfo const& info, bool& value) override { add(info, value ? "yes" : "no"); }
    void integer(FieldInfo const& info, std::int32_t& value) override { add(info, std::to_string(value)); }
    void number(FieldInfo const& info, double& value) override { add(info, bits(value)); }
    void vector(FieldInfo const& info, Vec2& value) override { add(info, bits(value.x) + bits(value.y)); }
    void text(FieldInfo const& info, std::string& value) override { add(info, value); }
    void object(FieldInfo const& info, ObjectId& value) override { add(info, std::to_string(value.index)); }
    void choice(FieldInfo const& info, ChoiceField field) override { add(info, std::to_string(field.index)); }
    void list(FieldInfo const& info, ListField& field) override {
        add(info, std::to_string(field.size()));
        for (std::size_t i = 0; i < field.size(); ++i) {
            field.visitElement(i, *this);
        }
    }

private:
    static std::string bits(double value) {
        return std::to_string(std::bit_cast<std::uint64_t>(value)) + ",";
    }
    void add(FieldInfo const& info, std::string const& value) {
        all += std::string(info.key) + "=" + value + ";";
    }
};

std::string dump(PropertyValue const& value) {
    Dump dump;
    value.clone()->visit(dump);
    return dump.all;
}

/// Writes, prints, parses and reads a value.
template <class P>
std::string throughFile(P const& value, NameTable& names) {
    std::string const text = writeProperty(ValueOf<P>(value), names).dump();
    auto const document = JsonDocument::parse(text, "f.json");
    Problems problems;
    auto const read =
        readProperty(propertyInfo<P>(), JsonNode(*document, document->root(), "", problems), &names);
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        return text + " -> " + error.what();
    }
    return dump(*read);
}

double anyNumber(double lowest, double highest) {
    double const share =
        *rc::gen::map(rc::gen::inRange<std::int64_t>(0, std::int64_t{1} << 53),
                      [](std::int64_t i) { return static_cast<double>(i) / 9007199254740992.0; });
    return *rc::gen::element(lowest + share * (highest - lowest),
                             std::round(lowest + share * (highest - lowest)), lowest, highest, -0.0, 5e-324);
}

/// An angle that a file can state.
double anyAngle(double lowest, double highest) {
    return radians(anyNumber(lowest, highest));
}

template <class T, class Make>
std::vector<T> some(Make const& make) {
    std::vector<T> list;
    for (int i = *rc::gen::inRange(0, 4); i > 0; --i) {
        list.push_back(make());
    }
    return list;
}

Flavour anyFlavour() {
    return *rc::gen::element(Flavour::sweet, Flavour::sour, Flavour::bitter);
}

TEST(PropertyRoundTrip, KeepsEveryBit) {
    EXPECT_TRUE(rc::check("what is written reads back as the same value", [] {
        NameTable names;
        auto const anybody = [&] {
            return names.refer(*rc::gen::element<std::string>("a", "b c", "\"d\"", "é"));
        };
        Cake cake;
        cake.flavour = anyFlavour();
        cake.burnt = *rc::gen::arbitrary<bool>();
        cake.note = *rc::gen::element<std::string>("plain", "", "two\nlines", "→");
        cake.middle = {anyNumber(-10, 10), anyNumber(-10, 10)};
        cake.tilt = cake.flavour == Flavour::sour ? anyAngle(-5000, 5000) : anyNumber(-100, 100);
        if (*rc::gen::arbitrary<bool>()) {
            cake.eater = anybody();
        }
        cake.guests = some<ObjectId>(anybody);
        cake.toppings = some<Topping>([] {
            Topping topping;
            topping.flavour = anyFlavour();
            topping.count = *rc::gen::inRange(0, 11);
            topping.turn = anyAngle(-500, 500);
            topping.spots = some<Vec2>([] { return Vec2{anyNumber(-5, 5), anyNumber(-5, 5)}; });
            return topping;
        });
        RC_ASSERT(throughFile(cake, names) == dump(ValueOf<Cake>(cake)));
        Weight const weight{std::max(5e-324, anyNumber(0, 100))};
        RC_ASSERT(throughFile(weight, names) == dump(ValueOf<Weight>(weight)));
    }));
}

TEST(PropertyWriter, LeavesOutInitialValues) {
    EXPECT_EQ(writeProperty(ValueOf<Cake>()).dump(), "true");
    EXPECT_EQ(writeProperty(ValueOf<sample::Tag>()).dump(), "true");
    EXPECT_EQ(writeProperty(ValueOf<Weight>()).dump(), "1");
    Cake cake;
    cake.flavour = Flavour::sour; // the key of the tilt changes with it, its initial value does not
    cake.toppings.resize(1);
    EXPECT_EQ(writeProperty(ValueOf<Cake>(cake)).dump(),
              R"({"flavour":"sour","toppings":[{"flavour":"sour"}]})");
    PropertySet set;
    set.set(Weight{2});
    set.takeAway(propertyInfo<sample::Tag>());
    EXPECT_EQ(writeProperties(set, PropertyPlace::properties).dump(), R"({"tag":false,"weight":2})");
}

} // namespace
} // namespace trembler
