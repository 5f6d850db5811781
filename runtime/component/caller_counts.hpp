// What a counted set (5.7.2) knows of one key: how often each caller has added it.
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/property/description.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trembler {

class StateHash;

/// The key is in the set while any caller's count is above zero. What one caller takes away is its own: it
/// never touches what another has added, and of nothing it takes nothing. Mostly there is one caller, for
/// whom nothing is allocated. Thread-safe while nobody changes it.
class CallerCounts {
public:
    struct Entry {
        CallerId caller;
        std::int32_t count = 0;

        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            std::string by(self.caller.name());
            visit(FieldInfo{.key = "by", .unit = "", .meaning = "the interaction that added, or \"level\""},
                  by);
            visit(FieldInfo{.key = "count", .unit = "", .meaning = "how often"}, self.count);
        }
        friend bool operator==(Entry const&, Entry const&) = default;
    };

    CallerCounts() = default;
    CallerCounts(CallerCounts const& other);
    CallerCounts& operator=(CallerCounts const& other);
    CallerCounts(CallerCounts&&) noexcept = default;
    CallerCounts& operator=(CallerCounts&&) noexcept = default;
    ~CallerCounts() = default;

    /// How often that caller has added; never below zero.
    [[nodiscard]] std::int32_t of(CallerId caller) const;
    /// Whether anybody has.
    [[nodiscard]] bool any() const { return first_.count > 0; }
    /// Those with a count above zero, ascending by caller.
    [[nodiscard]] std::vector<Entry> entries() const;
    /// The names of those callers, in that order, for people: "level, Electricity <- Dynamics".
    [[nodiscard]] std::string names() const;

    /// All that one caller has to say at one time, added up. What is left is at least 0 and at most 2^31 - 1.
    void add(CallerId caller, std::int64_t change);
    /// Whether all that was added is by the level or by callers among `present` (ascending).
    [[nodiscard]] bool onlyBy(std::span<CallerId const> present) const;
    /// Drops the rest: those who added it are gone, so they can never take it back.
    void keepOnly(std::span<CallerId const> present);

    /// Hashes who has added how often, by the callers' names.
    void hash(StateHash& hash) const;

    friend bool operator==(CallerCounts const& x, CallerCounts const& y);

private:
    void assign(std::vector<Entry> entries);

    Entry first_;                              // of the lowest caller; its count is 0 if there is none
    std::unique_ptr<std::vector<Entry>> rest_; // ascending; mostly nothing
};

} // namespace trembler
