// The trace: ids in order of events, chains of causes, JSON lines, and refusal above its limits.
#include "runtime/trace/tracer.hpp"
#include "runtime/world/store.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <sstream>

namespace trembler {
namespace {

EventId record(EventSink& sink, std::string_view what, std::vector<ObjectId> const& objects,
               std::vector<EventId> const& causes) {
    return sink.record(what, objects, causes);
}

TEST(Tracer, IdsSortByFrameComponentChunkAndOrder) {
    Store store;
    EventSink late(&store, 2, 0, 0, Phase::resolver, "A");
    EventSink first(&store, 1, 0, 0, Phase::resolver, "A");
    EventSink chunk(&store, 1, 0, 1, Phase::resolver, "A");
    EventSink other(&store, 1, 3, 0, Phase::dps, "B");
    EventId const a = record(first, "a", {}, {});
    EventId const b = record(first, "b", {}, {});
    EventId const c = record(chunk, "c", {}, {});
    EventId const d = record(other, "d", {}, {});
    EventId const e = record(late, "e", {}, {});
    EXPECT_TRUE(a < b && b < c && c < d && d < e);
    EXPECT_FALSE(static_cast<bool>(EventId{}));
    EXPECT_TRUE(static_cast<bool>(a));
}

TEST(Tracer, ASinkGoesOnInAnotherPartOfAFrame) {
    Store store;
    EventSink sink(&store, 1, 3, 2, Phase::dps, "B");
    record(sink, "a", {}, {});
    sink.restart(7);
    EXPECT_TRUE(sink.events().empty());
    EventSink fresh(&store, 7, 3, 2, Phase::dps, "B");
    EXPECT_EQ(record(sink, "b", {}, {}), record(fresh, "b", {}, {})) << "as a new one would";
    EXPECT_EQ(sink.events().front().frame, 7U);
    EXPECT_THROW(sink.restart(std::uint64_t{1} << 26U), std::length_error);
}

TEST(Tracer, FindsNumbersAndChains) {
    Store store;
    Tracer tracer;
    EventSink one(&store, 1, 0, 0, Phase::resolver, "A");
    EventId const touch = record(one, "contact begun", {}, {});
    EventId const unrelated = record(one, "unrelated", {}, {});
    EventSink two(&store, 1, 5, 0, Phase::interaction, "B");
    EventId const connect = record(two, "connected", {}, {touch, EventId{}, touch});
    EventSink three(&store, 2, 0, 0, Phase::resolver, "A");
    EventId const on = record(three, "on", {}, {connect, touch});
    for (EventSink* sink : {&one, &two, &three}) {
        tracer.gather(*sink);
    }
    EXPECT_TRUE(one.events().empty()) << "a sink is empty once gathered";
    EXPECT_EQ(tracer.events().size(), 4U);
    EXPECT_EQ(tracer.find(connect)->causes, std::vector{touch}) << "no repeats, no 'none'";
    EXPECT_EQ(tracer.number(touch), 1U);
    EXPECT_EQ(tracer.number(on), 4U);
    EXPECT_EQ(tracer.number(EventId{12345}), 0U);
    EXPECT_EQ(tracer.find(EventId{}), nullptr);
    EXPECT_EQ(tracer.chain(on), (std::vector{touch, connect, on}));
    EXPECT_EQ(tracer.chain(unrelated), std::vector{unrelated});
    EXPECT_TRUE(tracer.chain(EventId{12345}).empty());
}

TEST(Tracer, WritesOneJsonObjectPerLineWithTheKeysOfTheContract) {
    Store store;
    ObjectId const bell = store.create("the \"bell\"\n\xff"); // also invalid UTF-8
    Tracer tracer;
    EventSink sink(&store, 3, 0, 0, Phase::resolver, "Dynamics Resolver");
    EventId const touch =
        record(sink, "contact begun", {bell}, {EventId{99}}); // a cause that was never gathered
    record(sink, "rings", {bell}, {touch});
    store.destroy({bell}); // events keep the names of destroyed objects
    tracer.gather(sink);
    std::ostringstream out;
    tracer.write(out);
    std::istringstream lines(out.str());
    std::vector<nlohmann::json> parsed;
    for (std::string line; std::getline(lines, line);) {
        parsed.push_back(nlohmann::json::parse(line));
    }
    ASSERT_EQ(parsed.size(), 2U);
    EXPECT_EQ(parsed[0]["id"], 1);
    EXPECT_EQ(parsed[0]["frame"], 3);
    EXPECT_EQ(parsed[0]["phase"], "resolver");
    EXPECT_EQ(parsed[0]["component"], "Dynamics Resolver");
    EXPECT_EQ(parsed[0]["event"], "contact begun");
    EXPECT_EQ(parsed[0]["causes"], nlohmann::json::array());
    EXPECT_EQ(parsed[1]["causes"], nlohmann::json::array({1}));
    EXPECT_EQ(parsed[1]["objects"].size(), 1U);
    EXPECT_EQ(parsed[1].size(), 7U);
    std::ostringstream tail;
    tracer.write(tail, 1);
    EXPECT_EQ(out.str().substr(out.str().size() - tail.str().size()), tail.str());
    EXPECT_EQ(tail.str().find("contact begun"), std::string::npos);
}

TEST(Tracer, RefusesIdsThatDoNotFitInsteadOfMixingThemUp) {
    Store store;
    EXPECT_NO_THROW((EventSink(&store, (1U << 26U) - 1, 255, 4095, Phase::dps, "A")));
    EXPECT_THROW((EventSink(&store, 1, 256, 0, Phase::dps, "A")), std::length_error);
    EXPECT_THROW((EventSink(&store, 1, 0, 4096, Phase::dps, "A")), std::length_error);
    EXPECT_THROW((EventSink(&store, 1U << 26U, 0, 0, Phase::dps, "A")), std::length_error);
    EventSink sink(&store, 1, 0, 0, Phase::resolver, "Dynamics");
    EventId last;
    for (std::uint32_t i = 0; i + 1 < (1U << 18U); ++i) {
        last = sink.record("x", {}, {});
    }
    EXPECT_LT(last, EventSink(&store, 1, 0, 1, Phase::resolver, "Dynamics").record("y", {}, {}));
    EXPECT_THROW(sink.record("x", {}, {}), std::length_error);
}

// The message names the frame; what was gathered before stays.
TEST(Tracer, RefusesMoreThanItsMemory) {
    Store store;
    std::vector<ObjectId> const objects{
        store.create("an object with a name that is longer than twenty letters")};
    Tracer tracer(100'000);
    std::uint64_t frame = 0;
    std::string why;
    while (why.empty()) {
        ASSERT_LT(++frame, 10'000U);
        EventSink sink(&store, frame, 0, 0, Phase::resolver, "A");
        EventId const cause = record(sink, "begun", objects, {});
        record(sink, "ended", objects, std::vector<EventId>{cause});
        try {
            tracer.gather(sink);
        } catch (std::length_error const& error) {
            why = error.what();
        }
    }
    EXPECT_EQ(why, "the account of this run takes more than 0 MB of memory in frame " +
                       std::to_string(frame) +
                       "; expected at most that much: compute fewer frames, or run without an account");
    std::size_t const events = tracer.events().size();
    EXPECT_GE(events, 2 * (frame - 1));
    EXPECT_LT(events * sizeof(Event), 100'000U);
    EXPECT_GT(events * 600, 100'000U) << "an event of this kind takes less";
}

} // namespace
} // namespace trembler
