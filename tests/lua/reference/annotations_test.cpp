#include "lua/reference/annotations.hpp"
#include "lua/reference/globals.hpp"
#include "puzzle/data/effects.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <lua.hpp>
#include <regex>
#include <set>

namespace trembler::lua {
namespace {

struct Annotated {
    Annotated() {
        registerEffects(registry);
        reference = makeReference(registry);
        text = annotationText(reference);
    }
    bool has(std::string const& part) const { return text.find(part) != std::string::npos; }
    /// Whether a field is named with something behind its name. A regular expression takes minutes with
    /// checks.
    bool hasField(std::string const& name) const {
        for (std::string const& written : {"---@field " + name + " ", "---@field " + name + "? "}) {
            std::size_t const at = text.find(written);
            if (at != std::string::npos && text.at(at + written.size()) != '\n') {
                return true;
            }
        }
        return false;
    }
    Registry registry;
    Reference reference;
    std::string text;
};

TEST(Annotations, AreLuaThatRuns) {
    Annotated const made;
    lua_State* const L = luaL_newstate();
    EXPECT_EQ(luaL_loadbuffer(L, made.text.data(), made.text.size(), "annotations"), 0)
        << lua_tostring(L, -1);
    EXPECT_EQ(lua_pcall(L, 0, 0, 0), 0) << lua_tostring(L, -1);
    for (char const* const global :
         {"vec2", "alive", "same", "world", "interaction", "math", "string", "log"}) {
        lua_getglobal(L, global);
        EXPECT_FALSE(lua_isnil(L, -1)) << global;
        lua_pop(L, 1);
    }
    lua_close(L);
}

TEST(Annotations, NameEveryPropertyFieldFunctionAndGlobal) {
    Annotated const made;
    for (ReferenceProperty const& property : made.reference.properties) {
        PropertyText const& text = property.info->text;
        EXPECT_TRUE(made.has("---@field [\"" + std::string(text.name) + "\"]")) << text.name;
        EXPECT_TRUE(made.has("---@field [\"" + std::string(text.key) + "\"]")) << text.key;
        EXPECT_TRUE(made.has("---| \"" + std::string(text.key) + "\"\n")) << text.key;
        for (ReferenceField const& field : property.fields) {
            EXPECT_TRUE(made.hasField(std::string(field.info.key))) << field.info.key;
        }
    }
    for (ReferenceFunction const& function : made.reference.functions) {
        std::string const name =
            std::string(function.role->name) + "." + std::string(function.call->text.name);
        EXPECT_TRUE(made.has("function " + name + "(")) << name;
    }
    for (GlobalNote const& note : globalNotes()) {
        std::string const name(note.name);
        std::string const written = note.inApply ? name.substr(name.find('.') + 1) // a field of a class
                                    : name.starts_with("vec2:") ? "function Vector" + name.substr(4) + "("
                                                                : name;
        EXPECT_TRUE(made.has(written)) << name;
    }
}

TEST(Annotations, DefineEveryTypeOnceThatTheyUse) {
    Annotated const made;
    std::set<std::string> defined;
    std::regex const definition("---@(?:class|alias) (trembler\\.[A-Za-z0-9_.]+)");
    for (std::sregex_iterator at(made.text.begin(), made.text.end(), definition), end; at != end; ++at) {
        EXPECT_TRUE(defined.insert((*at)[1]).second) << (*at)[1] << " is defined twice";
    }
    std::regex const use("trembler\\.[A-Za-z0-9_.]*[A-Za-z0-9_]");
    for (std::sregex_iterator at(made.text.begin(), made.text.end(), use), end; at != end; ++at) {
        EXPECT_TRUE(defined.contains(at->str()) || at->str() == "trembler.lua") << at->str();
    }
}

TEST(Annotations, HaveNoLineThatABreakInAMeaningHasCutOff) {
    Annotated const made;
    std::size_t begin = 0;
    while (begin < made.text.size()) {
        std::size_t const end = made.text.find('\n', begin);
        std::string const line = made.text.substr(begin, end - begin);
        bool const code = line.empty() || line.starts_with("--") || line.starts_with("function ") ||
                          line.starts_with("local ") || line.find(" = ") != std::string::npos;
        EXPECT_TRUE(code) << line;
        begin = end + 1;
    }
}

TEST(EditorSettings, AreJson) {
    auto const settings = nlohmann::json::parse(editorSettings());
    EXPECT_EQ(settings["runtime.version"], "LuaJIT");
    EXPECT_EQ(settings["runtime.builtin"]["io"], "disable");
}

} // namespace
} // namespace trembler::lua
