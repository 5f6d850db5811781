// Every property that the published schema has is in the inspector, with every field.
#include "puzzle/data/published_schema.hpp"
#include "puzzle/edit/commands/connect.hpp"
#include "puzzle/edit/commands/properties.hpp"
#include "puzzle/edit/inspect/inspector.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

namespace trembler::edit {
namespace {

using Keys = std::set<std::string>;

/// The keys of members, of the schema itself and of its kinds; those of entries of lists under "/".
void keysOf(Json const& schema, std::string const& around, Keys& keys) {
    for (char const* const several : {"anyOf", "oneOf"}) {
        for (Json const& one : schema.value(several, Json::array())) {
            keysOf(one, around, keys);
        }
    }
    Json const members = schema.value("properties", Json::object());
    for (auto const& member : members.items()) {
        keys.insert(around + member.key());
        if (member.value().contains("items") && !member.value().contains("minItems")) {
            keysOf(member.value()["items"], around + member.key() + "/", keys);
        }
    }
    if (schema.contains("items") && !schema.contains("minItems")) {
        keysOf(schema["items"], around, keys);
    }
}

/// The same of shown fields, whose places have the numbers of entries.
void keysIn(std::vector<InspectedField> const& fields, Keys& keys) {
    for (InspectedField const& field : fields) {
        std::string key;
        std::string token;
        for (char const c : field.place + "/") {
            if (c != '/') {
                token += c;
            } else if (!token.empty()) {
                bool const number = token.find_first_not_of("0123456789") == std::string::npos;
                key += number ? "" : (key.empty() ? "" : "/") + token;
                token.clear();
            }
        }
        if (!key.empty()) {
            keys.insert(key);
        }
        keysIn(field.entries, keys);
    }
}

/// The fields of a property, with every choice of every field and with an entry in each list.
Keys shownKeys(std::function<std::vector<InspectedField>(LevelDocument const&)> const& fields,
               std::function<void(LevelDocument&, InspectedField const&, Json const&)> const& set,
               std::function<void(LevelDocument&, InspectedField const&)> const& addEntry,
               LevelDocument document) {
    Keys keys;
    keysIn(fields(document), keys);
    std::function<void(std::vector<InspectedField> const&)> const visit =
        [&](std::vector<InspectedField> const& all) {
            for (InspectedField const& field : all) {
                for (std::string const& choice :
                     field.type == FieldType::choice ? field.choices : std::vector<std::string>()) {
                    try {
                        set(document, field, choice);
                        keysIn(fields(document), keys);
                    } catch (CommandError const&) { // a choice that needs others
                    }
                }
                visit(field.entries);
            }
        };
    for (InspectedField const& field : fields(document)) {
        if (field.type == FieldType::list) {
            try {
                addEntry(document, field);
            } catch (CommandError const&) { // it has one already
            }
        }
    }
    keysIn(fields(document), keys);
    visit(fields(document));
    return keys;
}

void expectAll(Json const& schema, Keys const& shown, std::string const& property) {
    Keys wanted;
    keysOf(schema, "", wanted);
    for (std::string const& key : wanted) {
        EXPECT_TRUE(shown.contains(key)) << property << " has no field for \"" << key << "\"";
    }
}

TEST(SchemaProperties, AreAllInTheInspectorOfObjects) {
    Json const schema = publishedSchema();
    std::size_t properties = 0;
    for (auto const& [key, of] : schema["$defs"]["properties"]["properties"].items()) {
        if (key == "scripts" || key == "joint") {
            continue; // of mods, with widgets of their own; and another way to write an entry of "joints"
        }
        ++properties;
        LevelDocument document = smallDocument();
        auto const find = [property = key](LevelDocument const& shown) {
            for (InspectedProperty const& one : inspectObjects(editData(), shown.tree(), {"left"})) {
                if (one.key == property) {
                    return one.fields;
                }
            }
            return std::vector<InspectedField>();
        };
        if (find(document).empty()) {
            auto const addable = addableProperties(editData(), document.tree(), {"left"});
            EXPECT_TRUE(std::any_of(addable.begin(), addable.end(),
                                    [property = key](auto const& one) { return one.key == property; }) ||
                        document.tree()["objects"][1]["properties"].contains(key))
                << key << " cannot be added";
            EXPECT_EQ(refusalOf([&, property = key] {
                          document.run(addProperty(editData(), document.tree(), {"left"}, property));
                      }),
                      "")
                << key;
        }
        expectAll(
            of,
            shownKeys(
                find,
                [property = key](LevelDocument& changed, InspectedField const& field, Json const& value) {
                    changed.run(setField(editData(), changed.tree(), {"left"}, property, field.place, value));
                },
                [property = key](LevelDocument& changed, InspectedField const& field) {
                    changed.run(
                        addListEntry(editData(), changed.tree(), {"left"}, property, field.place, Json()));
                },
                document),
            key);
    }
    EXPECT_GT(properties, 25U);
}

TEST(SchemaProperties, AreAllInTheInspectorOfTheWorld) {
    Json const schema = publishedSchema();
    LevelDocument const document = smallDocument();
    auto const world = inspectWorld(editData(), document.tree());
    for (auto const& [key, of] : schema["properties"]["world"]["properties"].items()) {
        if (key == "bounds" || key == "detail") { // fields of the page, tested in the window
            continue;
        }
        auto const found = std::find_if(world.begin(), world.end(),
                                        [property = key](auto const& one) { return one.key == property; });
        ASSERT_NE(found, world.end()) << key;
        Keys shown;
        keysIn(found->fields, shown);
        expectAll(of, shown, key);
    }
}

TEST(SchemaProperties, AreAllInTheFormsOfJoints) {
    Json const schema = publishedSchema();
    Keys shown{"name"}; // a field of its own
    for (InspectedField const& field : inspectJoint(editData(), smallDocument().tree(), 0)) {
        for (std::string const& form : field.place == "/form" ? field.choices : std::vector<std::string>()) {
            LevelDocument document = smallDocument();
            EXPECT_EQ(refusalOf([&] {
                          document.run(setJointField(editData(), document.tree(), 0, "/form", form));
                      }),
                      "")
                << form;
            keysIn(inspectJoint(editData(), document.tree(), 0), shown);
        }
    }
    expectAll(schema["$defs"]["joint"], shown, "joint");
}

} // namespace
} // namespace trembler::edit
