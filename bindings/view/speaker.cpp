#include "view/speaker.hpp"

#include <SDL.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "base/check.hpp"

namespace pantin {

namespace {

/// One mode of what is struck.
struct Mode {
  double ratio;  // of its frequency to the lowest
  double loud;   // at first
  double time;   // [s] in which it falls to 1/e
};

struct Instrument {
  double frequency;  // [1/s] of the lowest mode
  double knock;      // how loud the stroke itself is heard
  std::span<const Mode> modes;
};

// Ratios of a bar with free ends: 2.756, 5.404, 8.933; of a bowl's bending modes about n².
constexpr Mode of_wood[] = {{1.0, 1.0, 0.08}, {2.756, 0.5, 0.04}, {5.404, 0.25, 0.02}, {8.933, 0.1, 0.012}};
constexpr Mode of_metal[] = {
    {1.0, 0.8, 0.7}, {2.756, 1.0, 0.5}, {5.404, 0.7, 0.3}, {8.933, 0.4, 0.2}, {13.34, 0.2, 0.1}};
constexpr Mode of_glass[] = {
    {1.0, 1.0, 0.3}, {2.32, 0.7, 0.2}, {4.25, 0.5, 0.12}, {6.63, 0.3, 0.08}, {9.38, 0.15, 0.05}};
constexpr Mode of_rubber[] = {{1.0, 1.0, 0.05}, {1.6, 0.4, 0.03}, {2.9, 0.1, 0.015}};
constexpr Mode of_blip[] = {{1.0, 1.0, 0.06}, {3.0, 0.33, 0.05}, {5.0, 0.2, 0.04}};

Instrument instrument_of(SoundKind kind) {
  switch (kind) {
    case SoundKind::wood: return {260.0, 0.25, of_wood};
    case SoundKind::metal: return {520.0, 0.15, of_metal};
    case SoundKind::glass: return {1100.0, 0.15, of_glass};
    case SoundKind::rubber: return {110.0, 0.1, of_rubber};
    case SoundKind::blip: return {660.0, 0.0, of_blip};
    case SoundKind::noise: break;
  }
  return {0.0, 1.0, {}};
}

constexpr double two_pi = 6.283185307179586;
constexpr double loudest = 0.7;         // of a sound that is alone
constexpr double rise = 0.001;          // [s] so that it does not click
constexpr double knock_time = 0.004;    // [s] in which a stroke falls to 1/e
constexpr double noise_time = 0.12;     // [s] the same of noise
constexpr double silence = 7.0;         // times of decay, after which nothing is heard
constexpr std::size_t most_kept = 256;  // sounds
constexpr double pitches = 24.0;        // steps of pitch in an octave

/// A sine that dies away, by its recurrence.
void add_mode(Samples& samples, double frequency, double loud, double time) {
  if (frequency > 0.45 * sound_rate) return;
  const double fall = std::exp(-1.0 / (time * sound_rate)), angle = two_pi * frequency / sound_rate;
  const double a = 2.0 * fall * std::cos(angle), b = -fall * fall;
  double before = 0.0, now = loud * fall * std::sin(angle);
  for (std::size_t i = 1; i < samples.size(); i++) {
    samples[i] += static_cast<float>(now);
    before = std::exchange(now, a * now + b * before);
  }
}

/// Noise through a low pass of one pole.
void add_noise(Samples& samples, double loud, double time, double smooth) {
  const double fall = std::exp(-1.0 / (time * sound_rate));
  std::uint32_t random = 2463534242u;
  double now = 0.0, size = loud;
  for (float& sample : samples) {
    random ^= random << 13;
    random ^= random >> 17;
    random ^= random << 5;
    now += (1.0 - smooth) * (random / 2147483648.0 - 1.0 - now);
    sample += static_cast<float>(size * now);
    size *= fall;
  }
}

void finish(Samples& samples) {
  const std::size_t first = std::min(samples.size(), static_cast<std::size_t>(rise * sound_rate));
  for (std::size_t i = 0; i < first; i++) samples[i] *= static_cast<float>(i) / static_cast<float>(first);
  float largest = 0.0f;
  for (const float sample : samples) largest = std::max(largest, std::fabs(sample));
  if (largest > 0.0f)
    for (float& sample : samples) sample *= static_cast<float>(loudest) / largest;
}

}  // namespace

Samples synthesize(SoundKind kind, double pitch) {
  const Instrument instrument = instrument_of(kind);
  double longest = kind == SoundKind::noise ? noise_time : knock_time;
  for (const Mode& mode : instrument.modes) longest = std::max(longest, mode.time);
  const double slower = 1.0 / std::sqrt(pitch);  // what is larger sounds longer
  Samples samples(static_cast<std::size_t>(silence * longest * slower * sound_rate));
  for (const Mode& mode : instrument.modes)
    add_mode(samples, instrument.frequency * pitch * mode.ratio, mode.loud, mode.time * slower);
  if (kind == SoundKind::noise)
    add_noise(samples, 1.0, noise_time * slower, std::exp(-0.5 * pitch));
  else if (instrument.knock > 0.0)
    add_noise(samples, instrument.knock, knock_time, 0.5);
  finish(samples);
  return samples;
}

Samples samples_of_file(const std::string& path, double pitch) {
  SDL_AudioSpec spec{};
  Uint8* bytes = nullptr;
  Uint32 size = 0;
  require(SDL_LoadWAV(path.c_str(), &spec, &bytes, &size) != nullptr, path,
          ": this sound cannot be read: ", SDL_GetError());
  const std::unique_ptr<Uint8, decltype(&SDL_FreeWAV)> owner(bytes, SDL_FreeWAV);
  SDL_AudioCVT convert;
  const int from = static_cast<int>(std::lround(spec.freq * pitch));
  require(SDL_BuildAudioCVT(&convert, spec.format, spec.channels, from, AUDIO_F32SYS, 1, sound_rate) >= 0, path,
          ": this sound cannot be read: ", SDL_GetError());
  std::vector<Uint8> work(static_cast<std::size_t>(size) * static_cast<std::size_t>(std::max(1, convert.len_mult)));
  std::copy(bytes, bytes + size, work.begin());
  convert.buf = work.data();
  convert.len = static_cast<int>(size);
  convert.len_cvt = convert.len;
  if (convert.needed) SDL_ConvertAudio(&convert);
  Samples samples(static_cast<std::size_t>(convert.len_cvt) / sizeof(float));
  std::copy_n(work.data(), samples.size() * sizeof(float), reinterpret_cast<Uint8*>(samples.data()));
  return samples;
}

void Mixer::begin(std::shared_ptr<const Samples> samples, double volume) {
  Voice voice{std::move(samples), 0, static_cast<float>(volume)};
  if (voices_.size() < most_voices) return voices_.push_back(std::move(voice));
  *std::min_element(voices_.begin(), voices_.end(),
                    [](const Voice& a, const Voice& b) { return a.left() < b.left(); }) = std::move(voice);
}

void Mixer::mix(float* out, std::size_t count) {
  std::fill_n(out, count, 0.0f);
  for (Voice& voice : voices_) {
    const std::size_t part = std::min(count, voice.left());
    for (std::size_t i = 0; i < part; i++) out[i] += voice.volume * (*voice.samples)[voice.at + i];
    voice.at += part;
  }
  std::erase_if(voices_, [](const Voice& voice) { return voice.left() == 0; });
  for (std::size_t i = 0; i < count; i++) out[i] = std::tanh(out[i]);
}

Speaker::Speaker() = default;

Speaker::~Speaker() {
  if (device_) SDL_CloseAudioDevice(device_);
  if (tried_) SDL_QuitSubSystem(SDL_INIT_AUDIO);
}

void Speaker::fill(void* self, std::uint8_t* bytes, int size) {
  static_cast<Speaker*>(self)->mixer_.mix(reinterpret_cast<float*>(bytes),
                                          static_cast<std::size_t>(size) / sizeof(float));
}

std::string Speaker::open() {
  tried_ = true;
  SDL_AudioSpec wanted{};
  wanted.freq = sound_rate;
  wanted.format = AUDIO_F32SYS;
  wanted.channels = 1;
  wanted.samples = 1024;
  wanted.callback = fill;
  wanted.userdata = this;
  if (SDL_InitSubSystem(SDL_INIT_AUDIO) == 0) device_ = SDL_OpenAudioDevice(nullptr, 0, &wanted, nullptr, 0);
  if (!device_) return text("sounds are not heard: ", SDL_GetError());
  SDL_PauseAudioDevice(device_, 0);
  return "";
}

std::shared_ptr<const Samples> Speaker::samples_of(const SoundCall& call) {
  const int step = static_cast<int>(std::lround(pitches * std::log2(call.pitch)));
  const double pitch = std::exp2(step / pitches);
  const auto kind = sound_kind(call.name);
  if (made_.size() >= most_kept) made_.clear();
  auto& samples = made_[{call.name, step}];  // null stays where it cannot be read
  samples = std::make_shared<const Samples>(kind ? synthesize(*kind, pitch) : samples_of_file(call.name, pitch));
  return samples;
}

std::string Speaker::play(const SoundCall& call) {
  if (!tried_)
    if (const std::string why = open(); !why.empty()) return why;
  if (!device_) return "";
  const int step = static_cast<int>(std::lround(pitches * std::log2(call.pitch)));
  std::shared_ptr<const Samples> samples;
  if (const auto made = made_.find({call.name, step}); made != made_.end()) {
    samples = made->second;
  } else {
    try {
      samples = samples_of(call);
    } catch (const Error& error) { return error.what(); }
  }
  if (!samples || samples->empty()) return "";
  SDL_LockAudioDevice(device_);
  mixer_.begin(std::move(samples), call.volume);
  SDL_UnlockAudioDevice(device_);
  return "";
}

}  // namespace pantin
