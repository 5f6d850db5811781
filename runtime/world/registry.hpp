// All properties and components of a program. Each effect registers its own with one line.
#pragma once

#include "runtime/component/completion.hpp"
#include "runtime/component/component.hpp"
#include "runtime/component/dps.hpp"
#include "runtime/component/interaction.hpp"
#include "runtime/component/resolver.hpp"
#include "runtime/component/rule_broken.hpp"

#include <atomic>
#include <cstddef>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace trembler {

/// One registered component type.
struct Registration {
    ComponentInfo const* info;
    std::function<std::unique_ptr<Component>()> make;
    bool (*suits)(Store const&); ///< whether this detail level can serve a scene; nullptr: any scene
    int period = 1;              ///< runs in every nth frame (6.12.5)
    /// The longest period with which it computes the same physics, less exactly: a force that is held for
    /// several frames. For a component that must not miss a frame it equals `period`.
    int longestPeriod = 1;
    /// Whether this detail level computes the physics that a scene states, however roughly: levels that do
    /// differ in accuracy only. nullptr: in any scene.
    bool (*faithful)(Store const&) = nullptr;
    std::string_view missing{}; ///< why this program cannot construct it, and how to get it; empty if it can
    std::string (*why)(Store const&) = nullptr; ///< in words, why a scene needs its detail level
    /// The property that it offers but always leaves empty, because only other detail levels compute it.
    PropertyInfo const* leftEmpty = nullptr;
};

/// An interaction that runs inside a derived property set (5.7.3).
struct Shortcut {
    std::type_index interaction;
    std::type_index dps;
};

/// An error in an object and the expected condition, in words.
struct ObjectFault {
    ObjectId object;
    std::string text;
};

/// A condition on an object as stated by a file, before its completion: for example that a polygon is convex.
/// It has one of the two functions.
struct ObjectRule {
    PropertyInfo const* property; ///< the property whose entry in the file is wrong
    /// Checks an object that has the property; returns the error and the expected condition, in words, or
    /// nothing.
    std::function<std::optional<std::string>(Store const&, ObjectId)> check = nullptr;
    /// For a condition that compares objects with each other: checks all objects that have the property at
    /// once, so that its cost need not grow with the square of their number. Returns at most one fault for
    /// each object, ascending by object.
    std::vector<ObjectFault> (*checkAll)(Store const&) = nullptr;
};

/// A kind of a level's "connections" and the effect that makes them. A connection belongs to the effect whose
/// kind it states or, if it states none, to the only effect that does not refuse the two objects.
struct Connector {
    std::string_view kind;   ///< as files spell it, for example "wire"; belongs to one effect only
    std::string_view effect; ///< the effect that it belongs to
    std::string_view meaning;
    /// Why two objects cannot be connected in this way and the expected condition, in words, or nothing.
    /// Either id may be invalid.
    std::optional<std::string> (*refusal)(Store const&, ObjectId, ObjectId);
    /// Connects two objects that refusal() accepts, before the first frame; the order of calls does not
    /// matter.
    void (*lay)(Store&, ObjectId, ObjectId);
};

namespace detail {

/// A count for one registry, which a copy of the registry begins at zero. Threads may read and write it at
/// once.
class UncopiedCount {
public:
    UncopiedCount() = default;
    ~UncopiedCount() = default;
    UncopiedCount(UncopiedCount const& /*other*/) {}
    UncopiedCount(UncopiedCount&& /*other*/) noexcept {}
    UncopiedCount& operator=(UncopiedCount const& /*other*/) {
        value = 0;
        return *this;
    }
    UncopiedCount& operator=(UncopiedCount&& /*other*/) noexcept {
        value = 0;
        return *this;
    }
    std::atomic<std::size_t> value = 0;
};

} // namespace detail

