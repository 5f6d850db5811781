// The targets of assignments in a script's text: names that may be globals, and fields of tables.
#include "lua/sandbox/source/assignments.hpp"

#include <vector>

namespace trembler::lua {

void Assignments::findAt(std::size_t equals) {
    std::size_t i = equals;
    bool onlyNames = true;
    std::vector<std::string_view> names;
    while (i > 0) {
        --i; // the last token of a target
        if (!isName(i)) {
            fields_ = fields_ || token(i).is("]");
            return;
        }
        if (i > 0 && token(i - 1).is(".")) {
            if (!isStoreField(i)) {
                fields_ = true;
                return;
            }
            i -= 4;
            onlyNames = false;
        } else {
            names.push_back(token(i).text);
        }
        if (i == 0 || !token(i - 1).is(",")) {
            break;
        }
        --i;
    }
    bool const declared = i > 0 && (token(i - 1).is("local") || token(i - 1).is("for")) && onlyNames;
    for (std::string_view const name : names) {
        storeIsItself_ = storeIsItself_ && name != "store";
        if (!declared) {
            names_.emplace(name);
        }
    }
}

bool Assignments::isStoreField(std::size_t at) {
    bool const is = at >= 4 && token(at - 3).is(".") && token(at - 4).is("store") &&
                    (token(at - 2).is("object") || token(at - 2).is("script")) &&
                    !(at >= 5 && (token(at - 5).is(".") || token(at - 5).is(":")));
    toStore_ = toStore_ || is;
    return is;
}

bool Assignments::storeIsPlain() const {
    for (std::size_t i = 0; i < tokens_.size(); ++i) {
        if (token(i).is("store") && i > 0 &&
            (token(i - 1).is("local") || token(i - 1).is("for") || token(i - 1).is("function"))) {
            return false;
        }
        if (token(i).is("store") && i > 0 && token(i - 1).is(",") && !token(i + 1).is(".")) {
            // In a list: of apply's parameters, of a table, of a local's or a for's names. Only the first
            // two declare nothing else by that name.
            if (!token(i + 1).is(")") && !token(i + 1).is(",") && !token(i + 1).is("=")) {
                return false;
            }
            for (std::size_t back = i; back > 1 && (isName(back - 1) || token(back - 1).is(",")); --back) {
                if (token(back - 2).is("local") || token(back - 2).is("for")) {
                    return false;
                }
            }
        }
    }
    return true;
}

} // namespace trembler::lua
