#include "robot_app/speech/ear/ear.h"

#include <gtest/gtest.h>

#include <random>

#include "robot_app/speech/mouth/synthesizer.h"

namespace coppice::robot::speech {
namespace {

using Samples = std::vector<std::int16_t>;

Samples Noise(double seconds, double deviation, unsigned seed = 1) {
  std::mt19937 random(seed);
  std::normal_distribution<double> noise(0, deviation);
  Samples samples(static_cast<std::size_t>(seconds * kHearingRate));
  for (std::int16_t& sample : samples) sample = static_cast<std::int16_t>(noise(random));
  return samples;
}

Samples operator+(Samples a, const Samples& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// Somebody speaks in that noise.
Samples Spoken(const std::string& text, double deviation) {
  const Sound sound = Resampled(Synthesizer().Speak(text, {"en-us", 150})->sound, kHearingRate);
  Samples samples = Noise(sound.seconds(), deviation, 2);
  for (std::size_t i = 0; i < samples.size(); ++i) {
    samples[i] = static_cast<std::int16_t>(samples[i] + sound.samples[i] / 2);
  }
  return samples;
}

constexpr double kQuiet = 30, kLoud = 300;

class EarTest : public testing::Test {
 protected:
  // In pieces of 20 ms, as a microphone brings them.
  std::vector<Sound> Hear(Ear& ear, const Samples& samples) {
    std::vector<Sound> utterances;
    for (std::size_t at = 0; at < samples.size(); at += 320) {
      const std::size_t end = std::min(at + 320, samples.size());
      if (auto heard = ear.Hear(
              {samples.begin() + static_cast<long>(at), samples.begin() + static_cast<long>(end)},
              now_)) {
        last_pause_ = heard->pause;
        (heard->has_ended ? utterances : pauses_).push_back(std::move(heard->sound));
      }
      now_ += std::chrono::milliseconds(20);
    }
    return utterances;
  }

  Time now_{};
  std::vector<Sound> pauses_;  // what had been said until then
  int last_pause_ = 0;
};

TEST_F(EarTest, HearsAnUtteranceAsLongAsItIs) {
  Ear ear({}, Listening::kAlways);
  const Samples spoken = Spoken("where is the library", kQuiet);
  const auto heard = Hear(ear, Noise(1, kQuiet) + spoken + Noise(1, kQuiet));
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_NEAR(heard[0].seconds(), static_cast<double>(spoken.size()) / kHearingRate + 0.5, 0.5);
}

TEST_F(EarTest, WhatWasSaidUntilAPauseIsKnownBeforeItIsTheEnd) {
  Ear ear({}, Listening::kAlways);
  const Samples spoken = Spoken("library", kQuiet);
  Hear(ear, Noise(1, kQuiet) + spoken + Noise(0.4, kQuiet));
  ASSERT_EQ(pauses_.size(), 1U);
  const auto heard = Hear(ear, spoken + Noise(1, kQuiet));
  ASSERT_EQ(pauses_.size(), 2U);
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_GT(pauses_[1].samples.size(), pauses_[0].samples.size() + spoken.size() / 2);
  EXPECT_EQ(heard[0].samples, pauses_[1].samples);
}

TEST_F(EarTest, AnUtteranceThatIsAllMayEndInItsPause) {
  Ear ear({}, Listening::kAlways);
  Hear(ear, Noise(1, kQuiet) + Spoken("where is the library", kQuiet) + Noise(0.2, kQuiet));
  ASSERT_FALSE(pauses_.empty());
  EXPECT_TRUE(ear.hears());
  EXPECT_TRUE(ear.End(last_pause_));
  EXPECT_FALSE(ear.hears());
  EXPECT_FALSE(ear.End(last_pause_));
  EXPECT_TRUE(Hear(ear, Noise(2, kQuiet)).empty());  // it was told already
}

TEST_F(EarTest, WhoHasGoneOnSinceThePauseIsNotCut) {
  Ear ear({}, Listening::kAlways);
  const Samples spoken = Spoken("library", kQuiet);
  Hear(ear, Noise(1, kQuiet) + spoken + Noise(0.2, kQuiet));
  const int first = last_pause_;
  Hear(ear, Samples(spoken.begin(), spoken.begin() + kHearingRate / 5));
  EXPECT_FALSE(ear.End(first));
  Samples rest(spoken.begin() + kHearingRate / 5, spoken.end());
  Hear(ear, rest + Noise(0.2, kQuiet));
  EXPECT_FALSE(ear.End(first));  // another pause
  const auto heard = Hear(ear, Noise(1, kQuiet));
  ASSERT_EQ(heard.size(), 1U);
  EXPECT_GT(heard[0].samples.size(), 2 * spoken.size());
}

TEST_F(EarTest, APauseEndsNoLaterUtterance) {
  Ear ear({}, Listening::kAlways);
  const Samples spoken = Spoken("where is the library", kQuiet);
  Hear(ear, Noise(1, kQuiet) + spoken + Noise(0.2, kQuiet));
  const int first = last_pause_;
  EXPECT_EQ(Hear(ear, Noise(1, kQuiet)).size(), 1U);
  EXPECT_FALSE(ear.End(first));  // it is over
  Hear(ear, spoken);
  EXPECT_FALSE(ear.End(first));
  ear.set_speaks(true, now_);
  EXPECT_FALSE(ear.End(last_pause_));
}

TEST_F(EarTest, TwoUtterancesAreTwo) {
  Ear ear({}, Listening::kAlways);
  const Samples spoken = Spoken("where is the library", kQuiet);
  EXPECT_EQ(
      Hear(ear, Noise(1, kQuiet) + spoken + Noise(1, kQuiet) + spoken + Noise(1, kQuiet)).size(),
      2U);
}

TEST_F(EarTest, NoiseIsNoUtterance) {
  Ear ear({}, Listening::kAlways);
  EXPECT_TRUE(Hear(ear, Noise(10, kLoud)).empty());
}

TEST_F(EarTest, AKnockIsTooShort) {
  Ear ear({}, Listening::kAlways);
  EXPECT_TRUE(Hear(ear, Noise(1, kQuiet) + Noise(0.1, 8000) + Noise(2, kQuiet)).empty());
}

TEST_F(EarTest, InALoudPlaceSpeechIsWhatIsLouder) {
  Ear ear({}, Listening::kAlways);
  EXPECT_EQ(
      Hear(ear, Noise(2, kLoud) + Spoken("where is the library", kLoud) + Noise(2, kLoud)).size(),
      1U);
}

TEST_F(EarTest, NeverHearsTheMouthNorItsEcho) {
  Ear ear({}, Listening::kAlways);
  Hear(ear, Noise(1, kQuiet));
  ear.set_speaks(true, now_);
  EXPECT_TRUE(Hear(ear, Spoken("follow me to the library", kQuiet)).empty());
  ear.set_speaks(false, now_);
  EXPECT_FALSE(ear.is_open(now_));
  EXPECT_TRUE(Hear(ear, Noise(0.35, 3000) + Noise(2, kQuiet)).empty());
  EXPECT_EQ(Hear(ear, Spoken("where is the library", kQuiet) + Noise(1, kQuiet)).size(), 1U);
}

TEST_F(EarTest, WhatWasBegunBeforeTheMouthSpokeIsDropped) {
  Ear ear({}, Listening::kAlways);
  Hear(ear, Noise(1, kQuiet) + Spoken("where is the library", kQuiet));
  ear.set_speaks(true, now_);
  ear.set_speaks(false, now_);
  now_ += std::chrono::seconds(1);
  EXPECT_TRUE(Hear(ear, Noise(2, kQuiet)).empty());
}

TEST_F(EarTest, WithPushToTalkItHearsOnlyWhileTheButtonIsHeld) {
  Ear ear({}, Listening::kPushToTalk);
  EXPECT_TRUE(Hear(ear, Noise(1, kQuiet) + Spoken("stop", kQuiet) + Noise(1, kQuiet)).empty());
  EXPECT_FALSE(ear.set_pressed(true, now_));
  Hear(ear, Noise(0.2, kQuiet) + Spoken("where is the library", kQuiet));
  const auto heard = ear.set_pressed(false, now_);
  ASSERT_TRUE(heard);
  EXPECT_GT(heard->sound.seconds(), 0.8);
  EXPECT_FALSE(ear.is_open(now_));
}

TEST_F(EarTest, AButtonOfWhichNobodySaysAnyMoreThatItIsHeldCountsAsLetGo) {
  Ear ear({}, Listening::kPushToTalk);
  for (int i = 0; i < 20; ++i) {
    ear.set_pressed(true, now_);
    now_ += std::chrono::milliseconds(500);
    EXPECT_TRUE(ear.is_open(now_)) << "the tablet says it all the time";
  }
  Hear(ear, Noise(0.2, kQuiet) + Spoken("where is the library", kQuiet));
  now_ += std::chrono::seconds(5);
  EXPECT_FALSE(ear.is_open(now_));
  EXPECT_TRUE(Hear(ear, Spoken("stop", kQuiet) + Noise(2, kQuiet)).empty());
  EXPECT_FALSE(ear.set_pressed(true, now_));
  Hear(ear, Noise(0.5, kQuiet));
  EXPECT_FALSE(ear.set_pressed(false, now_)) << "of what was said before nothing is left";
}

TEST_F(EarTest, FindsTheUtteranceInARecording) {
  const Ear ear({}, Listening::kAlways);
  EXPECT_TRUE(ear.HearWhole({kHearingRate, Spoken("where is the library", kQuiet)}));
  EXPECT_FALSE(ear.HearWhole({kHearingRate, Noise(2, kQuiet)}));
}

}  // namespace
}  // namespace coppice::robot::speech
