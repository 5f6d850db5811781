// The calls of a role without their C++ types: their arguments with units and ranges, and a way to make them.
// With these, interactions can be written in another language than C++.
#pragma once

#include "runtime/component/call.hpp"
#include "runtime/component/call_trace.hpp"
#include "runtime/component/channels.hpp"
#include "runtime/component/rule_broken.hpp"
#include "runtime/property/field_place.hpp"
#include "runtime/property/members.hpp"

#include <fmt/format.h>

#include <cstring>
#include <memory>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

namespace trembler {

/// A call whose arguments are described like the fields of a property:
///
///     template <class Self, class Visitor>
///     static void describe(Self& self, Visitor&& visit) {
///         visit(FieldInfo{.key = "object", .unit = "", .meaning = "the object", .required = true},
///         self.object);
///     }
///
/// in the order in which they are stated, each member once. `required` arguments must be stated; the others
/// have the member's initial value. A range of a vector is that of each of its coordinates.
template <class C>
concept DescribedCall = Described<C>;

/// One function of a role.
struct CallDescription {
    CallText text;
    Algebra algebra = Algebra::sumOfRates;
    std::size_t size = 0;              ///< of its C++ type, in bytes; at most mostBytes
    std::vector<char> initial{};       ///< the bytes of one with all its initial values
    std::vector<FieldPlace> arguments; ///< in the order in which they are stated

    static constexpr std::size_t mostBytes = 256;
};

/// The calls of one interaction of a role that is known only while the program runs.
class OpenSource {
public:
    virtual ~OpenSource() = default;
    /// Connects it to the resolver; as Interaction::bind() does.
    virtual void attach(Channels& channels, CallerId caller) = 0;
    /// A turn begins: the held calls of the last one end.
    virtual void begin() = 0;
    /// Records a call: `bytes` is a value of its C++ type, `call` its place in RoleInfo::calls. With a sink,
    /// it is traced.
    virtual void record(std::size_t call, void const* bytes, EventId cause, EventSink* sink) = 0;
    /// Takes back all calls that have not been carried out, held ones included.
    virtual void withdraw() = 0;
    /// The turn is done.
    virtual void end() = 0;
    /// Call instead of end() if an exception ended the turn: takes back the calls of this turn.
    virtual void fail() = 0;
    /// Records `count` calls of one kind without a trace, as record() does one after the other: `bytes` are
    /// values of its C++ type side by side. For interactions that gather the calls of a turn first: it costs
    /// one copy, without an indirect call for each call.
    virtual void recordMany(std::size_t call, void const* bytes, std::size_t count) = 0;
};

/// A role as it is known while the program runs. One constant instance for each role.
struct RoleInfo {
    std::type_index type;
    std::string_view name;
    std::vector<CallDescription> calls; ///< without calls in sequence, which come from outside the world
    std::unique_ptr<OpenSource> (*open)();
};

namespace detail {

template <ResolverRole Role>
class OpenSourceOf final : public OpenSource {
public:
    void attach(Channels& channels, CallerId caller) override {
        source_.caller = caller;
        channels.of<Role>().add(&source_);
    }
    void begin() override {
        stood_ = !source_.empty();
        source_.startTurn();
        trace_.begin();
    }
    void record(std::size_t call, void const* bytes, EventId cause, EventSink* sink) override {
        recorders[call](*this, bytes, cause, sink);
    }
    void withdraw() override {
        source_.clearHeld();
        source_.clearOnce();
    }
    void end() override {
        trace_.end();
        if (stood_ || !source_.empty()) { // otherwise nothing has changed for the resolver
            ++source_.version;
        }
    }
    void fail() override {
        source_.withdrawTurn();
        trace_.forget();
        source_.version += stood_ ? 1 : 0;
    }
    void recordMany(std::size_t call, void const* bytes, std::size_t count) override {
        manyRecorders[call](*this, static_cast<char const*>(bytes), count);
    }

private:
    using Recorder = void (*)(OpenSourceOf&, void const*, EventId, EventSink*);
    using ManyRecorder = void (*)(OpenSourceOf&, char const*, std::size_t);

