// What exists: every property and component that a program knows. One line per effect fills it.
#pragma once

#include "runtime/component/component.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace trembler {

/// Thrown when components break the methodology's rules in a way that types alone cannot see; names them.
class RuleBroken : public std::logic_error {
public:
    using std::logic_error::logic_error;
};

/// One registered component type.
struct Registration {
    ComponentInfo const* info;
    std::unique_ptr<Component> (*make)();
    bool (*suits)(Store const&); ///< whether this detail level can serve a scene; nullptr: any scene
    int period = 1;              ///< runs in every nth frame (6.12.5)
    std::string_view missing{};  ///< why this program knows it only by name, and what helps; mostly nothing
    std::string (*why)(Store const&) = nullptr; ///< in words, what in a scene calls for which detail level
};

/// A declared hand-over (7.1.5): two resolvers may write one property, as every object belongs to one of them
/// at a time and is passed on between frames.
struct HandOver {
    PropertyInfo const* property;
    std::string first;
    std::string second;
    std::string why;
};

/// An interaction that runs inside a derived property set (5.7.3).
struct Shortcut {
    std::type_index interaction;
    std::type_index dps;
};

/// A condition on an object as stated by a file, before its completion: for example that a polygon is convex.
/// Checks an object that has the property; returns what is wrong and what was expected, in words, or nothing.
struct ObjectRule {
    PropertyInfo const* property; ///< whose entry in the file is at fault
    std::optional<std::string> (*check)(Store const&, ObjectId);
};

/// Takes over one of a level's "connections": lays it between two objects, before the first frame. Returns
/// what is wrong with it and what was expected, in words, or nothing.
using Connector = std::optional<std::string> (*)(Store&, ObjectId, ObjectId);

/// Order of registration is part of the simulation: conflicting resolvers run, and calls are drained, in it.
class Registry {
public:
    /// Makes an object property known although no component declares it.
    template <ObjectProperty P>
    void property() {
        know(propertyInfo<P>());
    }
    template <class C>
    void component() {
        Registration made{&C::describeSelf(),
                          [] { return std::unique_ptr<Component>(std::make_unique<C>()); }, nullptr};
        if constexpr (requires(Store const& store) { C::suits(store); }) {
            made.suits = [](Store const& store) { return C::suits(store); };
        }
        if constexpr (requires(Store const& store) { C::why(store); }) {
            made.why = [](Store const& store) { return std::string(C::why(store)); };
        }
        if constexpr (requires { C::period; }) {
            made.period = C::period;
        }
        if constexpr (requires { C::missing; }) {
            made.missing = C::missing;
        }
        add(made);
    }
    /// Runs `I` directly after `X` has updated, inside the same task. Checked at start. Several shortcuts of
    /// one `I` must be in alternatives.
    template <class I, class X>
    void shortcut() {
        shortcuts_.push_back({typeid(I), typeid(X)});
    }
    template <ObjectProperty P, class First, class Second>
    void handOver(std::string why) {
        handOvers_.push_back({&propertyInfo<P>(), std::string(First::text.name),
                              std::string(Second::text.name), std::move(why)});
    }

    /// Adds what an effect does to every new object; see Store::Completion.
    void completion(Store::Completion completion) { completions_.push_back(completion); }
    /// Adds a condition that files must meet beyond the ranges of single fields; see ObjectRule.
    void rule(ObjectRule rule) { rules_.push_back(rule); }

    [[nodiscard]] std::vector<Store::Completion> const& completions() const { return completions_; }
    [[nodiscard]] std::span<ObjectRule const> rules() const { return rules_; }
    /// Names the effect that understands a level's "connections"; the runtime does not.
    void connector(Connector connector) { connector_ = connector; }
    [[nodiscard]] Connector connector() const { return connector_; }
    [[nodiscard]] std::span<Registration const> components() const { return components_; }
    [[nodiscard]] std::span<HandOver const> handOvers() const { return handOvers_; }
    [[nodiscard]] std::span<Shortcut const> shortcuts() const { return shortcuts_; }
    /// Every known object property, in order of its key.
    [[nodiscard]] std::vector<PropertyInfo const*> objectProperties() const;
    /// The object property with that key, or nullptr.
    [[nodiscard]] PropertyInfo const* objectProperty(std::string_view key) const;
    /// Throws RuleBroken if any rule is broken: double writers, half-overlapping alternatives, two components
    /// of one name, two properties of one key, unlawful shortcuts.
    void check() const;

private:
    void add(Registration const& made);
    void know(PropertyInfo const& info);

    std::vector<Registration> components_;
    std::vector<PropertyInfo const*> properties_;
    std::vector<HandOver> handOvers_;
    std::vector<Shortcut> shortcuts_;
    std::vector<Store::Completion> completions_;
    std::vector<ObjectRule> rules_;
    Connector connector_ = nullptr;
};

/// True if two registered components serve the same need, so that a world constructs one of them: resolvers
/// of one role, or derived property sets that offer the same.
[[nodiscard]] bool areAlternatives(ComponentInfo const& a, ComponentInfo const& b);

} // namespace trembler
