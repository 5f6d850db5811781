// The prelude's text, put together from its parts.
#include "lua/sandbox/prelude/prelude.hpp"

#include "lua/sandbox/prelude/parts.hpp"
#include "lua/sandbox/prelude/signatures.hpp"

#include <string>

namespace trembler::lua {

// The functions written in Lua are counted in instructions like the script itself, so none needs a bound of
// its own. Lua's own functions whose time grows with their arguments are charged for (host.charge). Scripts
// reach none of the tables in here: libraries are handed out behind read-only tables, so nothing that a
// script does to them can last to its next turn.
std::string_view preludeText() {
    static std::string const text = [] {
        std::string joined;
        for (std::string_view const part : {foundationsPart(), errorsPart(), vectorsPart(), readingsPart(),
                                            textPart(), tablesPart(), numbersPart()}) {
            joined += part;
        }
        joined += signaturesPart();
        return joined += globalsPart();
    }();
    return text;
}

} // namespace trembler::lua