    template <class C>
    static void recordOf(OpenSourceOf& self, void const* bytes, EventId cause, EventSink* sink) {
        C call{};
        std::memcpy(static_cast<void*>(&call), bytes, sizeof call); // a call is trivially copyable
        auto& buffer = std::get<CallBuffer<C>>(self.source_.chunks.front());
        buffer.push(call);
        if (sink != nullptr) {
            buffer.setCauseOfLast(self.trace_.record(call, cause, *sink, 0));
        }
    }
    template <class C>
    static void recordManyOf(OpenSourceOf& self, char const* bytes, std::size_t count) {
        auto& buffer = std::get<CallBuffer<C>>(self.source_.chunks.front());
        for (std::size_t i = 0; i < count; ++i) {
            C call{};
            std::memcpy(static_cast<void*>(&call), bytes + i * sizeof(C), sizeof call);
            buffer.push(call);
        }
    }
    template <class... C>
    static std::vector<Recorder> listRecorders(CallList<C...> const&) {
        std::vector<Recorder> all;
        ((C::algebra == Algebra::sequence ? void() : all.push_back(&recordOf<C>)), ...);
        return all;
    }
    template <class... C>
    static std::vector<ManyRecorder> listManyRecorders(CallList<C...> const&) {
        std::vector<ManyRecorder> all;
        ((C::algebra == Algebra::sequence ? void() : all.push_back(&recordManyOf<C>)), ...);
        return all;
    }
    static inline std::vector<Recorder> const recorders = listRecorders(typename Role::Calls{});
    static inline std::vector<ManyRecorder> const manyRecorders = listManyRecorders(typename Role::Calls{});

    CallSource<Role> source_;
    CallTrace trace_;
    bool stood_ = false;
};

template <class C>
constexpr std::size_t argumentCount() {
    if constexpr (requires { typename C::MembersOf; }) {
        return memberCount<typename C::MembersOf>();
    } else {
        return memberCount<C>();
    }
}

template <class C>
void describeCall(std::vector<CallDescription>& calls) {
    if constexpr (C::algebra != Algebra::sequence) {
        static_assert(DescribedCall<C>, "a call describes its arguments: 'static void describe(Self&, "
                                        "Visitor&&)', see DescribedCall");
        static_assert(sizeof(C) <= CallDescription::mostBytes);
        if constexpr (DescribedCall<C>) {
            C const initial{};
            CallDescription made{.text = C::text,
                                 .algebra = C::algebra,
                                 .size = sizeof(C),
                                 .initial = std::vector<char>(sizeof(C)),
                                 .arguments = fieldPlaces<C>()};
            std::memcpy(made.initial.data(), static_cast<void const*>(&initial), sizeof(C));
            if (made.arguments.size() != argumentCount<C>()) {
                throw RuleBroken(fmt::format("the call {} describes {} of its {} members", C::text.name,
                                             made.arguments.size(), argumentCount<C>()));
            }
            calls.push_back(std::move(made));
        }
    }
}

} // namespace detail

/// The description of a role, made on first use. Throws RuleBroken if a call does not describe every member.
/// Thread-safe.
template <ResolverRole Role>
[[nodiscard]] RoleInfo const& roleInfo() {
    static RoleInfo const info = [] {
        RoleInfo made{typeid(Role), Role::name, {}, []() -> std::unique_ptr<OpenSource> {
                          return std::make_unique<detail::OpenSourceOf<Role>>();
                      }};
        [&]<class... C>(CallList<C...> const&) {
            (detail::describeCall<C>(made.calls), ...);
        }(typename Role::Calls{});
        return made;
    }();
    return info;
}

} // namespace trembler
