#include "robot_app/speech/ear/noise_reduction.h"

#include <gtest/gtest.h>

#include <cmath>

#include "robot_app/speech/mouth/synthesizer.h"
#include "tests/robot_app/speech/noisy_speech.h"

namespace coppice::robot::speech {
namespace {

constexpr double kAround = 0.5;  // s of noise alone

Sound Said() {
  return Resampled(Synthesizer().Speak("where is the library", {"en-us+f2", 150})->sound,
                   kHearingRate);
}

// Of samples `from` to `to` [dB].
double Level(const Sound& sound, std::size_t from, std::size_t to) {
  const std::vector<double> part(sound.samples.begin() + static_cast<long>(from),
                                 sound.samples.begin() + static_cast<long>(to));
  return 10 * std::log10(PowerOf(part) + 1);
}

TEST(NoiseReduction, NoiseAloneBecomesQuietAndSpeechStays) {
  const Sound noisy = InNoise(Said(), 10, 1, kAround);
  const Sound clear = WithoutNoise(noisy);
  ASSERT_EQ(clear.samples.size(), noisy.samples.size());
  const auto begin = static_cast<std::size_t>(kAround * kHearingRate);
  EXPECT_LT(Level(clear, 0, begin), Level(noisy, 0, begin) - 12);
  const std::size_t end = noisy.samples.size() - begin;
  EXPECT_NEAR(Level(clear, begin, end), Level(noisy, begin, end), 1);
}

TEST(NoiseReduction, WithoutNoiseASoundStaysWhatItIs) {
  const Sound quiet = InNoise(Said(), 60, 1, kAround);
  const Sound clear = WithoutNoise(quiet);
  std::vector<double> difference, said(quiet.samples.begin(), quiet.samples.end());
  for (std::size_t i = 0; i < said.size(); ++i) difference.push_back(clear.samples[i] - said[i]);
  EXPECT_LT(PowerOf(difference), 0.02 * PowerOf(said));
}

TEST(NoiseReduction, WhatIsTooShortOrSilentStaysWhatItIs) {
  const Sound click{kHearingRate, std::vector<std::int16_t>(1000, 500)};
  EXPECT_EQ(WithoutNoise(click).samples, click.samples);
  const Sound silence{kHearingRate, std::vector<std::int16_t>(16000)};
  EXPECT_EQ(WithoutNoise(silence).samples, silence.samples);
}

}  // namespace
}  // namespace coppice::robot::speech
