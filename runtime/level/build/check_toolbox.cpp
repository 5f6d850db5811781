#include "runtime/level/build/check_toolbox.hpp"

#include "runtime/level/json/add_problem.hpp"
#include "runtime/level/json/suggestion.hpp"

#include <fmt/format.h>

namespace trembler {

void checkToolbox(LevelFile const& level, PartLibrary const& library, Problems& problems) {
    for (ToolboxEntry const& entry : level.toolbox) {
        if (library.find(entry.part) == nullptr) {
            addProblem(problems, [&] {
                return level.diagnostic(entry.path.empty() ? "" : entry.path + "/part",
                                        fmt::format("there is no part '{}'{}", entry.part,
                                                    didYouMean(entry.part, library.names())),
                                        listed(library.names()));
            });
        }
    }
}

} // namespace trembler
