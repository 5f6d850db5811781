// The targets of assignments in a script's text: names that may be globals, and fields of tables.
#pragma once

#include "lua/sandbox/source/tokens.hpp"

#include <cstddef>
#include <functional>
#include <set>
#include <string>
#include <string_view>

namespace trembler::lua {

/// Collects the assignments of a text while it is walked through. Uncertain statements count as assignments.
class Assignments {
public:
    /// The tokens must outlive it.
    explicit Assignments(Tokens const& tokens) : tokens_(tokens) {}

    /// At a '=' outside of a table's constructor: adds the variables and fields that stand before it.
    void findAt(std::size_t equals);
    /// A field that is assigned to in another way.
    void addField() { fields_ = true; }
    /// A name that is assigned to in another way.
    void addName(std::string_view name) { names_.emplace(name); }
    /// A parameter of a function; `itself`: a parameter with the name 'store' is the store.
    void addParameter(std::string_view name, bool itself) {
        storeIsItself_ = storeIsItself_ && (name != "store" || itself);
    }

    /// Whether the text may assign to fields other than those of its store.
    [[nodiscard]] bool ofFields() const {
        return fields_ || (toStore_ && !(storeIsItself_ && storeIsPlain()));
    }
    /// The names to which it assigns that may not be local variables.
    [[nodiscard]] std::set<std::string, std::less<>> const& names() const { return names_; }

private:
    [[nodiscard]] Token const& token(std::size_t at) const { return tokens_.token(at); }
    [[nodiscard]] bool isName(std::size_t at) const { return tokens_.isName(at); }
    /// Whether a name is the last one of store.object.NAME or store.script.NAME.
    [[nodiscard]] bool isStoreField(std::size_t at);
    /// Whether 'store' is nowhere declared as a local variable without '=' or in a 'for', and never handed
    /// on.
    [[nodiscard]] bool storeIsPlain() const;

    Tokens const& tokens_;
    std::set<std::string, std::less<>> names_;
    bool fields_ = false;
    bool toStore_ = false;
    bool storeIsItself_ = true;
};

} // namespace trembler::lua
