// Which held calls are events: against a plain list of those of the last apply, at random.
#include "runtime/component/call_trace.hpp"
#include "tests/runtime/world/heat.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <random>
#include <vector>

namespace trembler {
namespace call_trace_test {
namespace {

using heat::AddHeat;

class CallTraces : public testing::Test {
protected:
    CallTraces() {
        for (std::uint32_t i = 0; i < 12; ++i) {
            things_.push_back(store_.create(fmt::format("thing {}", i)));
        }
    }

    /// Applies with these things' calls in each chunk, and compares each call's event.
    void apply(std::vector<std::vector<std::size_t>> const& chunks) {
        std::map<std::size_t, EventId> now;
        trace_.begin();
        trace_.widen(chunks.size());
        for (std::size_t chunk = 0; chunk < chunks.size(); ++chunk) {
            EventSink sink(&store_, step_, 0, static_cast<std::uint32_t>(chunk), Phase::interaction, "A");
            for (std::size_t const thing : chunks[chunk]) {
                std::size_t const events = sink.events().size();
                EventId const id = trace_.record(AddHeat{things_[thing], 1}, {}, sink, chunk);
                bool const isNew = sink.events().size() > events;
                auto const before = last_.find(thing);
                if (before != last_.end()) {
                    EXPECT_FALSE(isNew);
                    EXPECT_EQ(id, before->second);
                } else if (auto const here = now.find(thing); here != now.end()) {
                    EXPECT_FALSE(isNew);
                    EXPECT_EQ(id, here->second);
                } else {
                    EXPECT_TRUE(isNew);
                }
                now.emplace(thing, id);
            }
        }
        trace_.end();
        last_ = now;
        ++step_;
    }

    /// As after an apply that has failed.
    void forget() {
        trace_.forget();
        last_.clear();
    }

    [[nodiscard]] std::size_t things() const { return things_.size(); }

private:
    Store store_;
    std::vector<ObjectId> things_;
    CallTrace trace_;
    std::map<std::size_t, EventId> last_;
    std::uint32_t step_ = 1;
};

TEST_F(CallTraces, AreThoseOfTheLastApplyOrNew) {
    apply({{0, 1, 2}});
    apply({{0, 1, 2}});
    apply({{0, 1}}); // fewer
    apply({{0, 1, 2}});
    apply({{1, 0, 2, 3}}); // in another order
    apply({{}});
    apply({{}});
    apply({{3, 3, 0}}); // twice
    apply({{3, 3, 0}});
    apply({{3, 0}, {1}, {2, 4}});
    apply({{3, 0}, {1}, {2, 4}});
    apply({{0}, {4, 3}, {2}}); // in other chunks
    apply({{0}});              // fewer chunks
    apply({{0}, {4, 3}, {2}});
    forget();
    apply({{0}, {4, 3}, {2}});
    apply({{0}, {4, 3}, {2}});
}

TEST_F(CallTraces, OfRandomAppliesAreThoseOfTheLastOrNew) {
    std::mt19937 random(5);
    auto const below = [&](std::size_t n) { return random() % n; };
    std::vector<std::vector<std::size_t>> chunks;
    for (int round = 0; round < 3000; ++round) {
        switch (below(6)) {
        case 0: { // other calls, each in one chunk
            chunks.assign(1 + below(3), {});
            for (std::size_t thing = 0; thing < things(); ++thing) {
                if (below(2) == 0) {
                    auto& chunk = chunks[below(chunks.size())];
                    chunk.insert(chunk.end(), 1 + below(5) / 4, thing);
                }
            }
            break;
        }
        case 1: // one call less
            for (auto& chunk : chunks) {
                if (!chunk.empty() && below(2) == 0) {
                    chunk.erase(chunk.begin() + static_cast<std::ptrdiff_t>(below(chunk.size())));
                }
            }
            break;
        case 2: // another order
            for (auto& chunk : chunks) {
                std::shuffle(chunk.begin(), chunk.end(), random);
            }
            break;
        default: // the same again, as most often
            break;
        }
        apply(chunks);
    }
}

} // namespace
} // namespace call_trace_test
} // namespace trembler
