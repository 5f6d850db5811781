// Objects, their names and their properties, compared with a map of the expected ones.
#include "runtime/property/state_hash.hpp"
#include "runtime/world/store.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <optional>
#include <set>
#include <stdexcept>

namespace trembler {
namespace store_test {
namespace {

using sample::Tag;
using sample::Weight;

struct Expected {
    ObjectId id;
    std::optional<double> weight;
    bool tagged = false;
};

void expectSame(Store const& store, std::map<std::string, Expected> const& model,
                std::set<ObjectId> const& gone) {
    RC_ASSERT(store.objects().size() == model.size());
    std::size_t weights = 0;
    for (auto const& [name, expected] : model) {
        RC_ASSERT(store.alive(expected.id));
        RC_ASSERT(store.find(name) == expected.id);
        RC_ASSERT(store.nameOf(expected.id) == name);
        RC_ASSERT(store.has<Tag>(expected.id) == expected.tagged);
        RC_ASSERT(store.has<Weight>(expected.id) == expected.weight.has_value());
        if (expected.weight) {
            RC_ASSERT(store.findColumn<Weight>()->find(expected.id)->value == *expected.weight);
            ++weights;
        }
    }
    if (auto const* const column = store.findColumn<Weight>()) {
        RC_ASSERT(column->size() == weights);
    }
    for (ObjectId const id : gone) {
        RC_ASSERT(!store.alive(id));
        RC_ASSERT(store.nameOf(id) == "(gone)");
        RC_ASSERT(!store.has<Weight>(id));
    }
}

TEST(Store, ContainsWhatWasAddedAndNotRemoved) {
    EXPECT_TRUE(rc::check("the same as a map", [] {
        Store store;
        std::map<std::string, Expected> model;
        std::set<ObjectId> gone;
        for (int step = *rc::gen::inRange(0, 60); step > 0; --step) {
            std::string const name = "object " + std::to_string(*rc::gen::inRange(0, 8));
            auto const at = model.find(name);
            if (at == model.end()) {
                RC_ASSERT(!store.find(name).valid());
                ObjectId const id = store.create(name);
                RC_ASSERT(!gone.contains(id)); // an id is never used twice
                model[name].id = id;
                continue;
            }
            switch (*rc::gen::inRange(0, 4)) {
            case 0:
                RC_ASSERT_THROWS_AS(store.create(name), std::invalid_argument);
                break;
            case 1: {
                double const weight = *rc::gen::inRange(1, 100);
                store.column<Weight>().set(at->second.id, {weight});
                at->second.weight = weight;
                break;
            }
            case 2:
                store.column<Tag>().addDefault(at->second.id);
                at->second.tagged = true;
                break;
            default: {
                // Several at once, with duplicates and one that was already destroyed.
                std::vector<ObjectId> all{at->second.id, at->second.id};
                all.insert(all.end(), gone.begin(), gone.end());
                if (*rc::gen::arbitrary<bool>()) {
                    all.push_back(model.begin()->second.id);
                }
                store.destroy(all);
                for (ObjectId const id : all) {
                    gone.insert(id);
                    std::erase_if(model, [&](auto const& entry) { return entry.second.id == id; });
                }
            }
            }
            expectSame(store, model, gone);
        }
    }));
}

TEST(Store, EveryObjectHasAName) {
    Store store;
    EXPECT_THROW(static_cast<void>(store.create("")), std::invalid_argument);
    EXPECT_EQ(store.objects().size(), 0U) << "no object is left";
    ObjectId const id = store.create("a");
    EXPECT_THROW(static_cast<void>(store.create("a")), std::invalid_argument);
    EXPECT_EQ(store.objects().size(), 1U);
    store.destroy({id});
    EXPECT_NE(store.create("a"), id);
}

// The hash covers the objects. It must not depend on which columns were ever made, or on the history of the
// values.
TEST(Store, HashesDependOnTheObjectsAndNotOnTheirHistory) {
    Store one;
    ObjectId const a = one.create("a");
    ObjectId const b = one.create("b");
    one.column<Weight>().set(b, {3});
    one.column<Weight>().set(a, {2});
    Store other;
    static_cast<void>(other.create("a"));
    static_cast<void>(other.create("b"));
    other.column<Tag>().addDefault(b);
    other.column<Weight>().set(a, {7});
    other.column<Weight>().set(a, {2});
    other.column<Weight>().set(b, {3});
    EXPECT_NE(other.hash(), one.hash());
    other.column<Tag>().remove(b);
    EXPECT_EQ(other.hash(), one.hash()) << "an empty column equals one that was never made";
    other.column<Weight>().set(b, {3.0000000000000004});
    EXPECT_NE(other.hash(), one.hash());
    // The ids of the next objects are part of the state, but not of the hash of the objects.
    Store later;
    static_cast<void>(later.create("a"));
    ObjectId const c = later.create("c");
    later.destroy({c});
    Store plain;
    static_cast<void>(plain.create("a"));
    EXPECT_EQ(later.hash(), plain.hash());
    auto const state = [](Store const& store) {
        StateHash hash;
        store.hash(hash);
        return hash.digest();
    };
    EXPECT_NE(state(later), state(plain));
}

TEST(Store, StructureVersionCountsAddedAndRemovedPropertiesAndNotValues) {
    Store store;
    ObjectId const a = store.create("a");
    store.column<Weight>().set(a, {1});
    std::uint64_t const before = store.structureVersion();
    store.column<Weight>().set(a, {2});
    store.column<Weight>().touch();
    EXPECT_EQ(store.structureVersion(), before);
    store.column<Tag>().addDefault(a);
    EXPECT_GT(store.structureVersion(), before);
    std::uint64_t const tagged = store.structureVersion();
    store.column<Tag>().remove(a);
    EXPECT_GT(store.structureVersion(), tagged);
}

struct Impostor {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Impostor", "weight", "Has a key that is taken."};
};

TEST(Store, TwoPropertiesOfOneKeyAreRefused) {
    Store store;
    static_cast<void>(store.column<Weight>());
    EXPECT_THROW(static_cast<void>(store.column<Impostor>()), std::logic_error);
}

std::vector<ObjectId>& completed() {
    static std::vector<ObjectId> all;
    return all;
}

TEST(Store, CompletionsGetEachObjectOnceInAscendingOrder) {
    Store store;
    ObjectId const a = store.create("a");
    ObjectId const b = store.create("b");
    completed().clear();
    store.setCompletions({[](Store&, std::span<ObjectId const> ids) {
                              completed().insert(completed().end(), ids.begin(), ids.end());
                          },
                          [](Store& all, std::span<ObjectId const> ids) {
                              for (ObjectId const id : ids) {
                                  all.column<Tag>().addDefault(id);
                              }
                          }});
    std::vector<ObjectId> const ids{b, a, b};
    store.complete(ids);
    EXPECT_EQ(completed(), (std::vector<ObjectId>{a, b}));
    EXPECT_TRUE(store.has<Tag>(a) && store.has<Tag>(b));
}

TEST(Store, APrototypeGivesAllItsPropertiesAndIsTheOrigin) {
    Store store;
    Prototype crate;
    crate.name = "crate";
    crate.values.push_back(std::make_unique<ValueOf<Weight>>(Weight{9}));
    crate.values.push_back(std::make_unique<ValueOf<Tag>>());
    ObjectId const id = store.create("one");
    store.furnish(id, crate);
    EXPECT_EQ(store.findColumn<Weight>()->find(id)->value, 9);
    EXPECT_TRUE(store.has<Tag>(id));
    EXPECT_EQ(store.prototypeOf(id), nullptr) << "its origin names none";
    store.destroy({id});
    EXPECT_EQ(store.prototypeOf(id), nullptr);
    EXPECT_EQ(store.originOf(id).prototype, std::nullopt);
}

} // namespace
} // namespace store_test
} // namespace trembler
