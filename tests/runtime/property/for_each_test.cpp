// Joins compared with brute force over ids: columns with equal owners, with different ones, and ranges of
// rows.
#include "runtime/property/for_each.hpp"
#include "tests/runtime/property/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace trembler {
namespace {

using namespace sample;

struct Found {
    ObjectId id;
    double sum;
    friend bool operator==(Found const&, Found const&) = default;
};

// The owners of each property, as bits by object index.
struct Columns {
    Column<Place> places;
    Column<Speed> speeds;
    Column<Padded> padded;
    Columns(std::uint32_t p, std::uint32_t s, std::uint32_t d) {
        for (std::uint32_t i = 0; i < 32; ++i) {
            ObjectId const id{i, i % 3};
            if ((p >> i) & 1U) {
                places.set(id, {{1.0 * i, 0}});
            }
            if ((s >> i) & 1U) {
                speeds.set(id, {{100.0 * i, 0}});
            }
            if ((d >> i) & 1U) {
                padded.set(id, {true, 0, 1e4 * i, 0});
            }
        }
    }
};

TEST(ForEach, JoinsAsBruteForceDoes) {
    EXPECT_TRUE(rc::check([](std::uint32_t p, std::uint32_t s, std::uint32_t d, bool aligned) {
        s = aligned ? p : s;
        d = aligned ? p : d;
        Columns columns(p, s, d);
        std::vector<Found> expected;
        for (std::uint32_t i = 0; i < 32; ++i) {
            if ((p & s & d) >> i & 1U) {
                expected.push_back({{i, i % 3}, 10101.0 * i});
            }
        }
        std::vector<Found> joined;
        forEach(
            [&](ObjectId id, Place const& a, Speed const& b, Padded const& c) {
                joined.push_back({id, a.value.x + b.value.x + c.weight});
            },
            columns.places, columns.speeds, columns.padded);
        RC_ASSERT(joined == expected);
        // The same through const columns, iterating over another one.
        Columns const& fixed = columns;
        joined.clear();
        forEach(
            [&](ObjectId id, Padded const& c, Place const& a, Speed const& b) {
                joined.push_back({id, a.value.x + b.value.x + c.weight});
            },
            fixed.padded, fixed.places, fixed.speeds);
        RC_ASSERT(joined == expected);
    }));
}

TEST(ForEach, RangesOfRowsCoverEverythingOnce) {
    EXPECT_TRUE(rc::check([](std::uint32_t p, std::uint32_t s) {
        Columns columns(p, s, 0);
        auto const cut = *rc::gen::inRange<std::size_t>(0, columns.places.size() + 1);
        std::vector<ObjectId> whole;
        std::vector<ObjectId> parts;
        forEach([&](ObjectId id, Place&, Speed&) { whole.push_back(id); }, columns.places, columns.speeds);
        auto const note = [&](ObjectId id, Place&, Speed&) { parts.push_back(id); };
        forEachInRows(0, cut, note, columns.places, columns.speeds);
        forEachInRows(cut, columns.places.size(), note, columns.places, columns.speeds);
        RC_ASSERT(parts == whole);
    }));
}

TEST(ForEach, ChangesTheColumnsThemselves) {
    for (std::uint32_t const speeds : {0b1111U, 0b1010U}) { // aligned and not
        Columns columns(0b1111U, speeds, 0);
        forEach([](ObjectId, Place& place, Speed const& speed) { place.value += speed.value; },
                columns.places, columns.speeds);
        for (std::uint32_t i = 0; i < 4; ++i) {
            double const expected = ((speeds >> i) & 1U) ? 101.0 * i : 1.0 * i;
            EXPECT_EQ((columns.places[ObjectId{i, i % 3}].value.x), expected);
        }
    }
}

TEST(ForEach, OfOneColumnWalksAllOfIt) {
    Columns columns(0xf0f0U, 0, 0);
    std::size_t count = 0;
    forEach([&](ObjectId, Place const&) { ++count; }, columns.places);
    EXPECT_EQ(count, 8U);
    forEach([&](ObjectId, Speed const&) { FAIL() << "no object has it"; }, columns.speeds);
}

} // namespace
} // namespace trembler
