// The forms of the entries of recorded solutions, made from the schema.
#include "puzzle/data/published_schema.hpp"
#include "puzzle/edit/inspect/solution_forms.hpp"
#include "tests/levels/schema_validator.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler::edit {
namespace {

Json const& schema() {
    static Json const published = publishedSchema();
    return published;
}
EntryNames const names{{"steel ball", "plank"}, {"left", "right", "steel ball 1"}};

/// Whether the schema of level files allows a level with this entry of a solution.
std::string faultsOf(std::string const& list, Json const& entry) {
    static nlohmann::json const published = nlohmann::json::parse(schema().dump());
    Json const level{{"version", 2},
                     {"title", "x"},
                     {"solutions", Json::array({Json{{"name", "a"}, {list, Json::array({entry})}}})}};
    std::string all;
    for (std::string const& problem : validate(published, nlohmann::json::parse(level.dump()))) {
        all += problem + "\n";
    }
    return all;
}

EntryList const& listOf(std::vector<EntryList> const& lists, std::string const& key) {
    return *std::find_if(lists.begin(), lists.end(), [&](EntryList const& list) { return list.key == key; });
}

/// Another value that the field allows.
Json another(InspectedField const& field) {
    switch (field.type) {
    case FieldType::boolean:
        return field.value != true;
    case FieldType::vector:
        return Json::array({1.5, -2});
    case FieldType::integer:
        return field.value == static_cast<int>(field.maximum) ? static_cast<int>(field.minimum)
                                                              : static_cast<int>(field.maximum);
    case FieldType::number:
        return field.maximum;
    default:
        for (std::string const& choice : field.choices) {
            if (!choice.empty() && field.value != choice) {
                return choice;
            }
        }
        return Json();
    }
}

TEST(SolutionForms, TellTheKindsOfEntriesApart) {
    auto const lists = solutionLists(schema());
    ASSERT_EQ(lists.size(), 4U);
    EXPECT_EQ(listOf(lists, "placements").forms.size(), 1U);
    std::vector<std::string> inputs;
    for (EntryForm const& form : listOf(lists, "inputs").forms) {
        inputs.push_back(form.key);
    }
    EXPECT_EQ(inputs, (std::vector<std::string>{"grab", "move", "release", "cut", "remove"}));
    EXPECT_EQ(listOf(lists, "inputs").formOf(Json{{"frame", 3}, {"cut", {"a", "b"}}})->key, "cut");
    EXPECT_EQ(listOf(lists, "inputs").formOf(Json{{"frame", 3}}), nullptr);
}

// Every member that the schema has can be set, changed and, unless it is required, taken away again; with any
// of it the entry is what the schema allows.
TEST(SolutionForms, SetEveryMemberThatFilesMayState) {
    std::size_t fields = 0;
    for (EntryList const& list : solutionLists(schema())) {
        for (EntryForm const& form : list.forms) {
            Json const made = newEntry(form, names, {1, 2});
            EXPECT_EQ(faultsOf(list.key, made), "") << list.key << " " << made;
            EXPECT_EQ(list.formOf(made), &form);
            for (InspectedField const& field : fieldsOfEntry(form, made, names)) {
                ++fields;
                Json const value = another(field);
                ASSERT_FALSE(value.is_null()) << list.key << field.place;
                Json const changed = entryWith(made, field, value);
                EXPECT_EQ(faultsOf(list.key, changed), "") << list.key << " " << changed;
                EXPECT_EQ(changed.at(Json::json_pointer(field.place)), value);
                EXPECT_NE(changed, made);
                if (!field.required && !field.stated) {
                    EXPECT_EQ(entryWith(changed, field, Json()), made) << list.key << field.place;
                }
            }
        }
    }
    EXPECT_GT(fields, 40U);
}

} // namespace
} // namespace trembler::edit
