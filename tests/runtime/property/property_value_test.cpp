// Values outside columns, and the slots of properties without objects.
#include "runtime/property/property_value.hpp"
#include "runtime/property/slot.hpp"
#include "runtime/world/store.hpp"
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace {

using namespace sample;

TEST(PropertyValue, ClonesDeeplyAndAssigns) {
    Everything original;
    original.words = {"one"};
    ValueOf<Everything> value(original);
    std::unique_ptr<PropertyValue> const clone = value.clone();
    value.value.words[0] = "two";
    EXPECT_EQ(&clone->info(), &propertyInfo<Everything>());
    Column<Everything> column;
    clone->assignTo(column, {1, 0});
    value.assignTo(column, {2, 0});
    EXPECT_EQ((column[ObjectId{1, 0}].words[0]), "one");
    EXPECT_EQ((column[ObjectId{2, 0}].words[0]), "two");
    clone->assignTo(column, {2, 0});
    EXPECT_EQ((column[ObjectId{2, 0}].words[0]), "one") << "assigning replaces";
    EXPECT_EQ(column.size(), 2U);
}

TEST(PropertyValue, IsMadeWithTheInitialValuesOfItsType) {
    std::unique_ptr<PropertyValue> const value = propertyInfo<Everything>().makeValue();
    Column<Everything> column;
    value->assignTo(column, {0, 0});
    EXPECT_EQ((column[ObjectId{0, 0}].mood), Mood::calm);
}

TEST(PropertyInfo, MakesAColumnOrASlotByItsKind) {
    EXPECT_NE(propertyInfo<Place>().makeColumn, nullptr);
    EXPECT_EQ(propertyInfo<Place>().makeSlot, nullptr);
    EXPECT_EQ(propertyInfo<Kept>().makeColumn, nullptr);
    EXPECT_EQ(propertyInfo<Kept>().makeValue, nullptr);
    ASSERT_NE(propertyInfo<Kept>().makeSlot, nullptr);
    EXPECT_EQ(&propertyInfo<Kept>().makeSlot()->info(), &propertyInfo<Kept>());
}

TEST(Slot, ResetsToTheInitialValueAndChangesItsVersion) {
    Slot<Kept> slot;
    slot.value().number = 8;
    std::uint64_t const version = slot.version();
    slot.reset();
    EXPECT_EQ(slot.value().number, 3);
    EXPECT_GT(slot.version(), version);
}

TEST(Store, CopiesPropertiesFromPrototypes) {
    Store store;
    Prototype bar;
    bar.name = "bar";
    bar.values.push_back(std::make_unique<ValueOf<Place>>(Place{{1, 2}}));
    bar.values.push_back(std::make_unique<ValueOf<Speed>>());
    std::uint32_t const number = store.prototypes().add(std::move(bar));
    EXPECT_EQ(store.prototypes().numberOf("bar"), number);
    EXPECT_EQ(store.prototypes().numberOf("ball"), PrototypeLibrary::unknown);
    EXPECT_EQ(store.prototypes().find(PrototypeLibrary::unknown), nullptr);
    ObjectId const id = store.create("a bar");
    store.furnish(id, *store.prototypes().find(number));
    EXPECT_EQ(store.column<Place>()[id].value, (Vec2{1, 2}));
    EXPECT_TRUE(store.column<Speed>().has(id));

    Prototype other;
    other.name = "bar"; // registered again: keeps its number
    EXPECT_EQ(store.prototypes().add(std::move(other)), number);
    EXPECT_TRUE(store.prototypes().find(number)->values.empty());
}

TEST(Store, KeepsNamesUniqueAndFindsThem) {
    Store store;
    ObjectId const bell = store.create("bell");
    EXPECT_THROW(store.create("bell"), std::invalid_argument);
    EXPECT_THROW(store.create(""), std::invalid_argument);
    EXPECT_EQ(store.objects().size(), 1U) << "a refused object is not created";
    EXPECT_EQ(store.find("bell"), bell);
    EXPECT_EQ(store.nameOf(bell), "bell");
    store.destroy({bell, bell, ObjectId{77, 0}});
    EXPECT_FALSE(store.find("bell").valid());
    EXPECT_EQ(store.nameOf(bell), "(gone)");
    EXPECT_NE(store.create("bell"), bell);
}

TEST(Store, DestroysObjectsWithAllTheirProperties) {
    Store store;
    std::vector<ObjectId> ids;
    for (int i = 0; i < 6; ++i) {
        ids.push_back(store.create(std::to_string(i)));
        store.column<Place>().set(ids.back(), {{1.0 * i, 0}});
        if (i % 2 == 0) {
            store.column<Speed>().set(ids.back(), {{1.0 * i, 0}});
        }
    }
    std::uint64_t const structure = store.structureVersion();
    store.destroy({ids[4], ids[1], ids[4]}); // in any order
    EXPECT_GT(store.structureVersion(), structure);
    EXPECT_EQ(store.objects().size(), 4U);
    EXPECT_EQ(store.column<Place>().size(), 4U);
    EXPECT_EQ(store.column<Speed>().size(), 2U);
    EXPECT_EQ(store.column<Place>()[ids[5]].value.x, 5);
    EXPECT_FALSE(store.column<Place>().has(ids[1]));
}

struct AlsoPlace {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Also place", "place", "Another property of that key."};
};

TEST(Store, RefusesTwoPropertiesOfOneKey) {
    Store store;
    static_cast<void>(store.column<Place>());
    EXPECT_THROW(static_cast<void>(store.column<AlsoPlace>()), std::logic_error);
}

TEST(Store, MakesColumnsOnlyForWriting) {
    Store const store;
    EXPECT_EQ(store.findColumn<Place>(), nullptr);
    EXPECT_EQ(store.findSlot<Kept>(), nullptr);
}

} // namespace
} // namespace trembler
