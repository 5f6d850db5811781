// The state hash covers every field, and no padding.
#include "runtime/placement.hpp"
#include "runtime/property/state_hash.hpp"
#include "runtime/world/store.hpp"
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <set>

namespace trembler {
namespace {

using namespace sample;

template <class P>
std::uint64_t hashOf(P const& value) {
    StateHash hash;
    hash.value(value);
    return hash.digest();
}

// The same value with `filling` in the bytes between its fields.
Padded paddedWith(unsigned char filling) {
    Padded value{true, 5, 2.5, 9};
    std::array<unsigned char, sizeof(Padded)> bytes;
    std::memcpy(bytes.data(), &value, sizeof value);
    std::fill(bytes.begin() + sizeof(bool), bytes.begin() + offsetof(Padded, number), filling);
    std::fill(bytes.begin() + offsetof(Padded, last) + sizeof(std::int32_t), bytes.end(), filling);
    std::memcpy(&value, bytes.data(), sizeof value);
    return value;
}

TEST(StateHash, DoesNotDependOnPadding) {
    Padded const a = paddedWith(0x00);
    Padded const b = paddedWith(0xff);
    EXPECT_NE(std::memcmp(&a, &b, sizeof a), 0) << "no padding to test";
    EXPECT_EQ(hashOf(a), hashOf(b));
    Column<Padded> columnA;
    Column<Padded> columnB;
    columnA.set({0, 0}, a);
    columnB.set({0, 0}, b);
    StateHash hashA;
    StateHash hashB;
    columnA.hash(hashA);
    columnB.hash(hashB);
    EXPECT_EQ(hashA.digest(), hashB.digest());
}

TEST(StateHash, DependsOnEveryFieldOfEveryKind) {
    std::vector<std::function<void(Everything&)>> const changes = {
        [](Everything& e) { e.flag = true; },
        [](Everything& e) { e.count = 1; },
        [](Everything& e) { e.ratio = 1e-300; },
        [](Everything& e) { e.ratio = -0.0; }, // hashed by its bits, because it may behave differently
        [](Everything& e) { e.point.x = 1; },
        [](Everything& e) { e.point.y = 1; },
        [](Everything& e) { e.label = "x"; },
        [](Everything& e) {
            e.other = {0, 0};
        },
        [](Everything& e) { e.other.generation = 1; },
        [](Everything& e) { e.mood = Mood::glad; },
        [](Everything& e) { e.numbers = {0}; },
        [](Everything& e) {
            e.numbers = {0, 0};
        },
        [](Everything& e) { e.words = {""}; },
        [](Everything& e) {
            e.words = {"", ""};
        },
        [](Everything& e) { e.words = {"ab"}; },
        [](Everything& e) {
            e.words = {"a", "b"};
        },
        [](Everything& e) { e.parts = {{}}; },
        [](Everything& e) {
            e.parts = {{2, Mood::calm}};
        },
        [](Everything& e) {
            e.parts = {{1, Mood::cross}};
        },
    };
    std::set<std::uint64_t> hashes{hashOf(Everything{})};
    for (std::size_t i = 0; i < changes.size(); ++i) {
        Everything e;
        changes[i](e);
        EXPECT_TRUE(hashes.insert(hashOf(e)).second) << "change " << i << " does not change the hash";
    }
    EXPECT_EQ(hashOf(Everything{}), hashOf(Everything{}));
}

// The digest of an empty input is a published value of XXH3-64 with seed 0.
TEST(StateHash, IsXxh3) {
    EXPECT_EQ(StateHash().digest(), 0x2d06800538d394c2ULL);
}

TEST(StoreHash, DoesNotDependOnTheOrderInWhichColumnsAndValuesWereMade) {
    auto const build = [](bool forwards) {
        auto store = std::make_unique<Store>();
        std::vector<ObjectId> ids;
        for (int i = 0; i < 10; ++i) {
            ids.push_back(store->create("thing " + std::to_string(i)));
        }
        if (!forwards) {
            std::reverse(ids.begin(), ids.end());
            static_cast<void>(store->column<Everything>()); // made, but empty
            static_cast<void>(store->slot<Kept>());
        }
        for (ObjectId const id : ids) {
            auto const setPlace = [&] { store->column<Place>().set(id, {{1.0 * id.index, 0}}); };
            auto const setSpeed = [&] { store->column<Speed>().set(id, {{2.0 * id.index, 0}}); };
            if (forwards) {
                setPlace();
                setSpeed();
            } else {
                setSpeed();
                store->column<Place>().set(id, {{-1, -1}});
                setPlace();
            }
        }
        return store;
    };
    auto const a = build(true);
    auto const b = build(false);
    EXPECT_EQ(a->hash(), b->hash());
    b->column<Speed>().set({4, 0}, {{8, 1e-12}});
    EXPECT_NE(a->hash(), b->hash());
}

TEST(StoreHash, DependsOnTheOwnersOfProperties) {
    std::set<std::uint64_t> hashes;
    Store store;
    EXPECT_TRUE(hashes.insert(store.hash()).second);
    ObjectId const a = store.create("a");
    EXPECT_TRUE(hashes.insert(store.hash()).second);
    ObjectId const b = store.create("b");
    EXPECT_TRUE(hashes.insert(store.hash()).second);
    store.column<Place>().addDefault(a);
    EXPECT_TRUE(hashes.insert(store.hash()).second);
    store.column<Place>().remove(a);
    store.column<Place>().addDefault(b);
    EXPECT_TRUE(hashes.insert(store.hash()).second) << "the owner differs, the values are the same";
    store.column<Place>().remove(b);
    store.column<Speed>().addDefault(b);
    EXPECT_TRUE(hashes.insert(store.hash()).second) << "the property differs, the values are the same";
    store.destroy({a});
    ObjectId const again = store.create("a");
    EXPECT_EQ(again.index, a.index);
    EXPECT_TRUE(hashes.insert(store.hash()).second)
        << "the generation differs, names and values are the same";
}

// A property that is hashed as the bytes of a column must not have padding.
TEST(StateHash, PropertiesHashedAsBytesHaveNoPadding) {
    EXPECT_EQ(sizeof(Position), sizeof(Vec2));
    EXPECT_EQ(sizeof(Velocity), sizeof(Vec2));
    EXPECT_EQ(sizeof(Rotation), sizeof(double));
    EXPECT_EQ(sizeof(AngularVelocity), sizeof(double));
    Column<Place> asBytes;
    Column<Speed> byField;
    for (std::uint32_t i = 0; i < 3; ++i) {
        asBytes.set({i, 0}, {{1.5 * i, -2.0 * i}});
        byField.set({i, 0}, {{1.5 * i, -2.0 * i}});
    }
    StateHash one;
    StateHash other;
    asBytes.hash(one);
    byField.hash(other);
    EXPECT_EQ(one.digest(), other.digest()) << "both ways feed the same bytes";
}

} // namespace
} // namespace trembler
