#include "audio/device/openal_streams.hpp"

#include <algorithm>

namespace trembler {
OpenAlStreams::OpenAlStreams(int block, int rate, double fullScale, int channels)
    : rate_(rate), fullScale_(fullScale), channels_(channels),
      scaled_(static_cast<std::size_t>(channels * block)),
      silence_(static_cast<std::size_t>(channels * block)) {}

void OpenAlStreams::setCushion(int buffers, int samples) {
    cushion_ = buffers;
    silence_.assign(static_cast<std::size_t>(channels_ * samples), 0);
}

void OpenAlStreams::addIdleBuffer() {
    ALuint buffer = 0;
    alGenBuffers(1, &buffer);
    allBuffers_.push_back(buffer);
    idleBuffers_.push_back(buffer);
}

// Returns whether OpenAL had another source.
bool OpenAlStreams::addIdleSource() {
    ALuint id = 0;
    alGetError();
    alGenSources(1, &id);
    if (alGetError() != AL_NO_ERROR) {
        return false;
    }
    allSources_.push_back(id);
    idleSources_.push_back(id);
    return true;
}

void OpenAlStreams::prepare(int streams) {
    for (int i = 0; i < streams && addIdleSource(); ++i) {
        for (int b = 0; b <= cushion_; ++b) {
            addIdleBuffer();
            fill(idleBuffers_.back(), scaled_); // OpenAL takes the memory for samples with the first ones
        }
    }
}

void OpenAlStreams::fill(ALuint buffer, std::span<float const> samples) {
    alBufferData(buffer, channels_ == 2 ? AL_FORMAT_STEREO_FLOAT32 : AL_FORMAT_MONO_FLOAT32, samples.data(),
                 static_cast<ALsizei>(samples.size_bytes()), rate_);
}

ALuint OpenAlStreams::freeBuffer() {
    if (idleBuffers_.empty()) {
        addIdleBuffer();
    }
    ALuint const buffer = idleBuffers_.back();
    idleBuffers_.pop_back();
    return buffer;
}

OpenAlStreams::Source* OpenAlStreams::sourceFor(std::uint64_t stream) {
    auto const known = sources_.find(stream);
    if (known != sources_.end()) {
        return &known->second;
    }
    if (idleSources_.empty() && !addIdleSource()) {
        return nullptr;
    }
    Source source;
    source.id = idleSources_.back();
    idleSources_.pop_back();
    alSourcei(source.id, AL_SOURCE_RELATIVE, AL_FALSE);
    alSourcef(source.id, AL_REFERENCE_DISTANCE, 1);
    alSourcef(source.id, AL_ROLLOFF_FACTOR, 1);
    if (channels_ == 2 && alIsExtensionPresent("AL_SOFT_direct_channels") == AL_TRUE) {
        alSourcei(source.id, AL_DIRECT_CHANNELS_SOFT, AL_TRUE);
    }
    if (slot_ != 0) {
        alSource3i(source.id, AL_AUXILIARY_SEND_FILTER, static_cast<ALint>(slot_), 0, AL_FILTER_NULL);
    }
    return &sources_.emplace(stream, source).first->second;
}

void OpenAlStreams::reclaim(Source& source) {
    ALint done = 0;
    alGetSourcei(source.id, AL_BUFFERS_PROCESSED, &done);
    for (; done > 0; --done) {
        ALuint buffer = 0;
        alSourceUnqueueBuffers(source.id, 1, &buffer);
        idleBuffers_.push_back(buffer);
    }
}

void OpenAlStreams::reclaim() {
    for (auto& [stream, source] : sources_) {
        reclaim(source);
    }
}

int OpenAlStreams::longestQueue() const {
    int longest = 0;
    for (auto const& [stream, source] : sources_) {
        ALint waiting = 0;
        alGetSourcei(source.id, AL_BUFFERS_QUEUED, &waiting);
        longest = std::max(longest, static_cast<int>(waiting));
    }
    return longest;
}

void OpenAlStreams::queue(Source& source, std::span<float const> samples) {
    ALint state = 0;
    alGetSourcei(source.id, AL_SOURCE_STATE, &state);
    auto const add = [&](std::span<float const> block) {
        ALuint const buffer = freeBuffer();
        fill(buffer, block);
        alSourceQueueBuffers(source.id, 1, &buffer);
    };
    if (state != AL_PLAYING) { // it begins, or its queue ran empty
        slips_ += state == AL_STOPPED ? 1 : 0;
        reclaim(source);
        for (int i = 0; i < cushion_; ++i) {
            add(silence_);
        }
    }
    std::transform(samples.begin(), samples.end(), scaled_.begin(),
                   [this](float s) { return s * static_cast<float>(1 / fullScale_); });
    add(scaled_);
    if (state != AL_PLAYING) {
        alSourcePlay(source.id);
    }
    source.used = true;
}

void OpenAlStreams::queue(std::uint64_t stream, SourcePlace const& place, std::span<float const> samples) {
    Source* const source = sourceFor(stream);
    if (source == nullptr) {
        return;
    }
    if (place.relative) {
        alSourcei(source->id, AL_SOURCE_RELATIVE, AL_TRUE);
    }
    alSource3f(source->id, AL_POSITION, static_cast<float>(place.x), static_cast<float>(place.y),
               static_cast<float>(place.z));
    queue(*source, samples);
}

void OpenAlStreams::retire() {
    for (auto at = sources_.begin(); at != sources_.end();) {
        Source& source = at->second;
        ALint state = 0;
        alGetSourcei(source.id, AL_SOURCE_STATE, &state);
        if (!source.used && state != AL_PLAYING) {
            reclaim(source);
            alSourceRewind(source.id);
            alSourcei(source.id, AL_BUFFER, 0);
            idleSources_.push_back(source.id);
            at = sources_.erase(at);
        } else {
            source.used = false;
            ++at;
        }
    }
}

void OpenAlStreams::once(std::span<float const> samples, double gain) {
    constexpr std::size_t most = 8;
    auto free = std::find_if(once_.begin(), once_.end(), [](Once const& one) {
        ALint state = 0;
        alGetSourcei(one.source, AL_SOURCE_STATE, &state);
        return state != AL_PLAYING;
    });
    if (free == once_.end()) {
        Once made;
        alGetError();
        alGenSources(1, &made.source);
        if (once_.size() == most || alGetError() != AL_NO_ERROR) {
            if (made.source != 0) {
                alDeleteSources(1, &made.source);
            }
            return;
        }
        alGenBuffers(1, &made.buffer);
        free = once_.insert(once_.end(), made);
    }
    std::vector<float> scaled(samples.size());
    std::transform(samples.begin(), samples.end(), scaled.begin(),
                   [this](float s) { return s * static_cast<float>(1 / fullScale_); });
    alSourcei(free->source, AL_BUFFER, 0);
    alBufferData(free->buffer, AL_FORMAT_MONO_FLOAT32, scaled.data(),
                 static_cast<ALsizei>(scaled.size() * sizeof(float)), rate_);
    alSourcei(free->source, AL_BUFFER, static_cast<ALint>(free->buffer));
    alSourcei(free->source, AL_SOURCE_RELATIVE, AL_TRUE);
    alSource3f(free->source, AL_POSITION, 0, 0, -1);
    alSourcef(free->source, AL_GAIN, static_cast<float>(gain));
    alSourcePlay(free->source);
}

void OpenAlStreams::stop() {
    for (auto& [stream, source] : sources_) {
        alSourceRewind(source.id);
        alSourcei(source.id, AL_BUFFER, 0);
        idleSources_.push_back(source.id);
    }
    sources_.clear();
    idleBuffers_ = allBuffers_;
}

void OpenAlStreams::destroy() {
    stop();
    for (Once const& one : once_) {
        alDeleteSources(1, &one.source);
        alDeleteBuffers(1, &one.buffer);
    }
    once_.clear();
    alDeleteSources(static_cast<ALsizei>(allSources_.size()), allSources_.data());
    alDeleteBuffers(static_cast<ALsizei>(allBuffers_.size()), allBuffers_.data());
}

} // namespace trembler
