#include "insight/spread/journal.hpp"

#include "runtime/file/output_file.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cerrno>
#include <fcntl.h>
#include <fstream>
#include <stdexcept>
#include <string_view>
#include <system_error>
#include <unistd.h>

namespace trembler::insight {
namespace {

namespace fs = std::filesystem;

fs::path ofMember(fs::path const& file, int rank) {
    return rank == 0 ? file : fs::path(fmt::format("{}.{}", file.string(), rank));
}

bool endsWithinALine(fs::path const& file) {
    std::ifstream in(file, std::ios::binary | std::ios::ate);
    if (!in || in.tellg() <= 0) {
        return false;
    }
    in.seekg(-1, std::ios::end);
    return in.get() != '\n';
}

/// Like std::getline(), but of a line that is too long only one byte more than the limit.
bool readLine(std::istream& in, std::string& line) {
    line.clear();
    std::streambuf& from = *in.rdbuf();
    for (int next = from.sbumpc(); next != std::char_traits<char>::eof(); next = from.sbumpc()) {
        if (next == '\n') {
            return true;
        }
        line += static_cast<char>(next);
        if (line.size() > Journal::longestLine) {
            return true;
        }
    }
    return !line.empty();
}

[[noreturn]] void refuseJournal(fs::path const& file, int error) {
    throw OutputError(fmt::format("{}: cannot be written: {}", file.string(),
                                  std::error_code(error, std::generic_category()).message()));
}

} // namespace

Journal::Journal(fs::path file, Team& team) : file_(ofMember(file, team.rank())) {
    // Only the leader reads, as the others may be on machines that do not have its files.
    std::string contents;
    std::string problem;
    if (team.leads()) {
        try {
            std::error_code error;
            read(file);
            for (int rank = 1; fs::exists(ofMember(file, rank), error); ++rank) {
                read(ofMember(file, rank));
            }
            if (team.size() > 1) {
                contents = nlohmann::json(known_).dump();
            }
        } catch (std::exception const& error) {
            problem = error.what();
        }
    }
    std::string const message = nlohmann::json{{"problem", problem}, {"known", contents}}.dump();
    nlohmann::json const parsed = nlohmann::json::parse(team.exchange(team.leads() ? message : "").front());
    if (!parsed["problem"].get<std::string>().empty()) {
        throw std::invalid_argument(parsed["problem"].get<std::string>());
    }
    if (!team.leads()) {
        known_ = nlohmann::json::parse(parsed["known"].get<std::string>())
                     .get<std::map<std::string, std::string>>();
    }
    descriptor_ = ::open(file_.c_str(), O_WRONLY | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
    if (descriptor_ < 0) {
        refuseJournal(file_, errno);
    }
    if (endsWithinALine(file_)) { // an incomplete line stays, and every reader skips it
        [[maybe_unused]] ssize_t const written = ::write(descriptor_, "\n", 1);
    }
}

Journal::~Journal() {
    if (descriptor_ >= 0) {
        ::close(descriptor_);
    }
}

void Journal::read(fs::path const& file) {
    std::error_code error;
    if (fs::file_status const found = fs::status(file, error);
        fs::exists(found) && !fs::is_regular_file(found) && !fs::is_directory(found)) {
        // The end of a device or of a pipe may never come.
        throw std::invalid_argument(fmt::format("{}: is no ordinary file; expected a file", file.string()));
    }
    if (std::uintmax_t const size = fs::file_size(file, error); !error) {
        bytes_ += size;
    }
    if (bytes_ > mostBytes) {
        throw std::invalid_argument(
            fmt::format("{}: has {} bytes, together with those of the other members of the team; expected at "
                        "most {}",
                        file.string(), bytes_, mostBytes));
    }
    std::ifstream in(file, std::ios::binary);
    constexpr std::string_view begin = R"({"work":)";
    std::string line;
    std::size_t number = 0;
    while (readLine(in, line)) {
        ++number;
        if (line.size() > longestLine) {
            throw std::invalid_argument(
                fmt::format("{}, line {}: has more than {} bytes; expected at most {}", file.string(), number,
                            longestLine, longestLine));
        }
        nlohmann::json const entry = nlohmann::json::parse(line, nullptr, false);
        if (entry.is_discarded() && (line.starts_with(begin) || begin.starts_with(line))) {
            continue; // cut off
        }
        if (!entry.is_object() || !entry.contains("work") || !entry.contains("result") ||
            !entry["work"].is_string() || !entry["result"].is_string()) {
            throw std::invalid_argument(
                fmt::format("{}, line {}: expected {{\"work\": TEXT, \"result\": TEXT}}, as --resume writes "
                            "it; name a file that was written so, or a new one",
                            file.string(), number));
        }
        known_.emplace(entry["work"].get<std::string>(), entry["result"].get<std::string>());
    }
}

std::optional<std::string> Journal::find(std::string const& key) const {
    auto const found = known_.find(key);
    return found == known_.end() ? std::nullopt : std::optional(found->second);
}

void Journal::add(std::string const& key, std::string const& result) {
    nlohmann::ordered_json entry;
    entry["work"] = key;
    entry["result"] = result;
    std::string const line =
        entry.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace) + "\n";
    if (line.size() > longestLine) {
        return;
    }
    std::lock_guard const lock(mutex_);
    std::size_t done = 0;
    while (done < line.size()) {
        ssize_t const written = ::write(descriptor_, line.data() + done, line.size() - done);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            refuseJournal(file_, errno);
        }
        done += static_cast<std::size_t>(written);
    }
}

} // namespace trembler::insight
