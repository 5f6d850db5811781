// What the objects of a level hold in their properties has a bound.
#include "runtime/level/build/property_bytes.hpp"
#include "runtime/level/property/property_set.hpp"
#include "tests/runtime/level/sample_properties.hpp"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace trembler {
namespace property_bytes_test {
namespace {

std::size_t bytesOf(sample::Cake value) {
    ValueOf<sample::Cake> cake(std::move(value));
    return heldBytes(cake);
}

sample::Cake withNote(std::size_t bytes) {
    sample::Cake cake;
    cake.note = std::string(bytes, 'x');
    return cake;
}

TEST(PropertyBytes, GrowWithTextsAndLists) {
    std::size_t const none = bytesOf(withNote(0));
    EXPECT_LT(none, 200U);
    EXPECT_EQ(bytesOf(withNote(300)), none + 300);
    sample::Cake cake = withNote(0);
    cake.guests.resize(1000);
    EXPECT_EQ(bytesOf(cake), none + 1000 * sizeof(ObjectId));
    cake.guests.clear();
    sample::Topping topping;
    topping.spots.resize(50);
    cake.toppings.assign(10, topping);
    EXPECT_GE(bytesOf(cake), none + 10 * (50 * sizeof(Vec2) + sizeof(double)));
    EXPECT_LE(bytesOf(cake), none + 10 * (50 * sizeof(Vec2) + 2 * sizeof(topping)));
}

TEST(PropertyBytes, AreTakenFromAnAllowanceUntilItIsUsedUp) {
    PropertySet properties;
    properties.set(withNote(300));
    std::size_t const each = bytesOf(withNote(300));
    PropertyAllowance allowance(10 * each);
    for (int i = 0; i < 10; ++i) {
        EXPECT_TRUE(allowance.take(properties)) << i;
    }
    PropertySet nothing;
    EXPECT_TRUE(allowance.take(nothing));
    EXPECT_FALSE(allowance.take(properties));
    EXPECT_FALSE(allowance.take(nothing)) << "it stays used up";
}

} // namespace
} // namespace property_bytes_test
} // namespace trembler
