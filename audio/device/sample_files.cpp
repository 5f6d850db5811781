#include "audio/device/sample_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sndfile.h>
#include <system_error>

namespace trembler {
namespace {

namespace fs = std::filesystem;

struct Close {
    void operator()(SNDFILE* file) const { sf_close(file); }
};

// A file's name comes from a level, which may be from an untrusted source.
bool staysInside(fs::path const& file) {
    return file.is_relative() &&
           std::none_of(file.begin(), file.end(), [](fs::path const& part) { return part == ".."; });
}

} // namespace

SampleFiles::SampleFiles(std::vector<fs::path> folders, Report report)
    : folders_(std::move(folders)), report_(std::move(report)) {}

std::shared_ptr<SampleData const> SampleFiles::find(std::string const& file) {
    auto const at = known_.find(file);
    if (at != known_.end()) {
        return at->second;
    }
    return known_.emplace(file, read(file)).first->second;
}

std::shared_ptr<SampleData const> SampleFiles::read(std::string const& file) const {
    constexpr double longest = 600;    // s
    constexpr sf_count_t chunk = 4096; // frames
    auto const refuse = [&](std::string const& why) -> std::shared_ptr<SampleData const> {
        if (report_) {
            report_(fmt::format("the recording \"{}\" cannot be played: {}", file, why));
        }
        return nullptr;
    };
    fs::path found;
    for (fs::path const& folder : folders_) {
        std::error_code error;
        if (staysInside(file) && fs::is_regular_file(folder / file, error)) {
            found = folder / file;
            break;
        }
    }
    if (found.empty()) {
        return refuse("there is no such file");
    }
    SF_INFO info{};
    std::unique_ptr<SNDFILE, Close> const handle(sf_open(found.c_str(), SFM_READ, &info));
    if (!handle) {
        return refuse(sf_strerror(nullptr));
    }
    if (info.channels < 1 || info.channels > 64 || info.samplerate < 1000 || info.samplerate > 768000) {
        return refuse(fmt::format("{} channels at {} Hz are out of range", info.channels, info.samplerate));
    }
    auto data = std::make_shared<SampleData>();
    data->rate = info.samplerate;
    auto const channels = static_cast<std::size_t>(info.channels);
    auto const most = static_cast<std::size_t>(longest * info.samplerate);
    std::vector<float> frames(static_cast<std::size_t>(chunk) * channels);
    // The length in the header may be wrong; the samples that can be read count.
    for (sf_count_t got = 0; (got = sf_readf_float(handle.get(), frames.data(), chunk)) > 0;) {
        if (data->samples.size() + static_cast<std::size_t>(got) > most) {
            return refuse("it is longer than ten minutes");
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
        return refuse("there is nothing in it");
    }
    data->finish();
    return data;
}

} // namespace trembler
