// Part definitions: the values that their files may state, and folders of them.
#include "runtime/level/model/part_library.hpp"
#include "runtime/level/read/read_part.hpp"
#include "runtime/object/without.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

namespace trembler {
namespace part_library_test {
namespace {

using sample::Tag;
using sample::Weight;

class Parts : public ::testing::Test {
protected:
    void SetUp() override { sample::fill(registry); }
    PartDefinition read(std::string const& text) {
        return readPart(registry, JsonDocument::parse(text, "part.json"));
    }
    std::string problemsIn(std::string const& text) {
        try {
            static_cast<void>(read(text));
            return {};
        } catch (InputError const& error) {
            return error.what();
        }
    }
    Registry registry;
};

TEST_F(Parts, HaveANameTextsAndProperties) {
    PartDefinition const part =
        read(R"({"$schema": "x", "name": "steel bar", "title": "Bar", "text": "Heavy.",
        "properties": {"weight": 7, "tag": true}})");
    EXPECT_EQ(part.name, "steel bar");
    EXPECT_EQ(part.title, "Bar");
    EXPECT_EQ(part.text, "Heavy.");
    EXPECT_EQ(part.properties.find<Weight>()->value, 7);
    EXPECT_NE(part.properties.find<Tag>(), nullptr);
    PartDefinition const plain = read(R"({"name": "peg"})");
    EXPECT_EQ(plain.title, "peg") << "without a title it has its name";
    EXPECT_TRUE(plain.properties.empty());
}

TEST_F(Parts, ReportAllTheirErrors) {
    EXPECT_SAYS(problemsIn("[]"), "is a list of 0; expected a part");
    EXPECT_SAYS(problemsIn("{}"), "'name' is missing");
    EXPECT_SAYS(problemsIn(R"({"name": ""})"), "/name: is \"\"");
    EXPECT_SAYS(problemsIn(R"({"name": "a", "titel": "A"})"), "did you mean 'title'");
    EXPECT_SAYS(problemsIn(R"({"name": "a", "properties": {"weihgt": 1}})"), "did you mean 'weight'");
    EXPECT_SAYS(problemsIn(R"({"name": "a", "properties": {"climate": [1, 2]}})"), "climate");
    // A part does not belong to a level, so it cannot refer to objects.
    EXPECT_SAYS(problemsIn(R"({"name": "a", "properties": {"cake": {"eater": "b"}}})"),
                "/properties/cake/eater");
    std::string const several = problemsIn(R"({"name": 3, "text": 4, "properties": {"weight": 0}})");
    EXPECT_SAYS(several, "/name: is 3");
    EXPECT_SAYS(several, "/text: is 4");
    EXPECT_SAYS(several, "/properties/weight");
}

// Objects do not have the properties that their part excludes, even if these follow from others.
TEST_F(Parts, BecomePrototypes) {
    Prototype const made =
        read(R"({"name": "crate", "properties": {"weight": 7, "tag": false}})").prototype();
    EXPECT_EQ(made.name, "crate");
    ASSERT_EQ(made.values.size(), 2U);
    EXPECT_EQ(made.values[0]->info().text.key, "weight");
    auto const* const without = dynamic_cast<ValueOf<Without> const*>(made.values[1].get());
    ASSERT_NE(without, nullptr);
    EXPECT_EQ(without->value.keys, std::vector<std::string>{"tag"});
    EXPECT_EQ(read(R"({"name": "crate", "properties": {"weight": 7}})").prototype().values.size(), 1U);
}

TEST_F(Parts, OfALibraryAreOrderedByTheirUniqueNames) {
    PartLibrary library =
        sample::parts(registry, {R"({"name": "b"})", R"({"name": "a"})", R"({"name": "c"})"});
    EXPECT_EQ(library.names(), (std::vector<std::string>{"a", "b", "c"}));
    EXPECT_EQ(library.all().at(1)->name, "b");
    EXPECT_EQ(library.find("b"), library.all().at(1));
    EXPECT_EQ(library.find("d"), nullptr);
    try {
        library.add(read(R"({"title": "other", "name": "b"})"));
        FAIL();
    } catch (InputError const& error) {
        EXPECT_STREQ(error.what(),
                     "part.json:1:28: /name: there is already a part 'b', in part.json; expected "
                     "a unique name");
    }
    PartDefinition made; // made by a program, not read from a file
    made.name = "a";
    EXPECT_THROW(library.add(std::move(made)), InputError);
    EXPECT_EQ(library.all().size(), 3U);
}

TEST_F(Parts, OfAFolderAreReadTogetherAndSoAreTheirProblems) {
    namespace fs = std::filesystem;
    fs::path const folder = fs::path(::testing::TempDir()) / "trembler_part_library_test";
    fs::remove_all(folder);
    fs::create_directories(folder);
    auto const write = [&](std::string const& name, std::string const& text) {
        std::ofstream(folder / name) << text;
    };
    write("one.json", R"({"name": "one"})");
    write("two.json", R"({"name": "two"})");
    write("notes.txt", "no part");
    EXPECT_EQ(loadParts(registry, folder).names(), (std::vector<std::string>{"one", "two"}));
    write("three.json", R"({"name": "two"})");
    write("four.json", "{");
    try {
        static_cast<void>(loadParts(registry, folder));
        ADD_FAILURE();
    } catch (InputError const& error) {
        EXPECT_EQ(error.diagnostics().size(), 2U) << error.what();
        EXPECT_SAYS(std::string(error.what()), "there is already a part 'two'");
        EXPECT_SAYS(std::string(error.what()), "four.json");
    }
    fs::remove_all(folder);
    try {
        static_cast<void>(loadParts(registry, folder));
        ADD_FAILURE();
    } catch (InputError const& error) {
        EXPECT_SAYS(std::string(error.what()), "the folder of parts cannot be read: No such file");
    }
}

} // namespace
} // namespace part_library_test
} // namespace trembler
