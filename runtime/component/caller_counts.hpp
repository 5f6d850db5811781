// The counts of one key of a counted set (5.7.2): how often each caller has added it.
#pragma once

#include "runtime/component/caller_id.hpp"
#include "runtime/property/description.hpp"

#include <memory>
#include <span>
#include <string>
#include <vector>

namespace trembler {

class StateHash;

/// The key is in the set while any caller's count is above zero. A removal lowers the
/// remover's own count only, and not below zero. Usually there is one caller, for which nothing is allocated.
/// Reads are thread-safe while nothing changes it.
class CallerCounts {
public:
    struct Entry {
        CallerId caller;
        std::int32_t count = 0;

        template <class Self, class Visitor>
        static void describe(Self& self, Visitor&& visit) {
            std::string by(self.caller.name());
            visit(FieldInfo{.key = "by",
                            .unit = "",
                            .meaning = "the interaction that added them, or \"level\""},
                  by);
            visit(FieldInfo{.key = "count", .unit = "", .meaning = "number of additions minus removals"},
                  self.count);
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
    /// Whether any caller's count is above zero.
    [[nodiscard]] bool any() const { return first_.count > 0; }
    /// The callers with a count above zero, ascending by caller.
    [[nodiscard]] std::vector<Entry> entries() const;
    /// The names of those callers, in that order, for people: "level, Electricity <- Dynamics".
    [[nodiscard]] std::string names() const;

    /// Adds `change` to the caller's count: all its additions and removals of one turn, summed. The count
    /// stays within 0 and 2^31 - 1.
    void add(CallerId caller, std::int64_t change);
    /// Whether only the level and callers among `present` (ascending) have counts above zero.
    [[nodiscard]] bool onlyBy(std::span<CallerId const> present) const;
    /// Drops the counts of all other callers: these callers no longer exist, so they can never remove the
    /// keys that they added.
    void keepOnly(std::span<CallerId const> present);

    /// Hashes the counts with the names of their callers.
    void hash(StateHash& hash) const;

    friend bool operator==(CallerCounts const& x, CallerCounts const& y);

private:
    void assign(std::vector<Entry> entries);

    Entry first_; // of the first caller in order; its count is 0 if there is none
    std::unique_ptr<std::vector<Entry>> rest_; // ascending; usually null
};

} // namespace trembler
