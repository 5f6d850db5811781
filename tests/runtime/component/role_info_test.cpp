#include "runtime/component/role_info.hpp"
#include "tests/runtime/world/heat.hpp"

#include <gtest/gtest.h>

namespace trembler {
namespace role_info_test {
namespace {

using heat::AddHeat;
using heat::HeatRole;
using heat::Strike;

TEST(RoleInfo, DescribesEveryCallWithItsArguments) {
    RoleInfo const& role = roleInfo<HeatRole>();
    EXPECT_EQ(role.name, "Heat");
    ASSERT_EQ(role.calls.size(), 2U);
    EXPECT_EQ(role.calls[0].text.name, "addHeat");
    EXPECT_EQ(role.calls[0].algebra, Algebra::sumOfRates);
    EXPECT_EQ(role.calls[0].size, sizeof(AddHeat));
    ASSERT_EQ(role.calls[0].arguments.size(), 2U);
    FieldPlace const& power = role.calls[0].arguments[1];
    EXPECT_EQ(power.info.key, "power");
    EXPECT_EQ(power.info.unit, "W");
    EXPECT_EQ(power.kind, FieldKind::number);
    AddHeat const sample{{3, 1}, 42};
    double read = 0;
    std::memcpy(&read, reinterpret_cast<char const*>(&sample) + power.offset, sizeof read); // NOLINT
    EXPECT_EQ(read, 42);
}

TEST(RoleInfo, RecordsCallsThatAreKnownOnlyAtRunTime) {
    Callers callers;
    Channels channels(callers);
    std::unique_ptr<OpenSource> const source = roleInfo<HeatRole>().open();
    CallerId const caller = callers.add("Heat <- Test");
    source->attach(channels, caller);
    Channel<HeatRole>& channel = channels.of<HeatRole>();
    auto const before = channel.version();
    AddHeat const call{{3, 1}, 42};
    source->begin();
    source->record(0, &call, {}, nullptr);
    source->end();
    EXPECT_NE(channel.version(), before);
    int seen = 0;
    channel.forCalls<AddHeat>([&](AddHeat const& got, CallOrigin const& origin) {
        ++seen;
        EXPECT_EQ(got.object, call.object);
        EXPECT_EQ(got.power, 42);
        EXPECT_EQ(origin.caller, caller);
    });
    EXPECT_EQ(seen, 1);
    source->begin(); // a held call ends with the next turn
    source->end();
    EXPECT_TRUE(channel.empty());
}

TEST(RoleInfo, TakesBackTheCallsOfAFailedTurnOnly) {
    Callers callers;
    Channels channels(callers);
    std::unique_ptr<OpenSource> const source = roleInfo<HeatRole>().open();
    source->attach(channels, callers.add("Heat <- Test"));
    Channel<HeatRole>& channel = channels.of<HeatRole>();
    auto const make = [&](double amount) { // a held call, and one that is carried out once
        AddHeat const held{{3, 1}, amount};
        Strike const once{{3, 1}, amount};
        source->record(0, &held, {}, nullptr);
        source->record(1, &once, {}, nullptr);
    };
    source->begin();
    make(1);
    source->end();
    auto const before = channel.version();
    source->begin();
    make(2);
    source->fail();
    EXPECT_NE(channel.version(), before) << "the held call was withdrawn";
    std::vector<double> left;
    channel.forCalls<AddHeat>([&](AddHeat const& call, CallOrigin const&) { left.push_back(call.power); });
    channel.forCalls<Strike>([&](Strike const& call, CallOrigin const&) { left.push_back(call.energy); });
    EXPECT_EQ(left, std::vector<double>{1}) << "the call of the first turn that waits to be carried out";
    channel.clearOnce();
    EXPECT_TRUE(channel.empty());
}

TEST(RoleInfo, RecordsManyCallsLikeOneAfterTheOther) {
    Callers callers;
    Channels channels(callers);
    std::unique_ptr<OpenSource> const source = roleInfo<HeatRole>().open();
    source->attach(channels, callers.add("Heat <- Test"));
    std::array<AddHeat, 3> const calls{AddHeat{{3, 1}, 42}, AddHeat{{3, 1}, -7}, AddHeat{{1, 2}, 0.5}};
    source->begin();
    source->record(0, calls.data(), {}, nullptr);
    source->recordMany(0, &calls[1], 2);
    source->recordMany(0, nullptr, 0);
    source->end();
    std::size_t seen = 0;
    channels.of<HeatRole>().forCalls<AddHeat>([&](AddHeat const& got, CallOrigin const&) {
        EXPECT_EQ(got.object, calls.at(seen).object);
        EXPECT_EQ(got.power, calls.at(seen).power);
        ++seen;
    });
    EXPECT_EQ(seen, calls.size());
}

struct Forgetful {
    static constexpr CallText text{"forgetful", "(object, power)", "Leaves out its power."};
    static constexpr Algebra algebra = Algebra::sumOfRates;
    ObjectId object;
    double power = 0;
    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object"}, self.object);
    }
    [[nodiscard]] std::array<ObjectId, 1> objects() const { return {object}; }
};
struct ForgetfulRole {
    static constexpr std::string_view name = "Forgetful";
    using Calls = CallList<Forgetful>;
};

TEST(RoleInfo, RefusesACallThatLeavesOutAMember) {
    EXPECT_THROW((void)roleInfo<ForgetfulRole>(), RuleBroken);
}

} // namespace
} // namespace role_info_test
} // namespace trembler
