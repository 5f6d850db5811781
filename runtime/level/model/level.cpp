#include "runtime/level/model/level.hpp"

#include <algorithm>

namespace trembler {

bool Area::contains(Vec2 point) const {
    if (box) {
        return box->contains(point);
    }
    bool inside = false; // a ray to the right crosses the outline an odd number of times
    for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
        Vec2 const a = corners[i];
        Vec2 const b = corners[j];
        if ((a.y > point.y) != (b.y > point.y) &&
            point.x < (b.x - a.x) * (point.y - a.y) / (b.y - a.y) + a.x) {
            inside = !inside;
        }
    }
    return inside;
}

LevelObject const* LevelFile::findObject(std::string const& name) const {
    auto const at = std::find_if(objects.begin(), objects.end(),
                                 [&](LevelObject const& object) { return object.name == name; });
    return at == objects.end() ? nullptr : &*at;
}

Solution const* LevelFile::findSolution(std::string const& name) const {
    auto const at = std::find_if(solutions.begin(), solutions.end(),
                                 [&](Solution const& solution) { return solution.name == name; });
    return at == solutions.end() ? nullptr : &*at;
}

Diagnostic LevelFile::diagnostic(std::string path, std::string message, std::string expected) const {
    if (document && !path.empty()) {
        return document->diagnostic(std::move(path), std::move(message), std::move(expected));
    }
    Diagnostic made;
    made.file = document ? document->file() : "(level)";
    made.path = std::move(path);
    made.message = std::move(message);
    made.expected = std::move(expected);
    return made;
}

Diagnostic LevelFile::diagnostic(Solution const& solution, std::string path, std::string message,
                                 std::string expected) const {
    return solution.document
               ? solution.document->diagnostic(std::move(path), std::move(message), std::move(expected))
               : diagnostic(std::move(path), std::move(message), std::move(expected));
}

} // namespace trembler
