// A text in a property is short, as every object has its own copy of it.
#include "runtime/level/json/json_node.hpp"
#include "runtime/level/property/property_reader.hpp"
#include "runtime/level/write/property_schema.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace trembler {
namespace {

std::string problemsOf(std::size_t bytes) {
    std::string const text = nlohmann::json{{"note", std::string(bytes, 'x')}}.dump();
    Problems problems;
    auto const document = JsonDocument::parse(text, "cake.json");
    NameTable names;
    auto const value = readProperty(propertyInfo<sample::Cake>(),
                                    JsonNode(*document, document->root(), "", problems), &names);
    EXPECT_EQ(value != nullptr, problems.empty());
    try {
        problems.throwIfAny();
    } catch (InputError const& error) {
        return error.what();
    }
    return "";
}

TEST(PropertyReader, RefusesATextAboveTheLengthThatTheSchemaStates) {
    EXPECT_EQ(fieldsSchema(propertyInfo<sample::Cake>())["properties"]["note"]["maxLength"], 300);
    EXPECT_EQ(problemsOf(300), "");
    std::string const said = problemsOf(301);
    EXPECT_NE(said.find("has 301 bytes; expected at most 300"), std::string::npos) << said;
}

} // namespace
} // namespace trembler
