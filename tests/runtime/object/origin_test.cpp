// The store's origins of objects, compared with a plain map of their creation.
#include "runtime/object/origin.hpp"
#include "runtime/world/store.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>

namespace trembler {
namespace {

TEST(Origin, IsThatOfTheObjectAndNotOfItsIndex) {
    Store store;
    ObjectId const placed =
        store.create("a", {.kind = Origin::Kind::placement, .prototype = 3, .number = 7, .maker = {}});
    EXPECT_EQ(store.originOf(placed), (Origin{Origin::Kind::placement, 3, 7, {}}));
    store.destroy({placed});
    EXPECT_EQ(store.originOf(placed), Origin{});
    ObjectId const next = store.create("a");
    ASSERT_EQ(next.index, placed.index);
    EXPECT_EQ(store.originOf(next), Origin{}) << "it is not the origin of the earlier object with this index";
    EXPECT_EQ(store.originOf(placed), Origin{});
    EXPECT_EQ(store.originOf({}), Origin{});
    EXPECT_EQ(store.originOf({12, 0}), Origin{});
}

TEST(Origin, NamesThePartByItsNumber) {
    Store store;
    Prototype ball;
    ball.name = "ball";
    std::uint32_t const number = store.prototypes().add(std::move(ball));
    ObjectId const made =
        store.create("x", {.kind = Origin::Kind::object, .prototype = number, .number = 0, .maker = {}});
    ObjectId const free =
        store.create("ball 1", {.kind = Origin::Kind::object, .prototype = {}, .number = 1, .maker = {}});
    ASSERT_NE(store.prototypeOf(made), nullptr);
    EXPECT_EQ(store.prototypeOf(made)->name, "ball");
    EXPECT_EQ(store.prototypeOf(free), nullptr) << "its name does not matter";
    store.destroy({made});
    EXPECT_EQ(store.prototypeOf(made), nullptr);
}

TEST(Origin, IsNotPartOfTheHash) {
    Store first;
    Store second;
    (void)first.create("a", {.kind = Origin::Kind::placement, .prototype = 1, .number = 2, .maker = {}});
    (void)second.create("a");
    EXPECT_EQ(first.hash(), second.hash());
}

TEST(Origin, FollowsItsModelThroughAnySequence) {
    EXPECT_TRUE(rc::check([](std::vector<std::uint16_t> const& deeds) {
        Store store;
        std::map<ObjectId, Origin> living;
        std::vector<ObjectId> ever;
        for (std::uint16_t const deed : deeds) {
            if (deed % 3 != 0 || ever.empty()) {
                Origin const origin{static_cast<Origin::Kind>(deed % 6),
                                    deed % 5 == 0 ? std::nullopt : std::optional(deed % 7U), deed,
                                    ever.empty() ? ObjectId{} : ever[deed % ever.size()]};
                ever.push_back(store.create("object " + std::to_string(ever.size()), origin));
                living[ever.back()] = origin;
            } else {
                ObjectId const id = ever[deed % ever.size()];
                store.destroy({id});
                living.erase(id);
            }
        }
        for (ObjectId const id : ever) {
            RC_ASSERT(store.originOf(id) == (living.contains(id) ? living[id] : Origin{}));
        }
    }));
}

} // namespace
} // namespace trembler
