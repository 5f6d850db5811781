// A problem in a file and its place. All problems in input files are reported in this form.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <vector>

namespace trembler {

/// One problem. Printed as `file:line:column: path: message; expected …`.
struct Diagnostic {
    std::string file;
    std::size_t line = 0;   ///< from 1; 0: the file as a whole
    std::size_t column = 0; ///< from 1, in characters
    std::string path;       ///< JSON pointer (RFC 6901) to the value at fault; "" is the whole document
    std::string message;
    std::string expected; ///< the accepted values; may be empty

    [[nodiscard]] std::string print() const;
};

/// Thrown for an input file that cannot be used. Contains all problems that were found in it.
class InputError : public std::runtime_error {
public:
    explicit InputError(std::vector<Diagnostic> diagnostics);
    [[nodiscard]] std::vector<Diagnostic> const& diagnostics() const { return diagnostics_; }

private:
    std::vector<Diagnostic> diagnostics_;
};

/// Collects problems, so that the author of a file sees all of them at once.
class Problems {
public:
    /// The most problems that are kept; further ones are only counted.
    static constexpr std::size_t most = 100;

    void add(Diagnostic diagnostic);
    /// Adds the problem that make() returns. Finding its place takes a walk through the file, so make() is
    /// called only if the problem will be kept; otherwise it is only counted.
    template <class Make>
    friend void addProblem(Problems& problems, Make&& make);
    [[nodiscard]] bool empty() const { return count_ == 0; }
    /// The number of all problems added, including the problems that were not kept.
    [[nodiscard]] std::size_t count() const { return count_; }
    /// Throws InputError, in order of the places in the files, if there is any problem.
    void throwIfAny() const;

private:
    [[nodiscard]] bool hasRoom() const { return kept_.size() < most; }

    std::vector<Diagnostic> kept_;
    std::size_t count_ = 0;
};

} // namespace trembler
