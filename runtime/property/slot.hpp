// The storage of a resolver property or a derived property. The world owns it, not the component that writes
// it, so another component that offers the same properties can take over without effect on the readers.
#pragma once

#include "runtime/property/news.hpp"
#include "runtime/property/property_info.hpp"
#include "runtime/property/state_hash.hpp"

#include <cstdint>
#include <optional>

namespace trembler {

class SlotBase {
public:
    explicit SlotBase(PropertyInfo const& info) : info_(info) {}
    virtual ~SlotBase() = default;
    SlotBase(SlotBase const&) = delete;
    SlotBase& operator=(SlotBase const&) = delete;

    [[nodiscard]] PropertyInfo const& info() const { return info_; }
    [[nodiscard]] std::uint64_t version() const { return version_; }
    /// Where it is kept, for its life.
    [[nodiscard]] std::uint64_t const* versionPlace() const { return &version_; }
    void touch() { ++version_; }
    /// How many constructed components and subscriptions read it. At 0, its provider need not compute it.
    [[nodiscard]] int readers() const { return ownReaders_ + onlookers_; }
    /// Of these, the number of components that the scene itself needs. It follows from the world's state,
    /// unlike subscriptions and components constructed for subscriptions only, which must not affect the
    /// world.
    [[nodiscard]] int ownReaders() const { return ownReaders_; }
    void setReaders(int own, int onlookers) {
        ownReaders_ = own;
        onlookers_ = onlookers;
    }
    /// Sets the initial value when no component provides the property any more.
    virtual void reset() = 0;
    /// Whether it reports news (see ReportsNews), which must be gathered in frames of several parts.
    [[nodiscard]] virtual bool reportsNews() const { return false; }
    /// To be called when a frame begins: discards the news gathered in the last frame.
    virtual void beginFrame() {}
    /// To be called after each part of a frame of several parts: adds its news, if the property was written
    /// in it.
    virtual void endPart(double /* begin, s */, double /* share */) {}
    /// Visits a copy of ofFrame(), so that the visitor can change nothing.
    virtual void visitCopy(FieldVisitor& visitor) const = 0;
    /// Visits a copy of the current value, which components read: of a part of a frame.
    virtual void visitCurrent(FieldVisitor& visitor) const = 0;
    /// The current value; see PropertyInfo::fields.
    [[nodiscard]] virtual void const* data() const = 0;
    /// Hashes the value, unless the property is always left out.
    virtual void hash(StateHash& hash) const = 0;

private:
    PropertyInfo const& info_;
    std::uint64_t version_ = 1;
    int ownReaders_ = 0;
    int onlookers_ = 0;
};

template <Property P>
class Slot final : public SlotBase {
public:
    Slot() : SlotBase(propertyInfo<P>()) {}
    [[nodiscard]] P& value() { return value_; }
    [[nodiscard]] P const& value() const { return value_; }
    /// The value for observers of whole frames: the news of all parts of the last frame, if the property
    /// reports news and the frame had several parts, else the current value.
    [[nodiscard]] P const& ofFrame() const {
        if constexpr (ReportsNews<P>) {
            if (gathered_) {
                return *gathered_;
            }
        }
        return value_;
    }
    void reset() override {
        value_ = P{};
        touch();
    }
    [[nodiscard]] bool reportsNews() const override { return ReportsNews<P>; }
    void beginFrame() override {
        gathered_.reset();
        seen_ = version();
    }
    void endPart(double begin, double share) override {
        if constexpr (ReportsNews<P>) {
            if (version() == seen_) {
                return; // not written in this part, so it has no news
            }
            seen_ = version();
            bool const first = !gathered_;
            if (first) {
                gathered_.emplace();
            }
            P::gather(*gathered_, value_, {.first = first, .begin = begin, .share = share});
        }
    }
    void visitCopy(FieldVisitor& visitor) const override {
        P copy = ofFrame();
        visitFields(copy, visitor);
    }
    void visitCurrent(FieldVisitor& visitor) const override {
        P copy = value_;
        visitFields(copy, visitor);
    }
    [[nodiscard]] void const* data() const override { return &value_; }
    void hash(StateHash& hash) const override {
        if constexpr (coverageOf<P>().kind != Coverage::Kind::leftOut) {
            hash.members(value_);
        }
    }

private:
    struct Nothing {};
    using Gathered = std::conditional_t<ReportsNews<P>, P, Nothing>;

    P value_;
    std::optional<Gathered> gathered_; // in a frame of several parts, once it has been written in one of them
    std::uint64_t seen_ = 0;           // the version that was gathered last
};

} // namespace trembler
