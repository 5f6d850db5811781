#include "runtime/level/build/property_bytes.hpp"

#include "runtime/property/field_visitor.hpp"

namespace trembler {
namespace {

class HeldBytes final : public FieldVisitor {
public:
    void boolean(FieldInfo const&, bool&) override { count(sizeof(double)); }
    void integer(FieldInfo const&, std::int32_t&) override { count(sizeof(double)); }
    void number(FieldInfo const&, double&) override { count(sizeof(double)); }
    void vector(FieldInfo const&, Vec2&) override { count(sizeof(Vec2)); }
    void text(FieldInfo const&, std::string& text) override {
        count(container);
        held += text.size();
    }
    void object(FieldInfo const&, ObjectId&) override { count(sizeof(ObjectId)); }
    void choice(FieldInfo const&, ChoiceField) override { count(sizeof(double)); }
    void list(FieldInfo const&, ListField& list) override {
        count(container);
        ++depth_;
        for (std::size_t i = 0; i < list.size(); ++i) {
            list.visitElement(i, *this);
        }
        --depth_;
    }

    std::size_t held = 0;

private:
    static constexpr std::size_t container = 32;

    /// The fields of the value itself are in it.
    void count(std::size_t bytes) { held += depth_ > 0 ? bytes : 0; }

    int depth_ = 0;
};

} // namespace

std::size_t heldBytes(PropertyValue& value) {
    HeldBytes counter;
    value.visit(counter);
    return counter.held;
}

bool PropertyAllowance::take(PropertySet& properties) {
    for (PropertySet::Entry const& entry : properties.entries()) {
        if (entry.value && taken_ <= most_) {
            taken_ += heldBytes(*entry.value);
        }
    }
    return taken_ <= most_;
}

} // namespace trembler
