// Made-up components and scenes for tests of the selection: descriptions only, without code.
#pragma once

#include "runtime/world/selection.hpp"

#include <array>
#include <deque>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <typeindex>
#include <utility>
#include <vector>

namespace trembler::descriptions {

template <int>
struct NumberedRole {};

/// Describes components without C++ types. Properties are identified by name, roles by a number from 0 to 3.
class Descriptions {
public:
    using Names = std::vector<std::string>;
    struct Stated {
        std::string name;
        std::string level{};
        int rank = 0;
        Names needs{};    ///< objects with all of these
        Names needsAny{}; ///< objects with at least one of these
        Names
            reads{}; ///< resolver and derived properties; of object properties the names that begin with "o"
        Names offers{}; ///< resolver or derived properties
        int role = 0;   ///< of resolvers and interactions
        bool onDemand = false;
    };

    Descriptions() = default;
    Descriptions(Descriptions&&) = default; // a copy would point into the original
    Descriptions& operator=(Descriptions&&) = delete;

    std::size_t resolver(Stated const& stated) { return add(ComponentKind::resolver, stated); }
    std::size_t dps(Stated const& stated) { return add(ComponentKind::dps, stated); }
    std::size_t interaction(Stated const& stated) { return add(ComponentKind::interaction, stated); }

    [[nodiscard]] std::vector<ComponentInfo const*> list() const {
        std::vector<ComponentInfo const*> all;
        for (ComponentInfo const& info : infos_) {
            all.push_back(&info);
        }
        return all;
    }
    [[nodiscard]] PropertyInfo const* property(std::string const& name) {
        for (PropertyInfo const& known : properties_) {
            if (known.text.key == name) {
                return &known;
            }
        }
        return &properties_.emplace_back(PropertyInfo{
            .type = typeid(void),
            .kind = name.front() == 'o' ? PropertyKind::object : PropertyKind::resolver,
            .text = {keep(name), keep(name), ""},
            .makeColumn = nullptr,
            .makeSlot = nullptr,
            .makeValue = nullptr,
        });
    }

private:
    std::string_view keep(std::string const& text) { return texts_.emplace_back(text); }
    std::vector<PropertyInfo const*> properties(Names const& names) {
        std::vector<PropertyInfo const*> all;
        for (std::string const& name : names) {
            all.push_back(property(name));
        }
        return all;
    }
    std::size_t add(ComponentKind kind, Stated const& stated) {
        static std::array<std::type_index, 4> const roles{typeid(NumberedRole<0>), typeid(NumberedRole<1>),
                                                          typeid(NumberedRole<2>), typeid(NumberedRole<3>)};
        ComponentInfo info{.type = typeid(void),
                           .kind = kind,
                           .text = {.name = keep(stated.name),
                                    .effect = "effect",
                                    .level = keep(stated.level),
                                    .work = "",
                                    .rank = stated.rank}};
        info.reads = properties(stated.reads);
        info.offers = properties(stated.offers);
        info.neededAll = properties(stated.needs);
        info.neededAny = properties(stated.needsAny);
        info.onDemand = stated.onDemand;
        if (kind != ComponentKind::dps) {
            info.role = roles.at(static_cast<std::size_t>(stated.role));
        }
        infos_.push_back(std::move(info));
        return infos_.size() - 1;
    }

    std::deque<std::string> texts_; // deques, because other members refer to their elements
    std::deque<PropertyInfo> properties_;
    std::deque<ComponentInfo> infos_;
};

struct MadeUpScene {
    std::set<std::string> inhabited{};
    std::set<std::string> subscribed{};
    std::map<std::string, std::string> detail{};
    std::set<std::size_t> unsuitable{};
};

inline SelectionFacts factsOf(MadeUpScene const& scene) {
    return {.inhabited = {scene.inhabited.begin(), scene.inhabited.end()},
            .subscribed = {scene.subscribed.begin(), scene.subscribed.end()},
            .detail = scene.detail,
            .suits = [&scene](std::size_t number) { return !scene.unsuitable.contains(number); }};
}

inline std::vector<Choice> choicesIn(Descriptions const& descriptions, MadeUpScene const& scene) {
    return selectComponents(ComponentGraph(descriptions.list()), factsOf(scene));
}

inline std::vector<std::size_t> chosenIn(Descriptions const& descriptions, MadeUpScene const& scene) {
    std::vector<Choice> const choices = choicesIn(descriptions, scene);
    std::vector<std::size_t> chosen;
    for (std::size_t number = 0; number < choices.size(); ++number) {
        if (choices[number].chosen()) {
            chosen.push_back(number);
        }
    }
    return chosen;
}

} // namespace trembler::descriptions
