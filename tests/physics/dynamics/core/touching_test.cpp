// Touching pairs, compared with a multiset of touching pieces.
#include "physics/dynamics/core/touching.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <algorithm>
#include <map>
#include <set>

namespace trembler {
namespace touching_test {
namespace {

using Pair = std::pair<ObjectId, ObjectId>;

std::vector<Pair> pairsOf(std::vector<TouchingPair> const& list) {
    std::vector<Pair> pairs;
    for (TouchingPair const& pair : list) {
        pairs.emplace_back(pair.a, pair.b);
    }
    return pairs;
}

ObjectId object(std::uint32_t index) {
    return {index, 0};
}

TEST(TouchBook, ListsTouchingBegunAndEndedPairs) {
    EXPECT_TRUE(rc::check("the same as a count of pieces", [] {
        TouchBook book;
        std::map<Pair, int> pieces;
        Contacts before;
        for (int frame = *rc::gen::inRange(1, 6); frame > 0; --frame) {
            std::vector<TouchChange> changes;
            std::set<Pair> touched; // at any time within the frame
            for (int i = *rc::gen::inRange(0, 25); i > 0; --i) {
                auto const a = *rc::gen::inRange<std::uint32_t>(0, 4);
                Pair const pair{object(a), object(a + *rc::gen::inRange<std::uint32_t>(1, 3))};
                int const delta = pieces[pair] == 0 || *rc::gen::arbitrary<bool>() ? 1 : -1;
                pieces[pair] += delta;
                if (pieces[pair] > 0) {
                    touched.insert(pair);
                }
                changes.push_back({pair.first, pair.second, delta});
            }
            book.take(changes);
            RC_ASSERT(changes.empty());
            Contacts next;
            book.compare(before, next);
            std::vector<Pair> const was = pairsOf(before.current);
            std::vector<Pair> current;
            std::vector<Pair> begun;
            std::vector<Pair> ended;
            std::vector<Pair> brief;
            for (auto const& [pair, count] : pieces) {
                bool const touchedBefore = std::find(was.begin(), was.end(), pair) != was.end();
                if (count > 0) {
                    current.push_back(pair);
                }
                if (count > 0 && !touchedBefore) {
                    begun.push_back(pair);
                }
                if (count == 0 && touchedBefore) {
                    ended.push_back(pair);
                }
                if (count == 0 && !touchedBefore && touched.contains(pair)) {
                    brief.push_back(pair);
                }
            }
            RC_ASSERT(pairsOf(next.current) == current);
            RC_ASSERT(pairsOf(next.begun) == begun);
            RC_ASSERT(pairsOf(next.ended) == ended);
            RC_ASSERT(pairsOf(next.brief) == brief);
            RC_ASSERT(book.any() == !current.empty());
            if (!begun.empty() || !ended.empty() || !brief.empty()) {
                RC_ASSERT(book.changed());
            }
            book.markSeen();
            RC_ASSERT(!book.changed());
            before = next;
        }
    }));
}

TEST(TouchBook, FurtherPiecesOfAPairAreNoChange) {
    TouchBook book;
    Contacts contacts;
    book.compare({}, contacts);
    book.markSeen();
    std::vector<TouchChange> changes{{object(1), object(2), 1}};
    book.take(changes);
    EXPECT_TRUE(book.changed());
    book.compare(Contacts(contacts), contacts);
    book.markSeen();
    changes = {{object(1), object(2), 1}, {object(1), object(2), 1}};
    book.take(changes);
    EXPECT_FALSE(book.changed());
    changes = {{object(1), object(2), -1}, {object(1), object(2), -1}};
    book.take(changes);
    EXPECT_FALSE(book.changed()) << "one piece still touches";
    changes = {{object(1), object(2), -1}};
    book.take(changes);
    EXPECT_TRUE(book.changed());
}

// An engine is swapped for another, whose book begins with the contacts that it finds itself.
TEST(TouchBook, ContinuesFromAnyEarlierStateAndKeepsItsEvents) {
    Contacts before;
    before.current = {{object(1), object(2), EventId{7}}, {object(3), object(4), EventId{8}}};
    TouchBook book;
    std::vector<TouchChange> changes{{object(3), object(4), 1}, {object(5), object(6), 1}};
    book.take(changes);
    Contacts next;
    book.compare(before, next);
    ASSERT_EQ(next.current.size(), 2U);
    EXPECT_EQ(next.current[0].event, EventId{8}) << "it has touched since event 8";
    EXPECT_EQ(next.current[1].event, EventId{});
    EXPECT_EQ(pairsOf(next.begun), (std::vector<Pair>{{object(5), object(6)}}));
    EXPECT_EQ(pairsOf(next.ended), (std::vector<Pair>{{object(1), object(2)}}));
    // A pair that touched before, and only briefly for the new engine, has ended and is in no other list.
    TouchBook other;
    changes = {{object(1), object(2), 1}, {object(1), object(2), -1}};
    other.take(changes);
    other.compare(before, next);
    EXPECT_TRUE(next.brief.empty());
    EXPECT_EQ(next.ended.size(), 2U);
}

} // namespace
} // namespace touching_test
} // namespace trembler
