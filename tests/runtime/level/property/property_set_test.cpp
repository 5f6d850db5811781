// A set of stated properties, against a map from keys to values.
#include "runtime/level/property/property_set.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include <map>
#include <optional>

namespace trembler {
namespace property_set_test {
namespace {

using sample::Cake;
using sample::Climate;
using sample::Knot;
using sample::Tag;
using sample::Weight;

/// The statement for each property: a weight's number, or only that it is present or excluded.
using Model = std::map<std::string, std::optional<double>>;

Model modelOf(PropertySet const& set) {
    Model model;
    std::string before;
    for (PropertySet::Entry const& entry : set.entries()) {
        std::string const key(entry.info->text.key);
        RC_ASSERT(before < key); // ascending, each once
        before = key;
        Weight const* const weight = entry.info == &propertyInfo<Weight>() ? set.find<Weight>() : nullptr;
        double const number = weight == nullptr ? 0 : weight->value;
        model[key] = entry.value == nullptr ? std::nullopt : std::optional(number);
    }
    return model;
}

template <class P>
void change(PropertySet& set, Model& model) {
    std::string const key(propertyInfo<P>().text.key);
    switch (*rc::gen::inRange(0, 3)) {
    case 0: {
        P value;
        double number = 0;
        if constexpr (std::is_same_v<P, Weight>) {
            number = value.value = *rc::gen::inRange(1, 100);
        }
        set.set(value);
        model[key] = number;
        break;
    }
    case 1:
        set.takeAway(propertyInfo<P>());
        model[key] = std::nullopt;
        break;
    default:
        set.erase(propertyInfo<P>());
        model.erase(key);
    }
    RC_ASSERT(set.states(propertyInfo<P>()) == model.contains(key));
    RC_ASSERT((set.find(propertyInfo<P>()) != nullptr) == (model.contains(key) && model[key].has_value()));
    RC_ASSERT((set.find<P>() != nullptr) == (set.find(propertyInfo<P>()) != nullptr));
}

TEST(PropertySet, IsAMapOfTheLastStatements) {
    EXPECT_TRUE(rc::check("the same as a map", [] {
        PropertySet set;
        Model model;
        for (int i = *rc::gen::inRange(0, 40); i > 0; --i) {
            switch (*rc::gen::inRange(0, 5)) {
            case 0:
                change<Weight>(set, model);
                break;
            case 1:
                change<Tag>(set, model);
                break;
            case 2:
                change<Cake>(set, model);
                break;
            case 3:
                change<Climate>(set, model);
                break;
            default:
                change<Knot>(set, model);
            }
            RC_ASSERT(modelOf(set) == model);
            RC_ASSERT(set.empty() == model.empty());
        }
    }));
}

TEST(PropertySet, CopiesAreIndependent) {
    PropertySet set;
    set.set(Weight{3});
    set.takeAway(propertyInfo<Tag>());
    PropertySet copy(set);
    static_cast<ValueOf<Weight>*>(copy.find(propertyInfo<Weight>()))->value.value = 5;
    copy.erase(propertyInfo<Tag>());
    EXPECT_EQ(set.find<Weight>()->value, 3);
    EXPECT_TRUE(set.states(propertyInfo<Tag>()));
    EXPECT_EQ(copy.find<Weight>()->value, 5);
    EXPECT_FALSE(copy.states(propertyInfo<Tag>()));
    copy = set;
    EXPECT_EQ(copy.find<Weight>()->value, 3);
    EXPECT_NE(copy.find<Weight>(), set.find<Weight>());
    PropertySet& same = copy;
    copy = same; // assigned to itself: unchanged
    EXPECT_EQ(copy.find<Weight>()->value, 3);
    EXPECT_EQ(copy.entries().size(), 2U);
    PropertySet const moved = std::move(copy);
    EXPECT_EQ(moved.entries().size(), 2U);
}

} // namespace
} // namespace property_set_test
} // namespace trembler
