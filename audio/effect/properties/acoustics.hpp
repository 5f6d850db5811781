// The properties of objects that sound reads.
#pragma once

#include "runtime/property/description.hpp"

#include <array>
#include <string>
#include <vector>

namespace trembler {

/// The simple body that models an object's vibration.
enum class SoundingForm : int {
    automatic, ///< by its shape: long objects are bars, round ones balls, others plates; water splashes
    bar,
    plate,
    ball,
    bell,
};
template <>
inline constexpr std::array<std::string_view, 5> choiceNames<SoundingForm>{"automatic", "bar", "plate",
                                                                           "ball", "bell"};

/// The sound of an object if it must not follow from its shape and its material.
struct Acoustics {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Acoustics", "acoustics",
        "How the object vibrates, where this does not follow from its shape and material."};
    SoundingForm form = SoundingForm::automatic;
    double frequency = 0;         ///< Hz, of the lowest mode, or of the prime of a bell; 0: from the size
    double ringing = 0;           ///< s, until that mode has decayed by 60 dB; 0: by the material
    std::vector<double> partials; ///< frequencies divided by the lowest; empty: those of the form

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "form",
                        .unit = "",
                        .meaning = "kind of body whose modes it has; automatic: chosen by its shape"},
              self.form);
        visit(FieldInfo{.key = "frequency",
                        .unit = "Hz",
                        .meaning = "of the lowest mode, or of the prime of a bell; 0: computed from the size",
                        .minimum = 0,
                        .maximum = 20000},
              self.frequency);
        visit(FieldInfo{.key = "ringing",
                        .unit = "s",
                        .meaning = "time in which that mode decays by 60 dB; 0: computed from the material",
                        .minimum = 0,
                        .maximum = 60},
              self.ringing);
        visit(
            FieldInfo{.key = "partials",
                      .unit = "",
                      .meaning = "frequencies of all modes, divided by the lowest; empty: those of the form",
                      .minimum = 0.01,
                      .maximum = 1000,
                      .most = 64},
            self.partials);
    }
    friend bool operator==(Acoustics const&, Acoustics const&) = default;
};

/// When a recorded sample is played.
enum class SampleCue : int {
    struck,  ///< once for every impact
    powered, ///< repeated while the object is on
};
template <>
inline constexpr std::array<std::string_view, 2> choiceNames<SampleCue>{"struck", "powered"};

/// A recording that the object plays in addition to its own sound. Its loudness and duration are stated here,
/// not taken from the file: listeners in the world must not depend on the files of a loudspeaker.
struct Sample {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Sample", "sample", "A recording that the object plays."};
    std::string file;
    SampleCue cue = SampleCue::struck;
    double level = 80;      ///< dB at 1 m
    double duration = 1;    ///< s, of one play
    double fullImpulse = 1; ///< N s; softer impacts play it more quietly, in proportion

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "file",
                        .unit = "",
                        .meaning =
                            "name of an .ogg, .wav or .flac file in the level's folder or in assets/sounds",
                        .required = true},
              self.file);
        visit(FieldInfo{.key = "cue",
                        .unit = "",
                        .meaning = "struck: once for each impact; powered: repeated while the object is on"},
              self.cue);
        visit(FieldInfo{.key = "level_db",
                        .unit = "dB",
                        .meaning = "mean sound level at a distance of 1 m",
                        .minimum = 0,
                        .maximum = 140},
              self.level);
        visit(
            FieldInfo{
                .key = "duration", .unit = "s", .meaning = "of one play", .minimum = 0.01, .maximum = 600},
            self.duration);
        visit(FieldInfo{.key = "full_impulse",
                        .unit = "N s",
                        .meaning = "impulse from which on an impact plays it at its full level; weaker "
                                   "impacts play it more quietly, in proportion",
                        .minimum = 1e-6,
                        .maximum = 1e6},
              self.fullImpulse);
    }
    friend bool operator==(Sample const&, Sample const&) = default;
};

/// Marks an object that listens, to display the loudness there.
struct Ear {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{"Ear", "ear", "The sound level at the object is computed."};
};

/// A switch that closes while the sound is loud enough. If it names two objects, it connects these. Otherwise
/// it connects the conductors that touch it; it should not be a conductor itself, or it connects them always.
struct SoundSensor {
    static constexpr PropertyKind kind = PropertyKind::object;
    static constexpr PropertyText text{
        "Sound sensor", "sound_sensor",
        "A switch that is closed while the sound at the object is loud enough."};
    double threshold = 70; ///< dB(A)
    ObjectId a;
    ObjectId b;

    template <class Self, class Visitor>
    static void describe(Self& self, Visitor&& visit) {
        visit(FieldInfo{.key = "threshold_db",
                        .unit = "dB",
                        .meaning = "A-weighted sound level from which on it is closed",
                        .minimum = 0,
                        .maximum = 140},
              self.threshold);
        visit(FieldInfo{.key = "from",
                        .unit = "",
                        .meaning = "one of two conductors that it connects; left out: it connects the "
                                   "conductors that touch it"},
              self.a);
        visit(FieldInfo{.key = "to", .unit = "", .meaning = "the other one of the two conductors"}, self.b);
    }
    friend bool operator==(SoundSensor const&, SoundSensor const&) = default;
};

} // namespace trembler
