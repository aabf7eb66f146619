#include "robot_app/speech/mouth/synthesizer.h"

#include <gmock/gmock.h>

namespace coppice::robot::speech {
namespace {

using testing::ElementsAre;

TEST(Synthesizer, AVoiceThatIsNotThereIsAProblem) {
  EXPECT_EQ(Synthesizer().Speak("hello", {"no-such-voice", 150}).problem(),
            "espeak-ng has no voice \"no-such-voice\" (`espeak-ng --voices`)");
}

TEST(Synthesizer, FasterSpeechIsShorter) {
  const Synthesizer voice;
  EXPECT_LT(voice.Speak("where is the library", {"en-us", 250})->sound.seconds(),
            voice.Speak("where is the library", {"en-us", 120})->sound.seconds());
}

TEST(Synthesizer, MarkupIsReadOut) {
  const Synthesizer voice;
  EXPECT_GT(voice.Speak("<break time=\"99s\"/>", {"en-us", 150})->sound.seconds(), 0.5);
  EXPECT_LT(voice.Speak("<break time=\"99s\"/>", {"en-us", 150})->sound.seconds(), 20);
}

TEST(Synthesizer, AnyBytesAreSpokenSomehow) {
  EXPECT_TRUE(Synthesizer().Speak("\xff\xfe \x80", {"en-us", 150}));
  EXPECT_TRUE(Synthesizer().Speak("", {"en-us", 150}));
}

TEST(Synthesizer, TellsHowAVoiceReadsAWord) {
  EXPECT_THAT(Synthesizer().Phonemes("weber", "de"), ElementsAre("v", "ˈeː", "b", "ɜ"));
}

}  // namespace
}  // namespace coppice::robot::speech
