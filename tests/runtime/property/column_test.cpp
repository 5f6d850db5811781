// A column under random operations, compared with a std::map.
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <memory>

namespace trembler {
namespace {

using namespace sample;
using Model = std::map<ObjectId, Place>;

void agree(Column<Place> const& column, Model const& model) {
    RC_ASSERT(column.size() == model.size());
    RC_ASSERT(column.empty() == model.empty());
    RC_ASSERT(column.values().size() == model.size());
    std::size_t row = 0;
    for (auto const& [id, place] : model) { // ascending, in the order that owners must have
        RC_ASSERT(column.owners()[row] == id);
        RC_ASSERT(column.row(id) == row);
        RC_ASSERT(column.has(id));
        RC_ASSERT(column.find(id) == &column.values()[row]);
        RC_ASSERT(column[id] == place);
        RC_ASSERT(!column.has({id.index, id.generation + 1}));
        ++row;
    }
    for (std::uint32_t index = 0; index < 12; ++index) {
        bool const owned =
            std::any_of(model.begin(), model.end(), [&](auto const& e) { return e.first.index == index; });
        if (!owned) {
            RC_ASSERT(column.find({index, 0}) == nullptr);
        }
    }
}

TEST(Column, AddingManyEqualsAddingOneByOne) {
    EXPECT_TRUE(rc::check([] {
        Column<Place> column;
        Column<Place> oneByOne;
        Model model;
        for (std::uint32_t const index :
             *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange<std::uint32_t>(0, 12))) {
            Place const place{{static_cast<double>(index), 2}};
            column.set({index, 0}, place);
            oneByOne.set({index, 0}, place);
            model[{index, 0}] = place;
        }
        std::vector<ObjectId> ids;
        std::vector<Place> values;
        for (std::uint32_t index = 0; index < 12; ++index) {
            if (!model.contains({index, 0}) && *rc::gen::arbitrary<bool>()) {
                Place const place{{static_cast<double>(index), 3}};
                ids.push_back({index, 0});
                values.push_back(place);
                oneByOne.set({index, 0}, place);
                model[{index, 0}] = place;
            }
        }
        std::uint64_t const structure = column.structureVersion();
        column.addMany(ids, values);
        RC_ASSERT((column.structureVersion() > structure) == !ids.empty());
        RC_ASSERT(column.sameOwners(oneByOne));
        agree(column, model);
    }));
}

TEST(Column, FollowsItsModelThroughAnySequence) {
    EXPECT_TRUE(rc::check([] {
        Column<Place> column;
        Model model;
        auto const steps = *rc::gen::inRange(0, 60);
        for (int step = 0; step < steps; ++step) {
            std::uint64_t const version = column.version();
            std::uint64_t const structure = column.structureVersion();
            std::size_t const before = model.size();
            ObjectId const id{*rc::gen::inRange<std::uint32_t>(0, 12), 0};
            switch (*rc::gen::inRange(0, 4)) {
            case 0: {
                Place const place{{static_cast<double>(step), 1}};
                column.set(id, place);
                model[id] = place;
                RC_ASSERT(column.version() > version);
                break;
            }
            case 1:
                column.addDefault(id);
                model.emplace(id, Place{});
                break;
            case 2:
                column.remove(id);
                model.erase(id);
                break;
            default: {
                auto ids = *rc::gen::container<std::vector<std::uint32_t>>(rc::gen::inRange(0U, 14U));
                std::sort(ids.begin(), ids.end()); // including duplicates and unknown ids
                std::vector<ObjectId> gone;
                for (std::uint32_t const index : ids) {
                    gone.push_back({index, 0});
                    model.erase({index, 0});
                }
                column.removeAll(gone);
                break;
            }
            }
            agree(column, model);
            RC_ASSERT((column.structureVersion() != structure) == (model.size() != before));
            RC_ASSERT(column.structureVersion() >= structure);
            RC_ASSERT(column.version() >= version);
            if (model.size() != before) {
                RC_ASSERT(column.version() > version);
            }
        }
    }));
}

TEST(Column, DistinguishesGenerations) {
    Column<Place> column;
    column.set({4, 1}, {{1, 1}});
    EXPECT_FALSE(column.has({4, 0}));
    EXPECT_FALSE(column.has({4, 2}));
    EXPECT_EQ(column.find({4, 0}), nullptr);
    column.remove({4, 0});
    EXPECT_TRUE(column.has({4, 1}));
    EXPECT_FALSE(column.has({}));
}

TEST(Column, ReadingDoesNotChangeTheVersion) {
    Column<Place> column;
    column.set({0, 0}, {{1, 2}});
    std::uint64_t const version = column.version();
    static_cast<void>(column.find({0, 0}));
    static_cast<void>(column.values());
    static_cast<void>(column.owners());
    column.remove({1, 0});
    column.addDefault({0, 0});
    ObjectId const stranger{9, 0};
    column.removeAll(std::span(&stranger, 1));
    EXPECT_EQ(column.version(), version);
}

// Sets are compared correctly after additions and removals in different orders and by different calls.
TEST(Column, SameOwnersIsNeverWrong) {
    EXPECT_TRUE(rc::check([] {
        Column<Place> a;
        Column<Speed> b;
        auto const steps = *rc::gen::inRange(0, 50);
        for (int step = 0; step < steps; ++step) {
            ObjectId const id{*rc::gen::inRange<std::uint32_t>(0, 5), *rc::gen::inRange<std::uint32_t>(0, 2)};
            ObjectId const other{id.index, 1 - id.generation};
            switch (*rc::gen::inRange(0, 4)) {
            case 0:
                a.remove(other); // an index has one living object
                a.addDefault(id);
                break;
            case 1:
                b.remove(other);
                b.addDefault(id);
                break;
            case 2:
                a.remove(id);
                break;
            default:
                b.removeAll(std::span(&id, 1));
                break;
            }
            bool const same =
                std::equal(a.owners().begin(), a.owners().end(), b.owners().begin(), b.owners().end());
            RC_ASSERT(a.sameOwners(b) == same);
            RC_ASSERT(b.sameOwners(a) == same);
        }
    }));
}

TEST(Column, ThroughTheUntypedInterfaceIsTheSameColumn) {
    std::unique_ptr<ColumnBase> const column = propertyInfo<Place>().makeColumn();
    EXPECT_EQ(&column->info(), &propertyInfo<Place>());
    column->addDefault({3, 0});
    EXPECT_EQ(static_cast<Column<Place>&>(*column).values().size(), 1U);
    column->remove({3, 0});
    EXPECT_TRUE(column->empty());
}

} // namespace
} // namespace trembler
