#include "robot_app/speech/sound/wav_file.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include <random>

#include "bt_core/base/read_file.h"
#include "tests/support/temporary_folder.h"

namespace coppice::robot::speech {
namespace {

Sound Ramp() {
  Sound sound{22050, {}};
  for (int i = 0; i < 2205; ++i) sound.samples.push_back(static_cast<std::int16_t>(i * 10));
  return sound;
}

TEST(WavFile, WhatIsWrittenIsRead) {
  TemporaryFolder folder;
  ASSERT_TRUE(WriteWav(folder.Path("a.wav"), Ramp()));
  const auto read = ReadWav(folder.Path("a.wav"));
  ASSERT_TRUE(read) << read.problem();
  EXPECT_EQ(read->rate, 22050);
  EXPECT_EQ(read->samples, Ramp().samples);
}

TEST(WavFile, AFileThatIsNoneIsAProblemWithItsName) {
  TemporaryFolder folder;
  const auto missing = ReadWav(folder.Path("no.wav"));
  ASSERT_FALSE(missing);
  EXPECT_NE(missing.problem().find("no.wav"), std::string::npos);
  EXPECT_EQ(ParseWav("{\"error\": 1}").problem(), "expected a WAV file");
}

TEST(WavFile, NobodyIsWaitedForWhoHasAPipeOpenAndSaysNothing) {
  const TemporaryFolder folder;
  const std::string pipe = folder.Path("pipe");
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  const int writer = open(pipe.c_str(), O_RDWR | O_CLOEXEC);
  EXPECT_EQ(ReadWav(pipe).problem(), pipe + ": expected a WAV file");
  close(writer);
}

TEST(WavFile, NoOtherKindOfSoundIsRead) {
  const std::string samples(1000, 'x');
  const std::string aiff =
      std::string("FORM\0\0\4\0AIFFCOMM\0\0\0\x12\0\1\0\0\1\0\0\x10", 28) + samples;
  EXPECT_EQ(ParseWav(aiff).problem(), "expected a WAV file");
  EXPECT_EQ(ParseWav("OggS" + samples).problem(), "expected a WAV file");
  EXPECT_EQ(ParseWav("RIFF").problem(), "expected a WAV file");
}

TEST(WavFile, AFileThatClaimsAnHourIsRefused) {
  std::string bytes = WavOf({8000, std::vector<std::int16_t>(8000 * 121)});
  EXPECT_EQ(ParseWav(bytes).problem(), "expected at most 120 s");
}

TEST(WavFile, ACutFileIsAsLongAsItIs) {
  const std::string bytes = WavOf(Ramp());
  const auto cut = ParseWav(bytes.substr(0, bytes.size() / 2));
  ASSERT_TRUE(cut) << cut.problem();
  EXPECT_LT(cut->samples.size(), Ramp().samples.size());
}

// Whatever a service of others or a visitor's file holds: a sound or a problem.
TEST(WavFile, AnyBytesEndInASoundOrAProblem) {
  const std::string good = WavOf(Ramp());
  std::mt19937 random(1);
  for (int round = 0; round < 3000; ++round) {
    std::string bytes = good.substr(0, 44 + random() % 200);
    for (int change = 0; change < 6; ++change) {
      bytes[random() % std::min<std::size_t>(bytes.size(), 60)] = static_cast<char>(random());
    }
    const auto sound = ParseWav(bytes);
    EXPECT_LE(sound ? sound->samples.size() : 0, std::size_t{120} * 192000);
  }
}

TEST(Sound, ResampledLastsAsLong) {
  const Sound half = Resampled(Ramp(), 16000);
  EXPECT_EQ(half.rate, 16000);
  EXPECT_NEAR(half.seconds(), Ramp().seconds(), 0.002);
}

}  // namespace
}  // namespace coppice::robot::speech
