#pragma once
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "scene/sound.hpp"

namespace pantin {

/// Samples of one channel, -1 to 1.
using Samples = std::vector<float>;
constexpr int sound_rate = 44100;  ///< [1/s]

/// A sound as of something struck: the first modes of a bar, a bell or a bowl, each a sine that dies away; or a tone, or
/// noise. Ratios of frequencies: Rossing and Fletcher, The Physics of Musical Instruments, chapters 2, 3 and 21.
Samples synthesize(SoundKind kind, double pitch);
/// Of a .wav file, at the pitch; throws Error where it cannot be read.
Samples samples_of_file(const std::string& path, double pitch);

/// Sounds that are heard at once, mixed. Not thread safe by itself.
class Mixer {
 public:
  static constexpr std::size_t most_voices = 24;

  /// One too many takes the place of that which is nearest to its end.
  void begin(std::shared_ptr<const Samples> samples, double volume);
  /// Writes the next samples, -1 to 1.
  void mix(float* out, std::size_t count);
  std::size_t voices() const { return voices_.size(); }

 private:
  struct Voice {
    std::shared_ptr<const Samples> samples;
    std::size_t at = 0;
    float volume = 1.0f;
    std::size_t left() const { return samples->size() - at; }
  };
  std::vector<Voice> voices_;
};

/// Lets sounds be heard. The device is opened with the first; where there is none, or a file cannot be read, that is told
/// once, and the rest is silence.
class Speaker {
 public:
  Speaker();
  ~Speaker();
  Speaker(const Speaker&) = delete;
  Speaker& operator=(const Speaker&) = delete;

  /// Returns what is to be told, or "".
  std::string play(const SoundCall& call);

 private:
  static void fill(void* self, std::uint8_t* bytes, int size);
  std::string open();
  std::shared_ptr<const Samples> samples_of(const SoundCall& call);

  std::uint32_t device_ = 0;
  bool tried_ = false;
  Mixer mixer_;                                                                 ///< of the device's thread, too
  std::map<std::pair<std::string, int>, std::shared_ptr<const Samples>> made_;  ///< by name and pitch; null: none
};

}  // namespace pantin
