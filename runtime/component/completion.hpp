// Properties that an effect adds to an object that has just received its stated properties: properties that
// follow from these (a mass from a density) and others that a simulation needs (a velocity). A completion has
// access to exactly the properties that it declares to read and add.
#pragma once

#include "runtime/component/declarations.hpp"
#include "runtime/world/store.hpp"

#include <span>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace trembler {

/// Object properties that a completion gives to the object that it completes.
template <ObjectProperty... P>
struct Adds {};

/// The words of a completion.
struct CompletionText {
    std::string_view name; ///< for example "Body"; its title is "Body Completion"
    std::string_view work; ///< its work on complete()
};

/// One completion type, as registered.
struct CompletionInfo {
    std::type_index type;
    CompletionText text;
    std::vector<PropertyInfo const*> reads{};
    std::vector<PropertyInfo const*> adds{};
    std::vector<PropertyInfo const*> neededAll{}; ///< it completes objects with all of these ...
    std::vector<PropertyInfo const*> neededAny{}; ///< ... or with at least one of these
    Store::Completion run = nullptr;
};
/// "Body Completion".
[[nodiscard]] std::string title(CompletionInfo const& info);

namespace detail {

template <class List>
inline constexpr bool isAdds = false;
template <class... P>
inline constexpr bool isAdds<Adds<P...>> = true;

template <class List, class Other>
inline constexpr bool disjoint = false;
template <template <class...> class List, class... P, class Other>
inline constexpr bool disjoint<List<P...>, Other> = (!listed<P, Other> && ...);

template <class... P>
[[nodiscard]] bool isActivatedBy(Store const& store, ObjectId id, NeedsAll<P...> const&) {
    return (store.has<P>(id) && ...);
}
template <class... P>
[[nodiscard]] bool isActivatedBy(Store const& store, ObjectId id, NeedsAny<P...> const&) {
    return (store.has<P>(id) || ...);
}

} // namespace detail

/// Base of every completion. `Self` has `static constexpr CompletionText text`, `using Activation = ...`
/// (which objects it completes), `static void complete(Access&)`, and no data, so objects are completed
/// independently of each other.
///
/// Stated values are never overwritten: add() leaves a value that the object already has, whether a level
/// file or a part states it. Each completion completes all objects that are created at the same time before
/// the next completion runs, and completions that add a property run before completions that read it. So
/// neither the order of objects nor that of registration matters.
template <class Self, class ReadsList, class AddsList>
class Completion {
    static_assert(detail::isReads<ReadsList> && detail::isAdds<AddsList>,
                  "a completion must declare Reads<...>, Adds<...>, in this order");
    static_assert(
        detail::onlyObjectProperties<ReadsList>,
        "a completion may read object properties only: no component has run when an object is created");
    static_assert(detail::disjoint<AddsList, ReadsList>,
                  "a completion must not read a property that it adds: the values of other objects would "
                  "depend on the order of creation");

public:
    /// Access to one object that is being completed.
    class Access final {
    public:
        [[nodiscard]] ObjectId object() const { return object_; }
        /// The object's value, or nullptr if it has none.
        template <class P>
        [[nodiscard]] P const* find() const {
            return find<P>(object_);
        }
        /// The value of another object, for example of one that a joint connects; nullptr if it has none.
        template <class P>
        [[nodiscard]] P const* find(ObjectId other) const {
            static_assert(detail::listed<P, ReadsList>,
                          "undeclared read: the property is not in Reads<> of this completion");
            return std::get<Column<P> const*>(columns_.read)->find(other);
        }
        /// Whether the object has a property that the completion declares to read or to add.
        template <class P>
        [[nodiscard]] bool has() const {
            static_assert(
                detail::listed<P, ReadsList> || detail::listed<P, AddsList>,
                "undeclared read: the property is in neither Reads<> nor Adds<> of this completion");
            if constexpr (detail::listed<P, AddsList>) {
                auto const& added = std::get<Addition<P>>(columns_.added);
                return added.column->has(object_) || (!added.ids.empty() && added.ids.back() == object_);
            } else {
                return std::get<Column<P> const*>(columns_.read)->has(object_);
            }
        }
        /// Gives the object the property, unless it has it already.
        template <class P>
        void add(P value) {
            static_assert(detail::listed<P, AddsList>,
                          "undeclared addition: the property is not in Adds<> of this completion");
            if (!has<P>()) {
                auto& added = std::get<Addition<P>>(columns_.added);
                added.ids.push_back(object_);
                added.values.push_back(std::move(value));
            }
        }

