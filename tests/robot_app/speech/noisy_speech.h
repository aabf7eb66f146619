// Sentences as a visitor says them in a noisy place: by a voice of espeak-ng, in pink noise.
#ifndef COPPICE_TESTS_ROBOT_APP_SPEECH_NOISY_SPEECH_H_
#define COPPICE_TESTS_ROBOT_APP_SPEECH_NOISY_SPEECH_H_

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "robot_app/speech/mouth/synthesizer.h"

namespace coppice::robot::speech {

/// Equal power in each octave (the filter of P. Kellet, 1999).
inline std::vector<double> PinkNoise(std::size_t count, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> white;
  double slow = 0, middle = 0, fast = 0;
  std::vector<double> noise(count);
  for (double& value : noise) {
    const double w = white(random);
    slow = 0.99765 * slow + 0.0990460 * w;
    middle = 0.96300 * middle + 0.2965164 * w;
    fast = 0.57000 * fast + 1.0526913 * w;
    value = slow + middle + fast + 0.1848 * w;
  }
  return noise;
}

inline double PowerOf(const std::vector<double>& samples) {
  double sum = 0;
  for (const double sample : samples) sum += sample * sample;
  return sum / static_cast<double>(samples.size());
}

/// The sound with that much silence from a moment on [s].
inline Sound WithPause(const Sound& sound, double moment, double seconds) {
  const auto at = std::min(static_cast<std::size_t>(sound.rate * moment), sound.samples.size());
  Sound paused = sound;
  paused.samples.insert(paused.samples.begin() + static_cast<std::ptrdiff_t>(at),
                        static_cast<std::size_t>(sound.rate * seconds), 0);
  return paused;
}

/// When the last sample is as loud as 2 % of the loudest one [s].
inline double LastSoundOf(const Sound& sound) {
  int loudest = 0;
  for (const int sample : sound.samples) loudest = std::max(loudest, std::abs(sample));
  const auto last = std::find_if(sound.samples.rbegin(), sound.samples.rend(),
                                 [loudest](int sample) { return std::abs(sample) > loudest / 50; });
  return static_cast<double>(sound.samples.rend() - last) / sound.rate;
}

/// The sound at half its loudness, with some seconds before and behind it, in noise whose power
/// lies `snr` below that of the speech [dB].
inline Sound InNoise(const Sound& speech, double snr, unsigned seed, double seconds = 0.3) {
  const std::vector<double> said(speech.samples.begin(), speech.samples.end());
  const auto around = static_cast<std::size_t>(speech.rate * seconds);
  const std::vector<double> noise = PinkNoise(said.size() + 2 * around, seed);
  const double gain = std::sqrt(PowerOf(said) / PowerOf(noise) / std::pow(10, snr / 10));
  Sound sound{speech.rate, std::vector<std::int16_t>(noise.size())};
  for (std::size_t i = 0; i < noise.size(); ++i) {
    const bool is_said = i >= around && i < around + said.size();
    const double value = 0.5 * ((is_said ? said[i - around] : 0) + gain * noise[i]);
    sound.samples[i] = static_cast<std::int16_t>(std::clamp(value, -32767.0, 32767.0));
  }
  return sound;
}

}  // namespace coppice::robot::speech

#endif  // COPPICE_TESTS_ROBOT_APP_SPEECH_NOISY_SPEECH_H_
