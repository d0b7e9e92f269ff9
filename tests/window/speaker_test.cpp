#include "view/speaker.hpp"

#include <SDL.h>

#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>

#include "base/check.hpp"
#include "support/process.hpp"

using namespace pantin;

namespace {

double loudness(const Samples& samples, double from, double to) {
  double sum = 0.0;
  const auto first = static_cast<std::size_t>(from * sound_rate), last = static_cast<std::size_t>(to * sound_rate);
  for (std::size_t i = first; i < last && i < samples.size(); i++)
    sum += static_cast<double>(samples[i]) * static_cast<double>(samples[i]);
  return std::sqrt(sum / static_cast<double>(last - first));
}

/// [1/s] by how often it crosses zero.
double frequency(const Samples& samples, double from, double to) {
  int crossings = 0;
  const auto first = static_cast<std::size_t>(from * sound_rate), last = static_cast<std::size_t>(to * sound_rate);
  for (std::size_t i = first + 1; i < last; i++) crossings += (samples[i - 1] < 0.0f) != (samples[i] < 0.0f);
  return crossings / (2.0 * (to - from));
}

/// A second of a tone as a .wav file, of 8000 samples a second of 16 bits.
std::string wav_of(double tone) {
  std::string bytes;
  const auto put = [&](std::uint32_t value, int size) {
    for (int i = 0; i < size; i++) bytes += static_cast<char>(value >> 8 * i & 0xff);
  };
  constexpr int rate = 8000;
  bytes = "RIFF";
  put(36 + 2 * rate, 4);
  bytes += "WAVEfmt ";
  put(16, 4);
  put(1, 2);
  put(1, 2);
  put(rate, 4);
  put(2 * rate, 4);
  put(2, 2);
  put(16, 2);
  bytes += "data";
  put(2 * rate, 4);
  for (int i = 0; i < rate; i++)
    put(static_cast<std::uint32_t>(std::lround(20000.0 * std::sin(6.283185307179586 * tone * i / rate))), 2);
  return bytes;
}

}  // namespace

TEST_CASE("speaker: each sound begins loud, dies away and stays within bounds") {
  for (std::size_t i = 0; i < sound_names.size(); i++) {
    CAPTURE(sound_names[i]);
    for (const double pitch : {0.125, 1.0, 8.0}) {
      CAPTURE(pitch);
      const Samples samples = synthesize(static_cast<SoundKind>(i), pitch);
      REQUIRE(samples.size() > 100);
      CHECK(samples.size() < static_cast<std::size_t>(16 * sound_rate));
      CHECK(std::ranges::all_of(samples, [](float s) { return std::fabs(s) <= 1.0f; }));
      const double all = static_cast<double>(samples.size()) / sound_rate;
      CHECK(loudness(samples, 0.0, 0.1 * all) > 0.01);
      CHECK(loudness(samples, 0.9 * all, all) < 0.02 * loudness(samples, 0.0, 0.1 * all));
      CHECK(samples == synthesize(static_cast<SoundKind>(i), pitch));
    }
  }
}

TEST_CASE("speaker: pitch is a factor of the frequency, and metal sounds longer than wood") {
  // When the higher modes are gone, what is left is the lowest.
  const Samples low = synthesize(SoundKind::wood, 1.0), high = synthesize(SoundKind::wood, 2.0);
  CHECK(frequency(low, 0.25, 0.45) == Approx(260.0).epsilon(0.03));
  CHECK(frequency(high, 0.2, 0.35) == Approx(520.0).epsilon(0.03));
  CHECK(loudness(synthesize(SoundKind::metal, 1.0), 0.4, 0.5) > 20.0 * loudness(low, 0.4, 0.5));
}

TEST_CASE("speaker: a file is heard at its pitch, and what is none is an error") {
  const support::Folder folder;
  support::write_file(folder / "tone.wav", wav_of(400.0));
  const Samples usual = samples_of_file(folder / "tone.wav", 1.0), higher = samples_of_file(folder / "tone.wav", 2.0);
  CHECK(static_cast<double>(usual.size()) == Approx(sound_rate).epsilon(0.02));
  CHECK(static_cast<double>(higher.size()) == Approx(0.5 * sound_rate).epsilon(0.02));
  CHECK(frequency(usual, 0.2, 0.8) == Approx(400.0).epsilon(0.02));
  CHECK(frequency(higher, 0.1, 0.4) == Approx(800.0).epsilon(0.02));
  support::write_file(folder / "none.wav", "hello");
  CHECK_THROWS_AS(samples_of_file(folder / "none.wav", 1.0), Error);
}

TEST_CASE("speaker: so many are heard at once; one too many takes the place of that nearest to its end") {
  Mixer mixer;
  const auto tone = std::make_shared<const Samples>(1000, 0.25f), brief = std::make_shared<const Samples>(10, 0.25f);
  mixer.begin(tone, 1.0);
  mixer.begin(tone, 0.5);
  float out[100];
  mixer.mix(out, 100);
  CHECK(out[50] == Approx(std::tanh(0.375)));
  for (std::size_t i = 2; i < Mixer::most_voices; i++) mixer.begin(brief, 1.0);
  CHECK(mixer.voices() == Mixer::most_voices);
  mixer.begin(tone, 1.0);
  CHECK(mixer.voices() == Mixer::most_voices);
  mixer.mix(out, 100);
  CHECK(mixer.voices() == 3);
  CHECK(std::ranges::all_of(out, [](float s) { return std::fabs(s) <= 1.0f; }));
  for (int i = 0; i < 10; i++) mixer.mix(out, 100);
  CHECK(mixer.voices() == 0);
  CHECK(out[99] == 0.0f);
}

TEST_CASE("speaker: without a device that is told once, and the rest is silence", "[window]") {
  SDL_SetHintWithPriority("SDL_AUDIODRIVER", "no such driver", SDL_HINT_OVERRIDE);
  Speaker speaker;
  CHECK_THAT(speaker.play({"wood"}), Catch::StartsWith("sounds are not heard: "));
  CHECK(speaker.play({"wood"}).empty());
  SDL_SetHintWithPriority("SDL_AUDIODRIVER", "dummy", SDL_HINT_OVERRIDE);
  Speaker heard;
  CHECK(heard.play({"glass", 0.5, 2.0}).empty());
  CHECK_THAT(heard.play({"/none.wav"}), Catch::Contains("/none.wav: this sound cannot be read"));
  CHECK(heard.play({"/none.wav"}).empty());
  SDL_SetHintWithPriority("SDL_AUDIODRIVER", "", SDL_HINT_OVERRIDE);
}
