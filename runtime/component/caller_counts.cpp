#include "runtime/component/caller_counts.hpp"

#include "runtime/property/state_hash.hpp"

#include <algorithm>
#include <limits>

namespace trembler {
namespace {

std::int32_t changed(std::int32_t count, std::int64_t change) {
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    // The change is clamped first: a change far outside the range of counts could make the sum overflow.
    return static_cast<std::int32_t>(
        std::clamp<std::int64_t>(count + std::clamp<std::int64_t>(change, -most, most), 0, most));
}

bool isKnown(CallerCounts::Entry const& entry, std::span<CallerId const> present) {
    return entry.caller == CallerId::level() ||
           std::binary_search(present.begin(), present.end(), entry.caller);
}

} // namespace

CallerCounts::CallerCounts(CallerCounts const& other)
    : first_(other.first_),
      rest_(other.rest_ ? std::make_unique<std::vector<Entry>>(*other.rest_) : nullptr) {}

CallerCounts& CallerCounts::operator=(CallerCounts const& other) {
    if (this != &other) {
        first_ = other.first_;
        rest_ = other.rest_ ? std::make_unique<std::vector<Entry>>(*other.rest_) : nullptr;
    }
    return *this;
}

std::int32_t CallerCounts::of(CallerId caller) const {
    if (first_.caller == caller) {
        return first_.count;
    }
    if (rest_) {
        for (Entry const& entry : *rest_) {
            if (entry.caller == caller) {
                return entry.count;
            }
        }
    }
    return 0;
}

std::vector<CallerCounts::Entry> CallerCounts::entries() const {
    std::vector<Entry> all;
    if (any()) {
        all.push_back(first_);
    }
    if (rest_) {
        all.insert(all.end(), rest_->begin(), rest_->end());
    }
    return all;
}

std::string CallerCounts::names() const {
    std::string list;
    for (Entry const& entry : entries()) {
        list += (list.empty() ? "" : ", ") + std::string(entry.caller.name());
    }
    return list;
}

void CallerCounts::add(CallerId caller, std::int64_t change) {
    if (!rest_ && (!any() || first_.caller == caller)) { // by far the most frequent case
        first_.count = changed(first_.count, change);
        first_.caller = any() ? caller : CallerId();
        return;
    }
    if (!rest_ && change <= 0) {
        return; // a removal by a caller that has added none, while another caller has
    }
    std::vector<Entry> all = entries();
    auto at = std::lower_bound(all.begin(), all.end(), caller,
                               [](Entry const& entry, CallerId id) { return entry.caller < id; });
    if (at == all.end() || at->caller != caller) {
        at = all.insert(at, {caller, 0});
    }
    at->count = changed(at->count, change);
    assign(std::move(all));
}

bool CallerCounts::onlyBy(std::span<CallerId const> present) const {
    auto const known = [&](Entry const& entry) { return isKnown(entry, present); };
    return (!any() || known(first_)) && (!rest_ || std::all_of(rest_->begin(), rest_->end(), known));
}

void CallerCounts::keepOnly(std::span<CallerId const> present) {
    std::vector<Entry> all = entries();
    std::erase_if(all, [&](Entry const& entry) { return !isKnown(entry, present); });
    assign(std::move(all));
}

void CallerCounts::assign(std::vector<Entry> entries) {
    std::erase_if(entries, [](Entry const& entry) { return entry.count == 0; });
    first_ = entries.empty() ? Entry{} : entries.front();
    if (entries.size() < 2) {
        rest_.reset();
        return;
    }
    entries.erase(entries.begin());
    rest_ = std::make_unique<std::vector<Entry>>(std::move(entries));
}

void CallerCounts::hash(StateHash& hash) const {
    std::vector<Entry> const all = entries();
    hash.integer(all.size());
    for (Entry const& entry : all) {
        hash.value(std::string(entry.caller.name()));
        hash.value(entry.count);
    }
}

bool operator==(CallerCounts const& x, CallerCounts const& y) {
    return x.first_ == y.first_ && static_cast<bool>(x.rest_) == static_cast<bool>(y.rest_) &&
           (!x.rest_ || *x.rest_ == *y.rest_);
}

} // namespace trembler
