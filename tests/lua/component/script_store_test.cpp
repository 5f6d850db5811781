// The store of a script holds what it declares, up to a number of bytes.
#include "lua/component/script_store.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

constexpr std::size_t fields = 32;
constexpr std::size_t bare = 100 + fields * 40; // bytes of an object with empty texts in all its fields

/// A field for texts, and 31 with a text of that length in every object: few objects fill the store.
Manifest storing(std::size_t initial) {
    Manifest manifest;
    manifest.name = "Dynamics <- Test";
    for (std::size_t i = 0; i < fields; ++i) {
        manifest.objectStore.push_back(
            {"f" + std::to_string(i), Value(std::string(i == 0 ? 0 : initial, 'i'))});
    }
    return manifest;
}

ObjectId idOf(std::uint32_t number) {
    return ObjectId{number, 1};
}

TEST(ScriptStore, IsFullAtItsBytesAndEmptiesWithItsObjects) {
    std::size_t initial = 1000;
    std::size_t each = 0;
    do { // until a text has room for what the last object leaves
        each = bare + (fields - 1) * ++initial;
    } while (largestStore % each == 0 || largestStore % each > longestText);
    auto const room = static_cast<std::uint32_t>(largestStore / each);
    std::string const last(largestStore % each, 'x');
    Value const none = std::string();
    ScriptStore store(storing(initial));
    for (std::uint32_t i = 0; i < room; ++i) {
        ASSERT_EQ(store.setOfObject(idOf(i), 0, none), "") << i;
    }
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(last)), "") << "to the last byte";
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(last)), "") << "as large as before";
    EXPECT_EQ(store.setOfObject(idOf(0), 0, none), "");
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(last)), "");
    EXPECT_FALSE(store.full());
    ScriptStore other(storing(initial));
    other.adopt(store);
    for (ScriptStore* const one : {&store, &other}) {
        for (ObjectId const more : {idOf(1), idOf(room)}) {
            EXPECT_EQ(one->setOfObject(more, 0, Value(std::string("x"))),
                      "the store of the script is full: the values of its objects take more than 67108864 "
                      "bytes");
        }
        EXPECT_TRUE(one->full());
    }
    ScriptStore third(storing(initial));
    third.adopt(store);
    third.keepOnly([&](ObjectId id) { return id != idOf(7); });
    EXPECT_EQ(third.setOfObject(idOf(room), 0, none), "");
    EXPECT_EQ(third.setOfObject(idOf(1), 0, Value(std::string("x"))),
              store.setOfObject(idOf(1), 0, Value(std::string("x"))));
}

} // namespace
} // namespace trembler::lua
