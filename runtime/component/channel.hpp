// Passes calls from the interactions of a role, and from outside the world, to the role's resolver.
#pragma once

#include "runtime/component/call_source.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace trembler {

class ChannelBase {
public:
    virtual ~ChannelBase() = default;
    [[nodiscard]] virtual std::uint64_t version() const = 0;
    virtual void clearOnce() = 0;
    virtual void clearSources() = 0;
};

/// Connects the interactions of one role to its resolver: holds their sources in registration order, the
/// order in which calls are drained. Calls from outside come before those of interactions.
template <ResolverRole Role>
class Channel final : public ChannelBase {
public:
    void add(CallSource<Role>* source) {
        sources_.push_back(source);
        cleared_.push_back(0);
        noted_.push_back(0);
        hadCalls_.push_back(false);
        callers_.push_back(source->caller);
        ++changes_;
    }
    /// To be called when a resolver is bound: from then on, calls from outside are recorded.
    void attachResolver() { resolverThere_ = true; }
    void clearSources() override {
        sources_.clear();
        cleared_.clear();
        noted_.clear();
        hadCalls_.clear();
        withCalls_.clear();
        callers_.clear();
        resolverThere_ = false;
        ++changes_;
        if (outside_) {
            add(outside_.get());
        }
    }
    [[nodiscard]] std::span<CallSource<Role>* const> sources() const { return sources_; }
    /// The callers of the sources: ascending if the sources were added in registration order.
    [[nodiscard]] std::span<CallerId const> callers() const { return callers_; }

    /// Accepts calls from outside, with that identity. To be called once, before any source is added.
    void openToOutside(CallerId caller) requires FedFromOutside<Role> {
        outside_ = std::make_unique<CallSource<Role>>();
        outside_->caller = caller;
        add(outside_.get());
    }
    /// Records a call from outside for the next advance. Between frames only. Without a resolver, or before
    /// openToOutside(), the call is lost.
    template <InteractionCall C>
    void feed(C const& call) requires FedFromOutside<Role> {
        static_assert(detail::callListed<C, typename Role::Calls>, "the call is not in Calls of this role");
        if (resolverThere_ && outside_) {
            std::get<CallBuffer<C>>(outside_->chunks.front()).push(call);
            ++outside_->version;
        }
    }
    /// Whether no source has a call.
    [[nodiscard]] bool empty() const {
        return std::all_of(sources_.begin(), sources_.end(),
                           [](CallSource<Role> const* source) { return source->empty(); });
    }

    /// Changes whenever a source has made or withdrawn calls or the set of sources has changed. Changes of
    /// the set are counted in separate bits: a removed source no longer contributes to the sum, which could
    /// then equal an earlier one.
    [[nodiscard]] std::uint64_t version() const override {
        std::uint64_t sum = changes_ << 40U;
        for (CallSource<Role> const* source : sources_) {
            sum += source->version;
        }
        return sum;
    }
    void clearOnce() override {
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i]->version != cleared_[i]) { // otherwise it has made no call since
                cleared_[i] = sources_[i]->version;
                sources_[i]->clearOnce();
            }
        }
    }
    /// Hashes every recorded call with its caller's name, independently of the order of registration.
    void hash(StateHash& hash) const {
        std::vector<CallSource<Role> const*> sorted(sources_.begin(), sources_.end());
        std::sort(sorted.begin(), sorted.end(),
                  [](auto const* a, auto const* b) { return a->caller.name() < b->caller.name(); });
        for (CallSource<Role> const* source : sorted) {
            if (!source->empty()) {
                hash.value(std::string(source->caller.name()));
                source->hash(hash);
            }
        }
    }
    /// Calls f(call, origin) for every call of kind C, in drain order.
    template <InteractionCall C, class F>
    void forCalls(F&& f) const {
        drain<C>(sources_, std::forward<F>(f));
    }
    /// Notes which sources have calls. To be called before an advance: in it, no call is made. Looks only at
    /// sources that have made or withdrawn calls since the last time.
    void noteSourcesWithCalls() {
        bool changed = false;
        for (std::size_t i = 0; i < sources_.size(); ++i) {
            if (sources_[i]->version != noted_[i]) {
                noted_[i] = sources_[i]->version;
                bool const hasCalls = !sources_[i]->empty();
                changed = changed || hasCalls != hadCalls_[i];
                hadCalls_[i] = hasCalls;
            }
        }
        if (changed) {
            withCalls_.clear();
            for (std::size_t i = 0; i < sources_.size(); ++i) {
                if (hadCalls_[i]) {
                    withCalls_.push_back(sources_[i]);
                }
            }
        }
    }
    /// The same as forCalls() after noteSourcesWithCalls(), without a look at the sources that have no calls:
    /// most interactions sleep, and a resolver goes through its sources once for each kind of call.
    template <InteractionCall C, class F>
    void forNotedCalls(F&& f) const {
        drain<C>(withCalls_, std::forward<F>(f));
    }
    /// The sources that had calls when noteSourcesWithCalls() looked at them last, in drain order.
    [[nodiscard]] std::span<CallSource<Role>* const> sourcesWithCalls() const { return withCalls_; }

private:
    template <InteractionCall C, class F>
    static void drain(std::span<CallSource<Role>* const> sources, F&& f) {
        for (CallSource<Role> const* source : sources) {
            CallerId const caller = source->caller;
            for (auto const& chunk : source->chunks) {
                auto const& buffer = std::get<CallBuffer<C>>(chunk);
                std::span<C const> const calls = buffer.calls();
                for (std::size_t i = 0; i < calls.size(); ++i) {
                    f(calls[i], CallOrigin{caller, buffer.cause(i)});
                }
            }
        }
    }

    std::vector<CallSource<Role>*> sources_;
    std::vector<CallerId> callers_;      // of sources_
    std::vector<std::uint64_t> cleared_; // of sources_: their versions when their calls were cleared last
    std::vector<std::uint64_t> noted_;   // of sources_: their versions when they were looked at last
    std::vector<bool> hadCalls_;         // of sources_: whether they had calls at that time
    std::vector<CallSource<Role>*> withCalls_; // the sources that had calls at that time
    std::unique_ptr<CallSource<Role>> outside_;
    bool resolverThere_ = false;
    std::uint64_t changes_ = 1;
};

} // namespace trembler
