// The store of a script holds what it declares, up to a number of bytes.
#include "lua/component/script_store.hpp"

#include <gtest/gtest.h>

namespace trembler::lua {
namespace {

Manifest storing(std::size_t fields) {
    Manifest manifest;
    manifest.name = "Dynamics <- Test";
    for (std::size_t i = 0; i < fields; ++i) {
        manifest.objectStore.push_back({"f" + std::to_string(i), Value(std::string())});
    }
    return manifest;
}

ObjectId idOf(std::uint32_t number) {
    return ObjectId{number, 1};
}

TEST(ScriptStore, IsFullAtItsBytesAndEmptiesWithItsObjects) {
    ScriptStore store(storing(32));
    std::size_t const each = 100 + 32 * 40 + 100; // with one long text
    std::size_t const room = largestStore / each;
    std::string const text(100, 'x');
    for (std::uint32_t i = 0; i < room; ++i) {
        ASSERT_EQ(store.setOfObject(idOf(i), 0, Value(text)), "") << i;
    }
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(text)), "") << "as large as before";
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(std::string())), "");
    EXPECT_EQ(store.setOfObject(idOf(0), 0, Value(text)), "");
    EXPECT_FALSE(store.full());
    ScriptStore other(storing(32));
    other.adopt(store);
    for (ScriptStore* const one : {&store, &other}) {
        std::string const wrong = one->setOfObject(idOf(static_cast<std::uint32_t>(room)), 0, Value(text));
        EXPECT_EQ(wrong,
                  "the store of the script is full: the values of its objects take more than 67108864 bytes");
        EXPECT_TRUE(one->full());
    }
    ScriptStore third(storing(32));
    third.adopt(store);
    third.keepOnly([&](ObjectId id) { return id != idOf(7); });
    EXPECT_EQ(third.setOfObject(idOf(static_cast<std::uint32_t>(room)), 0, Value(text)), "");
}

} // namespace
} // namespace trembler::lua
