// Fields through a visitor without knowledge of the property's type: every kind, in order, by reference.
#include "runtime/property/field_visitor.hpp"
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace trembler {
namespace field_visitor_test {
namespace {

using namespace sample;

// Prints the visited fields.
class Scribe : public FieldVisitor {
public:
    void boolean(FieldInfo const& i, bool& v) override { out << i.key << "=" << (v ? "yes" : "no") << ";"; }
    void integer(FieldInfo const& i, std::int32_t& v) override { out << i.key << "=" << v << "i;"; }
    void number(FieldInfo const& i, double& v) override { out << i.key << "=" << v << i.unit << ";"; }
    void vector(FieldInfo const& i, Vec2& v) override { out << i.key << "=(" << v.x << "," << v.y << ");"; }
    void text(FieldInfo const& i, std::string& v) override { out << i.key << "='" << v << "';"; }
    void object(FieldInfo const& i, ObjectId& v) override { out << i.key << "=#" << v.index << ";"; }
    void choice(FieldInfo const& i, ChoiceField f) override {
        out << i.key << "=" << f.names[static_cast<std::size_t>(f.index)] << ";";
    }
    void list(FieldInfo const& i, ListField& f) override {
        out << i.key << (f.elementsHaveFields() ? "{" : "[");
        for (std::size_t n = 0; n < f.size(); ++n) {
            f.visitElement(n, *this);
        }
        out << (f.elementsHaveFields() ? "}" : "]");
    }
    std::ostringstream out;
};

// Changes every visited field.
class Changer final : public FieldVisitor {
public:
    void boolean(FieldInfo const&, bool& v) override { v = !v; }
    void integer(FieldInfo const&, std::int32_t& v) override { v += 1; }
    void number(FieldInfo const&, double& v) override { v += 0.5; }
    void vector(FieldInfo const&, Vec2& v) override { v += Vec2{1, -1}; }
    void text(FieldInfo const&, std::string& v) override { v += "!"; }
    void object(FieldInfo const&, ObjectId& v) override { v = {7, 0}; }
    void choice(FieldInfo const&, ChoiceField f) override { f.index = 2; }
    void list(FieldInfo const&, ListField& f) override {
        f.resize(f.size() + 1);
        for (std::size_t n = 0; n < f.size(); ++n) {
            f.visitElement(n, *this);
        }
    }
};

Everything full() {
    Everything e;
    e.flag = true;
    e.count = 3;
    e.ratio = 0.25;
    e.point = {1, 2};
    e.label = "bell";
    e.other = {5, 0};
    e.mood = Mood::cross;
    e.numbers = {1, 2};
    e.words = {"a", ""};
    e.parts = {{2, Mood::glad}};
    return e;
}

TEST(FieldVisitor, SeesEveryKindOfFieldInTheOrderOfTheDescription) {
    Everything e = full();
    Scribe scribe;
    visitFields(e, scribe);
    EXPECT_EQ(scribe.out.str(), "flag=yes;count=3i;ratio=0.25;point=(1,2);label='bell';other=#5;mood=cross;"
                                "numbers[value=1s;value=2s;]words[value='a';value='';]"
                                "parts{size=2m;mood=glad;}");
}

TEST(FieldVisitor, ChangesThePropertyItself) {
    Everything e = full();
    Changer changer;
    visitFields(e, changer);
    Scribe scribe;
    visitFields(e, scribe);
    EXPECT_EQ(scribe.out.str(),
              "flag=no;count=4i;ratio=0.75;point=(2,1);label='bell!';other=#7;mood=glad;"
              "numbers[value=1.5s;value=2.5s;value=0.5s;]words[value='a!';value='!';value='!';]"
              "parts{size=2.5m;mood=glad;size=1.5m;mood=glad;}");
}

TEST(FieldVisitor, PassesRangesAlsoForTheElementsOfLists) {
    class Ranges final : public Scribe {
    public:
        void number(FieldInfo const& i, double&) override { out << i.minimum << ".." << i.maximum << ";"; }
    } ranges;
    Everything e = full();
    e.ratio = 0;
    visitFields(e, ranges);
    EXPECT_NE(ranges.out.str().find("numbers[-5..5;-5..5;]"), std::string::npos) << ranges.out.str();
    EXPECT_NE(ranges.out.str().find("parts{0..9;"), std::string::npos) << ranges.out.str();
}

// A marker has no fields, and data that only components read need not be described. Data that a level file
// can state must be: tests/compile_fail/object_property_without_fields.cpp.
struct Marker {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Marker", "marker", "Is there, or is not."};
};
struct Unstated {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Unstated", "unstated", "Only components know it.",
                                       PropertyPlace::hidden};
    double number = 0;
};
struct Statable {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Statable", "statable", "Levels may state it."};
    double number = 0;
};
static_assert(MayLackFields<Marker> && MayLackFields<Unstated> && MayLackFields<Kept>);
static_assert(!MayLackFields<Statable> && !MayLackFields<Everything>);
static_assert(Described<Everything> && !Described<Marker> && !Described<Kept>);

TEST(FieldVisitor, VisitsNothingWithoutADescription) {
    Scribe scribe;
    Column<Marker> markers;
    markers.set({0, 0}, {});
    markers.visitCopy({0, 0}, scribe);
    Column<Unstated> unstated;
    unstated.set({0, 0}, {3});
    unstated.visit({0, 0}, scribe);
    Slot<Kept> const slot;
    slot.visitCopy(scribe);
    EXPECT_EQ(scribe.out.str(), "");
}

TEST(FieldVisitor, VisitingAColumnMarksItAsChangedAndACopyDoesNot) {
    Column<Everything> column;
    column.set({0, 0}, full());
    std::uint64_t const version = column.version();
    Changer changer;
    column.visitCopy({0, 0}, changer);
    EXPECT_EQ(column.version(), version);
    EXPECT_EQ((column[ObjectId{0, 0}].count), 3);
    column.visit({0, 0}, changer);
    EXPECT_GT(column.version(), version);
    EXPECT_EQ((column[ObjectId{0, 0}].count), 4);
}

} // namespace
} // namespace field_visitor_test
} // namespace trembler
