// Where the value of a condition has selectors, areas and inner conditions, according to its JSON Schema.
#pragma once

#include <nlohmann/json.hpp>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace trembler {

/// How a kind of condition contains other conditions.
enum class InnerConditions : std::uint8_t {
    none,
    list,   ///< its value is a list of conditions
    value,  ///< its value is a condition
    member, ///< a member of its value is a condition
};

/// For code that changes conditions as text, such as the editor's, without knowing the kinds.
struct ConditionOutline {
    std::string key; ///< of the kind
    InnerConditions inner = InnerConditions::none;
    std::string member{};            ///< the key of the inner condition, for InnerConditions::member
    nlohmann::ordered_json schema{}; ///< of the value
};

/// Of every kind, in the order of conditionKinds(). Thread-safe.
[[nodiscard]] std::span<ConditionOutline const> conditionOutlines();
/// nullptr if there is no kind with that key.
[[nodiscard]] ConditionOutline const* findOutline(std::string_view key);

/// Whether a schema stands for a selector, an area, or a condition of any kind.
[[nodiscard]] bool isSelector(nlohmann::ordered_json const& schema);
[[nodiscard]] bool isArea(nlohmann::ordered_json const& schema);
[[nodiscard]] bool isCondition(nlohmann::ordered_json const& schema);

/// Calls `visit` with every selector in a condition and in its inner conditions. Values that do not have the
/// form of the schema are left out.
void forSelectors(nlohmann::ordered_json& condition,
                  std::function<void(nlohmann::ordered_json& selector)> const& visit);

/// The longest beginning of a place in `goals`, a JSON pointer, that is the place of a condition.
[[nodiscard]] std::string conditionAround(nlohmann::ordered_json const& goals, std::string const& place);

} // namespace trembler
