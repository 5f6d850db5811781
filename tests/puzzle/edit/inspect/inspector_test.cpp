// The inspector's model.
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/inspect/inspector.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::edit {
namespace {

InspectedProperty const* propertyIn(std::vector<InspectedProperty> const& all, std::string const& key) {
    auto const found =
        std::find_if(all.begin(), all.end(), [&](InspectedProperty const& one) { return one.key == key; });
    return found == all.end() ? nullptr : &*found;
}

TEST(Inspector, ShowsOneObject) {
    LevelDocument const document = smallDocument();
    auto const all = inspectObjects(editData(), document.tree(), {"right"});
    auto const* const angle = propertyIn(all, "angle_deg");
    ASSERT_NE(angle, nullptr);
    EXPECT_EQ(angle->fields.front().value, 90);
    EXPECT_EQ(angle->fields.front().unit, "°");
    EXPECT_EQ(angle->origin, ValueOrigin::own);
    auto const* const shape = propertyIn(all, "shape");
    ASSERT_NE(shape, nullptr);
    ASSERT_EQ(shape->fields.front().entries.size(), 1U);
    auto const& piece = shape->fields.front().entries.front().entries;
    EXPECT_EQ(piece.front().choices.size(), 4U);
    EXPECT_EQ(piece.front().place, "/0/form");
    EXPECT_EQ(propertyIn(all, "name"), nullptr);
    EXPECT_EQ(propertyIn(all, "fixed"), nullptr);
}

TEST(Inspector, ShowsWhatIsMixedAndWhereItComesFrom) {
    LevelDocument document = smallDocument();
    auto all = inspectObjects(editData(), document.tree(), {"left", "right"});
    EXPECT_TRUE(propertyIn(all, "material")->fields.front().mixed);
    EXPECT_TRUE(propertyIn(all, "at")->fields.front().mixed);
    all = inspectObjects(editData(), document.tree(), {"ball"});
    EXPECT_EQ(propertyIn(all, "material")->origin, ValueOrigin::part);
    EXPECT_FALSE(propertyIn(all, "material")->canReset);
    document.run(setField(editData(), document.tree(), {"ball"}, "material", "", "steel"));
    all = inspectObjects(editData(), document.tree(), {"ball", "left"});
    EXPECT_EQ(propertyIn(all, "material")->origin, ValueOrigin::mixed);
    document.run(removeProperty(editData(), document.tree(), {"ball"}, "material"));
    all = inspectObjects(editData(), document.tree(), {"ball"});
    EXPECT_EQ(propertyIn(all, "material")->origin, ValueOrigin::removed);
    EXPECT_TRUE(propertyIn(all, "material")->canReset);
    EXPECT_TRUE(inspectObjects(editData(), document.tree(), {"none"}).empty());
}

TEST(Inspector, SetsWhatItShows) {
    LevelDocument document = smallDocument();
    for (auto const& property : inspectObjects(editData(), document.tree(), {"table", "left", "ball"})) {
        for (auto const& field : property.fields) {
            if (!field.value.is_null()) {
                EXPECT_EQ(refusalOf([&] {
                              document.run(setField(editData(), document.tree(), {"left"}, property.key,
                                                    field.place, field.value));
                          }),
                          "")
                    << property.key << field.place;
            }
        }
    }
}

TEST(Inspector, ListsWhatCanBeAddedTheWorldAndJoints) {
    LevelDocument const document = smallDocument();
    auto const addable = addableProperties(editData(), document.tree(), {"left"});
    EXPECT_TRUE(
        std::any_of(addable.begin(), addable.end(), [](auto const& one) { return one.key == "mass"; }));
    EXPECT_FALSE(
        std::any_of(addable.begin(), addable.end(), [](auto const& one) { return one.key == "shape"; }));
    auto const world = inspectWorld(editData(), document.tree());
    ASSERT_NE(propertyIn(world, "gravity"), nullptr);
    EXPECT_EQ(propertyIn(world, "gravity")->fields.front().value, Json::array({0, -9.81}));
    EXPECT_TRUE(propertyIn(world, "gravity")->canReset);
    auto const joint = inspectJoint(editData(), document.tree(), 1);
    ASSERT_FALSE(joint.empty());
    EXPECT_EQ(joint.front().value, "rope");
    EXPECT_TRUE(inspectJoint(editData(), document.tree(), 9).empty());
}

} // namespace
} // namespace trembler::edit