/// The order of registration is part of the simulation: conflicting resolvers run, and calls are drained, in
/// this order.
class Registry {
public:
    /// Registers an object property that no component declares.
    template <ObjectProperty P>
    void property() {
        know(propertyInfo<P>());
    }
    /// Makes known all that a level may state for the components of `other`: their object properties, and the
    /// kinds of connections, which then connect nothing. For an effect that is left out.
    void makeKnown(Registry const& other);
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
        if constexpr (requires { typename C::LeavesEmpty; }) {
            made.leftEmpty = &propertyInfo<typename C::LeavesEmpty>();
        }
        if constexpr (requires { C::period; }) {
            made.period = C::period;
        }
        made.longestPeriod = made.period;
        if constexpr (requires { C::longestPeriod; }) {
            made.longestPeriod = C::longestPeriod;
        }
        if constexpr (requires(Store const& store) { C::faithful(store); }) {
            made.faithful = [](Store const& store) { return C::faithful(store); };
        }
        if constexpr (requires { C::missing; }) {
            made.missing = C::missing;
        }
        add(made);
    }
    /// Registers one of several components of a C++ type that differ by the value `variant`, which must
    /// outlive the registry. `variant` has the member `text`, and may have `suits` and `missing`, as a
    /// component type has. C has no `text` and is constructed with (ComponentInfo const&, variant).
    template <class C, class Variant>
    void component(Variant const& variant) {
        auto const info = std::make_shared<ComponentInfo const>(C::describeAs(variant.text));
        Registration made{
            info.get(),
            [info, &variant] { return std::unique_ptr<Component>(std::make_unique<C>(*info, variant)); },
            nullptr};
        if constexpr (requires { variant.suits; }) {
            made.suits = variant.suits;
        }
        if constexpr (requires { variant.missing; }) {
            made.missing = variant.missing;
        }
        add(made);
    }
    template <class C, class Variant>
    void component(Variant const&&) = delete; // a temporary would not outlive the registry
    /// A component whose description was made while the program runs. `made.info` must live as long as
    /// `made.make`, for example by being owned by that function.
    void component(Registration const& made) { add(made); }
    /// Registers the name of an extension: a set of components that a level can state as a requirement.
    void extension(std::string name) { extensions_.push_back(std::move(name)); }
    /// In order of registration.
    [[nodiscard]] std::span<std::string const> extensions() const { return extensions_; }
    /// Runs `I` directly after `X` has updated, inside the same task. Checked at start. Several shortcuts of
    /// one `I` must be in alternatives.
    template <class I, class X>
    void shortcut() {
        shortcuts_.push_back({typeid(I), typeid(X)});
    }

    /// Adds a completion, a class derived from Completion that gives properties to new objects.
    template <class C>
    void completion() {
        static_assert(detail::DerivedFromCompletion<C>,
                      "a completion must be derived from Completion<Self, Reads<...>, Adds<...>>");
        if constexpr (detail::DerivedFromCompletion<C>) {
            add(detail::describeCompletion(static_cast<C const*>(nullptr)));
        }
    }
    /// Adds a condition that files must meet beyond the ranges of single fields; see ObjectRule.
    void rule(ObjectRule rule) { rules_.push_back(std::move(rule)); }

    /// In order of registration; see completionOrder() for the order in which they run.
    [[nodiscard]] std::span<CompletionInfo const* const> completions() const { return completions_; }
    [[nodiscard]] std::span<ObjectRule const> rules() const { return rules_; }
    /// Adds a kind of connections that a level may state; the runtime itself has none.
    void connector(Connector const& connector) { connectors_.push_back(connector); }
    [[nodiscard]] std::span<Connector const> connectors() const { return connectors_; }
    /// The kinds of connections, in alphabetical order.
    [[nodiscard]] std::vector<std::string> connectionKinds() const;
    [[nodiscard]] std::span<Registration const> components() const { return components_; }
    [[nodiscard]] std::span<Shortcut const> shortcuts() const { return shortcuts_; }
    /// Every known object property, in order of its key.
    [[nodiscard]] std::vector<PropertyInfo const*> objectProperties() const;
    /// The object property with that key, or nullptr.
    [[nodiscard]] PropertyInfo const* objectProperty(std::string_view key) const;
    /// Throws RuleBroken if any rule is broken: double writers, alternatives that offer only partly the same
    /// properties, two components of one name, two properties of one key, two effects with one kind of
    /// connections, invalid shortcuts, completions without an order. Every world calls it as it starts, and
    /// several threads may; a registry that has passed is checked again only after another registration.
    void check() const;

private:
    void add(Registration const& made);
    void add(CompletionInfo const& info);
    void know(PropertyInfo const& info);
    void checkAll() const;
    [[nodiscard]] std::size_t registrations() const;

    std::vector<Registration> components_;
    std::vector<PropertyInfo const*> properties_;
    std::vector<Shortcut> shortcuts_;
    std::vector<CompletionInfo const*> completions_;
    std::vector<ObjectRule> rules_;
    std::vector<Connector> connectors_;
    std::vector<std::string> extensions_;
    /// How many registrations had passed the last check; nothing is ever removed. A search starts thousands
    /// of worlds, and comparing all pairs of components takes nearly as long as the rest of a start.
    mutable detail::UncopiedCount checked_;
};

/// True if two registered components serve the same need, so that a world constructs one of them: resolvers
/// of one role, or derived property sets that offer the same.
[[nodiscard]] bool areAlternatives(ComponentInfo const& a, ComponentInfo const& b);

} // namespace trembler
