#include "robot_app/speech/ear/pronunciations.h"

#include <gmock/gmock.h>

#include "robot_app/speech/ear/recognizer.h"

namespace coppice::robot::speech {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::IsEmpty;

const Pronunciations& Shipped() {
  static const Pronunciations shipped =
      Pronunciations::Load(std::string(kEnglishModel) + "/cmudict-en-us.dict").value();
  return shipped;
}

TEST(Pronunciations, AWordOfTheDictionaryIsSaidAsItSays) {
  EXPECT_THAT(Shipped().Of("library"), Contains("L AY B R EH R IY"));
}

TEST(Pronunciations, AFoldedContractionIsFound) {
  EXPECT_THAT(Shipped().Of("whats"), Contains("W AH T S"));
}

TEST(Pronunciations, ANameIsSaidAsBothLanguagesReadIt) {
  EXPECT_THAT(Shipped().Of("erlenhof"), ElementsAre("ER L AH N HH AA F", "EH R L EH N HH OW F"));
}

TEST(Pronunciations, ANumberIsSaidByItsDigitsOrWhole) {
  EXPECT_THAT(SpokenNumber("103"),
              ElementsAre(ElementsAre("one", "oh", "three"), ElementsAre("one", "zero", "three"),
                          ElementsAre("one", "hundred", "three"),
                          ElementsAre("one", "hundred", "and", "three")));
  EXPECT_THAT(SpokenNumber("120"), Contains(ElementsAre("one", "twenty")));
  EXPECT_THAT(SpokenNumber("2042"), Contains(ElementsAre("twenty", "forty", "two")));
  EXPECT_THAT(Shipped().Of("5"), Contains("F AY V"));
}

TEST(Pronunciations, NothingHasNoSound) { EXPECT_THAT(Shipped().Of("(("), IsEmpty()); }

TEST(Pronunciations, AFileThatIsNotThereIsAProblem) {
  EXPECT_EQ(Pronunciations::Load("/nowhere").problem(), "cannot read the dictionary /nowhere");
}

TEST(Arpabet, StressAndLengthAreLeftOut) {
  EXPECT_EQ(ArpabetOf("ˈoːɹ"), "OW R");
  EXPECT_EQ(ArpabetOf("ˌɑː"), "AA");
  EXPECT_EQ(ArpabetOf("ʔ"), "");
}

}  // namespace
}  // namespace coppice::robot::speech
