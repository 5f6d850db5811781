#include "game/app/options/files/outputs.hpp"

#include "game/app/options/files/file_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <sys/stat.h>
#include <utility>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr char const* terminal = "-";

/// Whether two names mean the same file. Existing files are compared by device and inode, so links are
/// followed; files that do not exist yet by folder and name.
bool sameFile(fs::path const& a, fs::path const& b) {
    struct ::stat of {};
    struct ::stat other {};
    bool const aIs = ::stat(a.c_str(), &of) == 0;
    bool const bIs = ::stat(b.c_str(), &other) == 0;
    if (aIs != bIs) {
        return false;
    }
    if (aIs) {
        return of.st_dev == other.st_dev && of.st_ino == other.st_ino;
    }
    std::error_code error;
    fs::path const one = fs::weakly_canonical(fs::absolute(fileBehind(a), error), error);
    fs::path const two = fs::weakly_canonical(fs::absolute(fileBehind(b), error), error);
    return one == two;
}

/// Whether the path is a character device such as /dev/null, to which several outputs may write.
bool isDevice(fs::path const& path) {
    struct ::stat is {};
    return ::stat(path.c_str(), &is) == 0 && S_ISCHR(is.st_mode);
}

} // namespace

CLI::Option* addFile(CLI::App& command, std::string const& option, OutputTarget& target, FileKind const& kind,
                     std::string const& meaning) {
    auto* const added = command.add_option_function<std::string>(
        option, [&target](std::string const& name) { target = name; }, meaning);
    std::string const ending(kind.endings.empty() ? std::string_view() : kind.endings.front());
    return accepts(added->type_name("FILE" + ending), expectedOf(kind), writableFile(command, kind));
}

CLI::Option* addOptionalFile(CLI::App& command, std::string const& option, OutputTarget& target,
                             FileKind const& kind, std::string const& meaning) {
    std::string const type = fmt::format("[FILE{}]", kind.endings.empty() ? "" : kind.endings.front());
    return addFile(command, option, target, kind, meaning)
        ->expected(0, 1)
        ->default_str(terminal)
        ->type_name(type)
        ->option_text(type);
}

namespace {

/// Tells the parser, too, so that the rules of both options apply to what they now have.
std::string takenBack(CLI::App& command, std::string const& name, std::string const& option,
                      OutputTarget& target) {
    std::string const argument = std::exchange(*target, terminal);
    command.get_option(option)->clear();
    command.get_option(option)->add_result(terminal);
    command.get_option(name)->add_result(argument);
    return argument;
}

bool isForFile(OutputTarget const& target) {
    return target && !target->empty() && *target != terminal;
}

} // namespace

void takeBack(CLI::App& command, std::string const& name, std::string& argument, std::string const& option,
              OutputTarget& target) {
    if (command.get_option(name)->count() > 0) {
        return;
    }
    if (!isForFile(target)) {
        throw CLI::RequiredError(name);
    }
    argument = takenBack(command, name, option, target);
}

void takeBack(CLI::App& command, std::string const& name, std::vector<std::string>& arguments,
              std::string const& option, OutputTarget& target) {
    if (arguments.empty() && isForFile(target)) {
        arguments.push_back(takenBack(command, name, option, target));
    }
}

void Outputs::reads(fs::path const& file) {
    inputs_.push_back({"", file, nullptr});
}

void Outputs::claimFile(std::string const& option, OutputTarget const& target, std::string const& expected) {
    if (!target) {
        return;
    }
    if (*target == terminal) {
        throw OutputError(
            fmt::format("{} {}: cannot be written to the terminal; expected {}", option, *target, expected));
    }
    claim(option, *target, "expected " + expected);
}

void Outputs::claim(std::string const& option, std::string const& target, std::string const& expected) {
    std::string const what = option + " " + target;
    if (target.empty()) {
        throw OutputError(fmt::format("{}: the file's name is empty; {}", option, expected));
    }
    bool const toTerminal = target == terminal;
    for (Claim const& input : inputs_) {
        if (!toTerminal && sameFile(target, input.path)) {
            throw OutputError(
                fmt::format("{}: this is the input {}, which is not overwritten", what, input.path.string()));
        }
    }
    for (Claim const& other : outputs_) {
        bool const same = toTerminal
                              ? other.path == terminal
                              : other.path != terminal && sameFile(target, other.path) && !isDevice(target);
        if (same) {
            throw OutputError(
                fmt::format("{}: {} writes to the same file; expected different files", what, other.what));
        }
    }
    terminalTaken_ = terminalTaken_ || toTerminal;
    outputs_.push_back({what, target, nullptr});
}

OutputFile* Outputs::add(std::string const& option, OutputTarget const& target, OutputFile::Content content) {
    if (!target) {
        return nullptr;
    }
    claim(option, *target, "\"-\" is the terminal");
    try {
        outputs_.back().file = std::make_unique<OutputFile>(*target, content);
    } catch (OutputError const& error) {
        throw OutputError(option + " " + error.what());
    }
    return outputs_.back().file.get();
}

bool Outputs::isFree(fs::path const& name) const {
    std::error_code error;
    if (fs::symlink_status(name, error).type() != fs::file_type::not_found) {
        return false; // or it cannot be known
    }
    auto const is = [&](Claim const& claim) { return sameFile(name, claim.path); };
    return std::none_of(inputs_.begin(), inputs_.end(), is) &&
           std::none_of(outputs_.begin(), outputs_.end(), is);
}

void Outputs::drop(OutputFile const& output) {
    for (Claim& claimed : outputs_) {
        if (claimed.file.get() == &output) {
            claimed.file.reset();
            return;
        }
    }
}

std::ostream& Outputs::words() const {
    return terminalTaken_ ? std::cerr : std::cout;
}

void Outputs::check() {
    for (Claim const& output : outputs_) {
        try {
            if (output.file) {
                output.file->check();
            }
        } catch (OutputError const& error) {
            throw OutputError(output.what.substr(0, output.what.find(' ') + 1) + error.what());
        }
    }
}

void Outputs::finish() {
    for (Claim const& output : outputs_) {
        try {
            if (output.file) {
                output.file->commit();
            }
        } catch (OutputError const& error) {
            throw OutputError(output.what.substr(0, output.what.find(' ') + 1) + error.what());
        }
    }
}

} // namespace trembler
