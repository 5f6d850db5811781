// Runs a level in separate processes, so that a crash there, even by a signal, is reported instead of ending
// the test program.
#pragma once

#include <nlohmann/json.hpp>

#include <functional>
#include <string>
#include <vector>

namespace trembler::worlds {

/// The output of a child process, and how it ended.
struct Ended {
    std::string said;     ///< its result, sent to the parent
    std::string murmured; ///< the end of its standard error and standard output
    int signal = 0;       ///< the signal that ended it; 0: none
    int status = 0;       ///< its exit status
};

/// Runs `work` in a child process, which may use `seconds` of processor time and 4 GiB of memory, and waits
/// for its end. The child's result is the value that `work` returns; an exception makes the exit status 1.
/// The calling process must not have started a thread.
[[nodiscard]] Ended inChild(std::function<std::string()> const& work, unsigned seconds);

struct TrialOptions {
    std::vector<std::string> engines{"native", "box2d", "chipmunk", "ode"};
    std::vector<int> threads{1, 2, 5};
    int frames = 30;
    unsigned seconds = 60;   ///< of processor time to read it
    double frameSeconds = 2; ///< of processor time that a frame may take on one thread, unless the world says
                             ///< that its engine gave up; a level hangs if it takes longer than if all did
};

struct Failure {
    std::string engine; ///< or "reading"
    std::string what;   ///< the signal, the difference, the value that is not finite
    std::string murmured;
};

struct Outcome {
    nlohmann::json level; ///< as it was run: without the values that the reader refused
    bool played = false;
    std::vector<Failure> failures;
};

/// Reads a level, removes refused values (a refusal must name a place) until it is accepted, and runs it on
/// every engine and number of threads, with its first solution if it has one. A failure is: a signal, an
/// exception that is no refusal of the file, a number in any property (those of objects, resolver and derived
/// properties) that is not finite, state hashes that depend on threads, too much processor time, a file that
/// the schema refuses but the reader accepts.
[[nodiscard]] Outcome tryOut(nlohmann::json level, nlohmann::json const& schema, TrialOptions const& options);

/// For people: one line.
[[nodiscard]] std::string inWords(Failure const& failure);

} // namespace trembler::worlds
