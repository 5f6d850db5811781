// Several effects own "connections" of a level: chosen by the connected objects, or by the stated kind.
#include "runtime/level/build/build_world.hpp"
#include "runtime/level/write/write_level.hpp"
#include "runtime/population/population_resolver.hpp"
#include "tests/runtime/level/plumbing.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace trembler {
namespace {

using plumbing::Vessel;
using sample::Links;
using sample::Tag;

/// Strings between tags, pipes between vessels; "both" has both.
struct Site {
    Site() {
        sample::fill(registry);
        plumbing::fill(registry);
    }
    [[nodiscard]] static std::string levelWith(std::string const& connections) {
        return R"({"version": 1, "title": "t", "objects": [
            {"name": "tag 1", "properties": {"tag": true}}, {"name": "tag 2", "properties": {"tag": true}},
            {"name": "tank 1", "properties": {"test_vessel": 1}}, {"name": "tank 2", "properties": {"test_vessel": 1}},
            {"name": "both 1", "properties": {"tag": true, "test_vessel": 1}},
            {"name": "both 2", "properties": {"tag": true, "test_vessel": 1}}, {"name": "air"}],
            "connections": [)" +
               connections + "]}";
    }
    std::unique_ptr<World> build(std::string const& connections) {
        PartLibrary const none;
        return buildWorld(registry, sample::read(registry, levelWith(connections)), none);
    }
    std::string problemOf(std::string const& connections) {
        return plumbing::problemOf([&] { (void)build(connections); });
    }
    template <class P>
    static std::vector<std::string> ends(World const& world, std::string const& name) {
        P const* const found = world.find<P>(world.store().find(name));
        std::vector<std::string> names;
        for (ObjectId const id : found == nullptr ? std::vector<ObjectId>{} : found->to) {
            names.push_back(world.store().nameOf(id));
        }
        return names;
    }
    Registry registry;
};

using Names = std::vector<std::string>;

void expectWords(std::string const& text, std::initializer_list<char const*> words) {
    for (char const* word : words) {
        EXPECT_NE(text.find(word), std::string::npos) << "'" << word << "' is missing in: " << text;
    }
}

TEST(LayConnections, APairBelongsToTheOnlyEffectThatCanConnectTheTwo) {
    Site site;
    auto const world =
        site.build(R"(["tag 2", "tag 1"], ["tank 1", "tank 2"], ["tag 1", "both 1"], ["both 1", "tank 2"])");
    EXPECT_EQ(Site::ends<Links>(*world, "tag 1"), Names{"tag 2"});
    EXPECT_EQ(Site::ends<Links>(*world, "both 1"), Names{"tag 1"});
    EXPECT_EQ(Site::ends<Vessel>(*world, "tank 1"), Names{"tank 2"});
    EXPECT_EQ(Site::ends<Vessel>(*world, "both 1"), Names{"tank 2"});
    EXPECT_EQ(Site::ends<Vessel>(*world, "tag 1"), Names{});
}

TEST(LayConnections, AStatedKindDecides) {
    Site site;
    auto const world = site.build(R"({"between": ["both 1", "both 2"], "kind": "pipe"},
                                     {"kind": "string", "between": ["both 2", "both 1"]})");
    EXPECT_EQ(Site::ends<Vessel>(*world, "both 1"), Names{"both 2"});
    EXPECT_EQ(Site::ends<Links>(*world, "both 1"), Names{"both 2"});
}

TEST(LayConnections, APairThatSeveralEffectsCouldConnectIsRefusedAtItsPlace) {
    Site site;
    std::string const text = site.problemOf(R"(["tag 1", "tag 2"], ["both 2", "both 1"])");
    expectWords(
        text, {"test.json:6:", "/connections/1: 'both 1' and 'both 2' can be connected in more than one way",
               R"({"between": ["both 1", "both 2"], "kind": one of 'pipe')", "'string'"});
}

