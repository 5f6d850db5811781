// Texts of changed trees: unchanged parts keep the spelling and the lines of their author.
#include "puzzle/edit/text/lay_out.hpp"
#include "puzzle/edit/text/source_text.hpp"
#include "tests/puzzle/edit/edit_kit.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler::edit {
namespace {

TEST(SourceText, GivesTheTextOfAnUnchangedTree) {
    for (auto const& path : editData().levels()) {
        std::string const text = fileText(path);
        SourceText const source(text);
        EXPECT_EQ(source.textOf(source.tree()), text) << path;
    }
    for (std::string const text :
         {"[]", "{ }", " 1e3 ", "\xEF\xBB\xBF{\"a\" :\t[1 ,2.50 ]}\r\n", "\"\\u00e4\\\"\""}) {
        SourceText const source(text);
        EXPECT_EQ(source.textOf(source.tree()), text);
    }
}

TEST(SourceText, ChangesOnlyWhatDiffers) {
    SourceText const source("{\n  \"a\": [1.50, 2e0,   3],\n\n  \"b\" : {\"x\": 1.0}\n}\n");
    Json tree = source.tree();
    tree["a"][1] = 7;
    EXPECT_EQ(source.textOf(tree), "{\n  \"a\": [1.50, 7,   3],\n\n  \"b\" : {\"x\": 1.0}\n}\n");
    tree["c"] = true;
    EXPECT_EQ(source.textOf(tree),
              "{\n  \"a\": [1.50, 7,   3],\n\n  \"b\" : {\"x\": 1.0},\n  \"c\": true\n}\n");
    tree.erase("a");
    EXPECT_EQ(source.textOf(tree), "{\n  \"b\" : {\"x\": 1.0},\n  \"c\": true\n}\n");
}

TEST(SourceText, KeepsTheTextOfEntriesThatMoveInTheirList) {
    SourceText const source(
        "[\n  {\"name\": \"a\", \"at\": [1.0, 2]},\n\n  {\"name\": \"b\"},\n  {\"name\": \"c\"}\n]");
    Json tree = source.tree();
    tree.erase(1U);
    EXPECT_EQ(source.textOf(tree), "[\n  {\"name\": \"a\", \"at\": [1.0, 2]},\n  {\"name\": \"c\"}\n]");
    tree.push_back(Json{{"name", "d"}});
    EXPECT_EQ(source.textOf(tree),
              "[\n  {\"name\": \"a\", \"at\": [1.0, 2]},\n  {\"name\": \"c\"},\n  {\"name\": \"d\"}\n]");
    Json turned = Json::array({source.tree()[2], source.tree()[1], source.tree()[0]});
    EXPECT_EQ(Json::parse(source.textOf(turned)), turned);
    EXPECT_NE(source.textOf(turned).find("[1.0, 2]"), std::string::npos);
}

TEST(SourceText, LaysOutLongValuesInLines) {
    Json list = Json::array();
    for (int i = 0; i < 60; ++i) {
        list.push_back(Json::array({i, i * 1000}));
    }
    std::string const text = layOutFile(Json{{"title", "x"}, {"corners", list}});
    EXPECT_EQ(Json::parse(text)["corners"], list);
    std::size_t widest = 0;
    for (std::size_t at = 0; at < text.size();) {
        std::size_t const end = text.find('\n', at);
        widest = std::max(widest, end - at);
        at = end + 1;
    }
    EXPECT_LE(widest, widestLine);
    EXPECT_EQ(layOutFile(Json::object()), "{}\n");
}

Json anyTree(int depth) {
    int const kind = *rc::gen::inRange(0, depth > 0 ? 6 : 4);
    switch (kind) {
    case 0:
        return *rc::gen::inRange(-1000, 1000);
    case 1:
        return *rc::gen::inRange(-1000, 1000) / 8.0;
    case 2:
        return *rc::gen::element<std::string>("a", "ü", "\"\\", "", "b c");
    case 3:
        return *rc::gen::element<Json>(Json(), Json(true), Json(false));
    default:
        break;
    }
    Json made = kind == 4 ? Json::array() : Json::object();
    int const count = *rc::gen::inRange(0, 5);
    for (int i = 0; i < count; ++i) {
        if (kind == 4) {
            made.push_back(anyTree(depth - 1));
        } else {
            made[*rc::gen::element<std::string>("name", "part", "x", "y", "z")] = anyTree(depth - 1);
        }
    }
    return made;
}

TEST(SourceText, ReadsBackAsTheTreeWhateverChanged) {
    rc::check([] {
        Json const before = anyTree(4);
        Json const after = anyTree(4);
        std::string const text = *rc::gen::arbitrary<bool>() ? before.dump(3) : layOutFile(before);
        SourceText const source(text);
        RC_ASSERT(source.textOf(before) == text);
        RC_ASSERT(Json::parse(source.textOf(after)) == after);
        Json wanted = after;
        TreePatch const patch = TreePatch::between(before, wanted);
        Json tree = before;
        patch.apply(tree);
        RC_ASSERT(tree == after);
        patch.revert(tree);
        RC_ASSERT(tree == before);
    });
}

} // namespace
} // namespace trembler::edit