    private:
        friend Completion;
        /// The additions to one column: inserted together at the end, as single insertions would be
        /// quadratic.
        template <class P>
        struct Addition {
            Column<P>* column;
            std::vector<ObjectId> ids{};
            std::vector<P> values{};
        };
        template <class List>
        struct Pointers;
        template <class... P>
        struct Pointers<Reads<P...>> {
            using Type = std::tuple<Column<P> const*...>;
            static Type of(Store& store) { return {&store.column<P>()...}; }
        };
        template <class... P>
        struct Pointers<Adds<P...>> {
            using Type = std::tuple<Addition<P>...>;
            static Type of(Store& store) { return {Addition<P>{&store.column<P>()}...}; }
            static void carryOut(Type& additions) {
                (std::get<Addition<P>>(additions).column->addMany(
                     std::get<Addition<P>>(additions).ids,
                     std::move(std::get<Addition<P>>(additions).values)),
                 ...);
            }
        };
        struct Columns {
            typename Pointers<ReadsList>::Type read;
            typename Pointers<AddsList>::Type added;
        };
        Access(Columns& columns, ObjectId object) : columns_(columns), object_(object) {}

        Columns& columns_;
        ObjectId object_;
    };

    [[nodiscard]] static CompletionInfo const& describeSelf() {
        static_assert(std::is_empty_v<Self>, "a completion must have no data members");
        static_assert(
            requires(Access & access) { Self::complete(access); },
            "a completion must define 'static void complete(Access&)', and access properties through it "
            "only");
        static_assert(detail::disjoint<AddsList, typename Self::Activation>,
                      "a completion must not be activated by a property that it adds");
        static CompletionInfo const info = [] {
            CompletionInfo made{.type = typeid(Self), .text = Self::text};
            made.reads = detail::infos(ReadsList{});
            made.adds = detail::infos(AddsList{});
            copyNeeds(typename Self::Activation{}, made);
            made.run = [](Store& store, std::span<ObjectId const> objects) {
                typename Access::Columns columns{Access::template Pointers<ReadsList>::of(store),
                                                 Access::template Pointers<AddsList>::of(store)};
                for (ObjectId const object : objects) { // ascending, see Store::complete()
                    if (detail::isActivatedBy(store, object, typename Self::Activation{})) {
                        Access access(columns, object);
                        Self::complete(access);
                    }
                }
                Access::template Pointers<AddsList>::carryOut(columns.added);
            };
            return made;
        }();
        return info;
    }

private:
    template <class... P>
    static void copyNeeds(NeedsAll<P...> const&, CompletionInfo& info) {
        info.neededAll = {&propertyInfo<P>()...};
    }
    template <class... P>
    static void copyNeeds(NeedsAny<P...> const&, CompletionInfo& info) {
        info.neededAny = {&propertyInfo<P>()...};
    }
};

namespace detail {

/// The description that the base class of a completion makes. A class that is not derived from it has none,
/// even if it has a function called describeSelf().
template <class Self, class ReadsList, class AddsList>
[[nodiscard]] CompletionInfo const& describeCompletion(Completion<Self, ReadsList, AddsList> const*) {
    return Completion<Self, ReadsList, AddsList>::describeSelf();
}

template <class C>
concept DerivedFromCompletion = requires(C const* c) {
    detail::describeCompletion(c);
};

} // namespace detail

/// The order in which completions run: a completion that adds a property before the completions that read or
/// need the property, otherwise as registered. Throws RuleBroken, naming the completions, if there is no such
/// order, if two add the same property (the first would win), or if two have the same name.
[[nodiscard]] std::vector<CompletionInfo const*>
completionOrder(std::span<CompletionInfo const* const> completions);

} // namespace trembler
