#include "runtime/level/json/refuse_file.hpp"

#include "runtime/level/json/diagnostic.hpp"

#include <utility>

namespace trembler {

void refuseFile(std::string file, std::string message, std::string expected) {
    Diagnostic diagnostic;
    diagnostic.file = std::move(file);
    diagnostic.message = std::move(message);
    diagnostic.expected = std::move(expected);
    throw InputError({std::move(diagnostic)});
}

} // namespace trembler