TEST(LayConnections, APairThatNoEffectCanConnectIsRefusedAtItsPlace) {
    Site site;
    expectWords(site.problemOf(R"(["air", "both 1"])"),
                {"/connections/0: nothing can connect 'air' and 'both 1'", "no string: only what has a tag",
                 "no pipe: 'air' holds no liquid; expected two vessels"});
    expectWords(site.problemOf(R"({"between": ["tag 1", "tag 2"], "kind": "pipe"})"),
                {"/connections/0: 'tag 1' holds no liquid; expected two vessels"});
    Registry none;
    registerRuntime(none);
    none.property<Tag>();
    none.property<Vessel>();
    PartLibrary const parts;
    try {
        (void)buildWorld(none, sample::read(none, Site::levelWith(R"(["tag 1", "tag 2"])")), parts);
        FAIL() << "accepted";
    } catch (InputError const& error) {
        expectWords(error.what(), {"/connections: no effect of this program has connections"});
    }
}

TEST(LayConnections, FormsAndKindsAreCheckedAsTheyAreRead) {
    Site site;
    struct Case {
        char const* connection;
        std::initializer_list<char const*> words;
    };
    for (Case const& c : {
             Case{R"({"between": ["tag 1", "tag 2"], "kind": "pip"})",
                  {"/connections/0/kind: there is no kind of connection 'pip' (did you mean 'pipe'?)",
                   "'pipe' or 'string'"}},
             Case{R"({"between": ["tag 1", "tag 2"]})", {"/connections/0", "kind", "'pipe' or 'string'"}},
             Case{R"({"kind": "pipe"})", {"/connections/0", "between"}},
             Case{R"({"between": ["tag 1"], "kind": "string"})", {"/connections/0/between", "a pair"}},
             Case{R"({"between": ["tag 1", "tga 2"], "kind": "string"})",
                  {"/connections/0/between/1: there is no object 'tga 2' (did you mean 'tag 2'?)"}},
             Case{R"({"between": ["tag 1", "tag 1"], "kind": "string"})", {"/connections/0", "with itself"}},
             Case{R"({"between": ["tag 1", "tag 2"], "kind": "string", "colour": 1})",
                  {"/connections/0/colour", "unknown key 'colour'"}},
             Case{R"({"between": ["tag 1", "tag 2"], "kind": 3})", {"/connections/0/kind"}},
             Case{"3", {"/connections/0", "a pair", "between"}},
         }) {
        std::string all;
        for (std::string const& problem : sample::problemsOf(site.registry, Site::levelWith(c.connection))) {
            all += problem + "\n";
        }
        expectWords(all, c.words);
    }
}

TEST(LayConnections, AKindThatAnEditorStatesIsCheckedToo) {
    Site site;
    LevelFile level = sample::read(site.registry, Site::levelWith(""));
    level.connections.push_back({"tag 1", "tag 2", "", "rope"});
    PartLibrary const none;
    try {
        (void)buildWorld(site.registry, level, none);
        FAIL() << "accepted";
    } catch (InputError const& error) {
        expectWords(error.what(), {"there is no kind of connection 'rope'"});
    }
}

TEST(LayConnections, AreWrittenAndReadBack) {
    Site site;
    LevelFile const level = sample::read(
        site.registry,
        Site::levelWith(R"({"kind": "pipe", "between": ["both 2", "both 1"]}, ["tag 1", "tag 2"])"));
    nlohmann::json const written = nlohmann::json::parse(writeLevel(level).dump());
    EXPECT_EQ(written["connections"].dump(),
              R"([{"between":["both 2","both 1"],"kind":"pipe"},["tag 1","tag 2"]])");
    LevelFile const again = sample::read(site.registry, written.dump());
    ASSERT_EQ(again.connections.size(), 2U);
    EXPECT_EQ(again.connections[0].kind, "pipe");
    EXPECT_EQ(again.connections[0].a, "both 2");
    EXPECT_EQ(again.connections[1].kind, "");
}

} // namespace
} // namespace trembler
