// Names become the objects of a store, anywhere in a value; unknown names are reported with their path.
#include "runtime/level/build/references.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <set>

namespace trembler {
namespace references_test {
namespace {

using sample::Cake;
using sample::Knot;
using sample::Links;
using Dangling = std::set<std::pair<std::string, std::string>>; // path, name

template <class P>
Dangling resolve(P& value, NameTable const& names, Store const& store) {
    ValueOf<P> held(value);
    Dangling dangling;
    for (DanglingReference const& one : resolveReferences(held, names, store)) {
        EXPECT_TRUE(dangling.emplace(one.path, one.name).second) << one.path << " is reported twice";
    }
    value = held.value;
    return dangling;
}

TEST(References, NamesBecomeTheObjectsThatHaveThem) {
    Store store;
    NameTable names;
    ObjectId const ann = names.refer("Ann"); // not in the order of the store
    ObjectId const bob = names.refer("Bob");
    ObjectId const bobIn = store.create("Bob");
    ObjectId const annIn = store.create("Ann");
    Cake cake;
    cake.eater = bob;
    cake.guests = {ann, bob, ann};
    EXPECT_EQ(resolve(cake, names, store), Dangling{});
    EXPECT_EQ(cake.eater, bobIn);
    EXPECT_EQ(cake.guests, (std::vector{annIn, bobIn, annIn}));
}

TEST(References, UnknownNamesAreReportedWithTheirPathAndReferToNothing) {
    Store store;
    NameTable names;
    ObjectId const here = store.create("here");
    Cake cake;
    cake.eater = names.refer("gone");
    cake.guests = {names.refer("here"), names.refer("away"), names.refer("gone")};
    EXPECT_EQ(resolve(cake, names, store),
              (Dangling{{"/eater", "gone"}, {"/guests/1", "away"}, {"/guests/2", "gone"}}));
    EXPECT_FALSE(cake.eater.valid());
    EXPECT_EQ(cake.guests, (std::vector{here, ObjectId{}, ObjectId{}}));
    Knot knot;
    knot.b = names.refer("a/b~c");
    EXPECT_EQ(resolve(knot, names, store), (Dangling{{"/b", "a/b~c"}})) << "a name is not a path";
    EXPECT_FALSE(knot.a.valid()) << "an invalid reference stays invalid";
}

TEST(References, LeaveEverythingElseAsItIs) {
    Store store;
    Cake cake;
    cake.flavour = Flavour::sour;
    cake.note = "somebody"; // a text is not a reference, even if an object has this name
    cake.toppings.resize(3);
    cake.toppings[1].spots = {{1, 2}, {3, 4}};
    Cake const before = cake;
    NameTable names;
    (void)names.refer("somebody");
    EXPECT_EQ(resolve(cake, names, store), Dangling{});
    EXPECT_EQ(cake.note, before.note);
    EXPECT_EQ(cake.flavour, before.flavour);
    ASSERT_EQ(cake.toppings.size(), 3U);
    EXPECT_EQ(cake.toppings[1].spots, before.toppings[1].spots);
}

TEST(References, OfAnyListAgreeWithLookUpsByName) {
    EXPECT_TRUE(rc::check([] {
        Store store;
        NameTable names;
        std::vector<std::string> const known{"a", "b", "c", "d", "e"};
        std::vector<ObjectId> objects;
        for (std::string const& name : known) {
            objects.push_back(*rc::gen::arbitrary<bool>() ? store.create(name) : ObjectId{});
        }
        Links links;
        Dangling missing;
        std::vector<ObjectId> expected;
        int const count = *rc::gen::inRange(0, 10);
        for (int i = 0; i < count; ++i) {
            auto const which = static_cast<std::size_t>(*rc::gen::inRange(0, 5));
            links.to.push_back(names.refer(known[which]));
            expected.push_back(objects[which]);
            if (!objects[which].valid()) {
                missing.emplace("/to/" + std::to_string(i), known[which]);
            }
        }
        RC_ASSERT(resolve(links, names, store) == missing);
        RC_ASSERT(links.to == expected);
    }));
}

} // namespace
} // namespace references_test
} // namespace trembler
