#include "audio/device/sample_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <sndfile.h>
#include <stdexcept>
#include <sys/stat.h>
#include <system_error>

namespace trembler {
namespace {

namespace fs = std::filesystem;

constexpr sf_count_t chunk = 4096;             // frames
constexpr std::size_t mostRemembered = 10'000; // names and reports of earlier levels

struct Close {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

[[noreturn]] void refuse(std::string const& why) {
    throw std::runtime_error(why);
}

// A file's name comes from a level, which may be from an untrusted source.
bool staysInside(fs::path const& file) {
    return file.is_relative() &&
           std::none_of(file.begin(), file.end(), [](fs::path const& part) { return part == ".."; });
}

double megabytes(std::uint64_t bytes) {
    return static_cast<double>(bytes) / 1e6;
}

/// Throws if a recording of so many samples is longer or larger than one may be.
void checkLength(SampleLimits const& limits, std::uint64_t samples, double rate) {
    double const seconds = static_cast<double>(samples) / rate;
    if (seconds > limits.seconds) {
        refuse(fmt::format("it is {:.1f} s long; expected at most {:.1f} s", seconds, limits.seconds));
    }
    if (samples * sizeof(float) > limits.bytes) {
        refuse(fmt::format("its {} samples at {:.0f} Hz take {:.1f} MB of memory; expected at most {:.1f} "
                           "MB: a shorter recording, or a lower rate",
                           samples, rate, megabytes(samples * sizeof(float)), megabytes(limits.bytes)));
    }
}

} // namespace

SampleFiles::SampleFiles(std::vector<fs::path> folders, Report report, SampleLimits const& limits)
    : folders_(std::move(folders)), report_(std::move(report)), limits_(limits) {}

fs::path SampleFiles::pathOf(std::string const& file) const {
    for (fs::path const& folder : folders_) {
        std::error_code error;
        if (staysInside(file) && fs::is_regular_file(folder / file, error)) {
            return folder / file;
        }
    }
    return {};
}

void SampleFiles::report(std::string const& file, std::string const& why) {
    std::string text = fmt::format("the recording \"{}\" cannot be played: {}", file, why);
    if (report_ && reported_.insert(text).second) {
        report_(text);
    }
}

std::shared_ptr<SampleData const> SampleFiles::find(std::string const& file) {
    if (missing_.contains(file)) {
        return nullptr;
    }
    if (auto const name = names_.find(file); name != names_.end()) {
        if (auto const at = known_.find(name->second); at != known_.end()) {
            at->second.level = level_;
            return at->second.data;
        }
    }
    // Two names of one file, as by a link or by "./", share its samples.
    fs::path const path = pathOf(file);
    struct stat status {};
    if (path.empty() || ::stat(path.c_str(), &status) != 0) {
        missing_.insert(file);
        report(file, "there is no such file");
        return nullptr;
    }
    Identity const identity{status.st_dev, status.st_ino};
    names_[file] = identity;
    auto at = known_.find(identity);
    if (at == known_.end()) {
        Known read_{nullptr, level_};
        try {
            read_.data = read(path);
            bytes_ += read_.data->samples.capacity() * sizeof(float);
        } catch (std::runtime_error const& error) {
            report(file, error.what());
        }
        at = known_.emplace(identity, std::move(read_)).first;
    }
    at->second.level = level_;
    return at->second.data;
}

void SampleFiles::newLevel() {
    ++level_;
    std::erase_if(known_, [](auto const& entry) { return entry.second.data == nullptr; });
    missing_.clear();
    if (names_.size() > mostRemembered) {
        names_.clear();
    }
    if (reported_.size() > mostRemembered) {
        reported_.clear();
    }
}

void SampleFiles::makeRoom(std::size_t samples) {
    std::size_t const wanted = samples * sizeof(float);
    while (bytes_ + wanted > limits_.inAll) {
        auto oldest = known_.end();
        for (auto at = known_.begin(); at != known_.end(); ++at) {
            Known const& each = at->second;
            if (each.data != nullptr && each.level < level_ && each.data.use_count() == 1 &&
                (oldest == known_.end() || each.level < oldest->second.level)) {
                oldest = at;
            }
        }
        if (oldest == known_.end()) {
            refuse(fmt::format("with it the recordings of this level take {:.1f} MB of memory; expected at "
                               "most {:.1f} MB together",
                               megabytes(bytes_ + wanted), megabytes(limits_.inAll)));
        }
        bytes_ -= oldest->second.data->samples.capacity() * sizeof(float);
        known_.erase(oldest);
    }
}

std::shared_ptr<SampleData const> SampleFiles::read(fs::path const& path) {
    SF_INFO info{};
    std::unique_ptr<SNDFILE, Close> const handle(sf_open(path.c_str(), SFM_READ, &info));
    if (!handle) {
        refuse(sf_strerror(nullptr));
    }
    if (info.channels < 1 || info.channels > 64 || info.samplerate < 1000 || info.samplerate > 768000) {
        refuse(fmt::format("{} channels at {} Hz are out of range", info.channels, info.samplerate));
    }
    auto data = std::make_shared<SampleData>();
    data->rate = info.samplerate;
    bool const stated = info.frames > 0 && info.frames < SF_COUNT_MAX;
    if (stated) {
        checkLength(limits_, static_cast<std::uint64_t>(info.frames), data->rate);
        makeRoom(static_cast<std::size_t>(info.frames));
        data->samples.reserve(static_cast<std::size_t>(info.frames));
    }
    auto const channels = static_cast<std::size_t>(info.channels);
    std::vector<float> frames(static_cast<std::size_t>(chunk) * channels);
    // The length that the file states may be wrong; the samples that can be read count.
    for (sf_count_t got = 0; (got = sf_readf_float(handle.get(), frames.data(), chunk)) > 0;) {
        std::size_t const size = data->samples.size() + static_cast<std::size_t>(got);
        if (size > data->samples.capacity()) {
            checkLength(limits_, size, data->rate);
            std::size_t const grown =
                std::clamp(2 * data->samples.capacity(), size, limits_.bytes / sizeof(float));
            makeRoom(grown);
            data->samples.reserve(grown);
        }
        for (std::size_t i = 0; i < static_cast<std::size_t>(got); ++i) {
            float sum = 0;
            for (std::size_t c = 0; c < channels; ++c) {
                sum += frames[i * channels + c];
            }
            data->samples.push_back(
                std::isfinite(sum) ? std::clamp(sum / static_cast<float>(channels), -8.0F, 8.0F) : 0);
        }
    }
    if (data->samples.empty()) {
        refuse("there is nothing in it");
    }
    data->samples.shrink_to_fit();
    data->finish();
    return data;
}

} // namespace trembler
