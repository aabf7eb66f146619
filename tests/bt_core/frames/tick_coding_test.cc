#include "bt_core/frames/tick_coding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "tests/bt_core/frames/kept_history.h"

namespace coppice {
namespace {

using namespace std::chrono_literals;  // NOLINT(google-build-using-namespace)
using ::testing::EndsWith;
using ::testing::StartsWith;

constexpr TreeSize kSize{1000, 100};

Bytes Encode(const TickEvents& tick) {
  Bytes bytes;
  TickEncoder encoder;
  encoder.Encode(tick, bytes);
  return bytes;
}

std::string DecodeOne(const Bytes& bytes, const TreeSize& size = kSize) {
  Decoder in(bytes.data(), bytes.data() + bytes.size());
  TickDecoder decoder;
  const auto tick = decoder.Decode(in, size);
  return tick && in.ok() && in.at_end() ? Describe(*tick) : "(nonsense)";
}

TEST(TickCoding, BringsBackEveryKindOfEvent) {
  EventWriter words;
  words.Status(NodeIndex{7}, Status::kSuccess);
  words.Reset(NodeIndex{999});
  words.Add(EventCode::kWrite, 99, 3, std::string("\2\1", 2));
  words.Add(EventCode::kWrite, 0, kNoNode, std::string("\0", 1));
  words.Add(EventCode::kDelivery, 50, 0, "\1text");
  words.Text(NodeIndex{3}, EventText::kMessage, "because");
  words.Text(NodeIndex{3}, EventText::kException, "");
  words.Text(NodeIndex{3}, EventText::kInjected, "\2");
  words.Status(kRootNode, Status::kSkipped);
  const TickEvents tick{5, Time(1700000000s), 1234us, Status::kFailure, true, words.words()};
  EXPECT_EQ(DecodeOne(Encode(tick)), Describe(tick));
  const TickEvents part{5, Time(-1s), 0us, Status::kIdle, false, words.words()};
  EXPECT_EQ(DecodeOne(Encode(part)), Describe(part));
}

TEST(TickCoding, ATickOfLessThanNoTimeHasNone) {
  const TickEvents back{5, Time(1s), -2s, Status::kSuccess, true, {}};
  const TickEvents told{5, Time(1s), 0s, Status::kSuccess, true, {}};
  EXPECT_EQ(DecodeOne(Encode(back)), Describe(told));
}

TEST(TickCoding, BringsBackAnySequenceOfNumbersAndTimes) {
  TickEncoder encoder;
  TickDecoder decoder;
  encoder.Restart(77, Time(5s));
  decoder.Restart(77, Time(5s));
  for (const std::uint64_t number : {78ull, 78ull, 79ull, 5000ull, 3ull, ~0ull, 0ull}) {
    for (const Time time : {Time{}, Time(5s), Time(5100ms), Time(Duration(-1)), Time::max()}) {
      const TickEvents tick{number, time, 0us, Status::kRunning, true, {}};
      Bytes bytes;
      encoder.Encode(tick, bytes);
      Decoder in(bytes.data(), bytes.data() + bytes.size());
      const auto decoded = decoder.Decode(in, kSize);
      ASSERT_TRUE(decoded);
      EXPECT_EQ(Describe(*decoded), Describe(tick));
    }
  }
}

TEST(TickCoding, CountsTheTicksThatHadTheEventsOfTheOneBeforeThem) {
  EventWriter same;
  same.Status(NodeIndex{7}, Status::kSuccess);
  same.Add(EventCode::kDelivery, 50, 0, "\1text");
  EventWriter other;
  other.Status(NodeIndex{7}, Status::kFailure);
  TickEncoder encoder;
  TickDecoder decoder;
  std::vector<std::uint64_t> repetitions;
  std::uint64_t number = 0;
  for (const EventWriter* words : {&same, &same, &same, &other, &same, &same}) {
    const TickEvents tick{++number, Time(0s), 0us, Status::kSuccess, true, words->words()};
    Bytes bytes;
    encoder.Encode(tick, bytes);
    repetitions.push_back(encoder.repetitions());
    Decoder in(bytes.data(), bytes.data() + bytes.size());
    EXPECT_EQ(Describe(*decoder.Decode(in, kSize)), Describe(tick));
  }
  EXPECT_EQ(repetitions, (std::vector<std::uint64_t>{0, 1, 2, 0, 0, 1}));
  encoder.Restart(number, Time(0s));
  Bytes bytes;
  encoder.Encode({++number, Time(0s), 0us, Status::kSuccess, true, same.words()}, bytes);
  EXPECT_EQ(encoder.repetitions(), 0U) << "what follows the tree has been set anew";
}

TEST(TickCoding, AStatusOfANodeNearbyIsOneByte) {
  EventWriter words;
  for (NodeIndex node{0}; node < 1000; ++node) words.Status(node, Status::kSuccess);
  const TickEvents tick{1, Time(0s), 0us, Status::kSuccess, true, words.words()};
  EXPECT_LE(Encode(tick).size(), 1000u + 6u);
}

TEST(TickCoding, ATickAtRegularTimesHasFiveBytesBesideItsEvents) {
  TickEncoder encoder;
  Bytes bytes;
  for (std::uint64_t i = 1; i <= 3; ++i) {
    bytes.clear();
    encoder.Encode({i, Time(i * 100ms), 80us, Status::kRunning, true, {}}, bytes);
  }
  EXPECT_LE(bytes.size(), 5u);
}

TEST(TickCoding, RefusesNodesAndSlotsThatThereAreNot) {
  EventWriter words;
  words.Status(NodeIndex{10}, Status::kSuccess);
  words.Add(EventCode::kWrite, 20, 30, "\1x");
  const Bytes bytes = Encode({1, Time(0s), 0us, Status::kSuccess, true, words.words()});
  EXPECT_NE(DecodeOne(bytes, {31, 21}), "(nonsense)");
  EXPECT_EQ(DecodeOne(bytes, {30, 21}), "(nonsense)") << "the writer";
  EXPECT_EQ(DecodeOne(bytes, {10, 21}), "(nonsense)") << "the node";
  EXPECT_EQ(DecodeOne(bytes, {31, 20}), "(nonsense)") << "the slot";
}

TEST(TickCoding, RefusesATickThatIsCutOff) {
  EventWriter words;
  words.Text(NodeIndex{10}, EventText::kMessage, "because");
  const Bytes bytes = Encode({1, Time(5s), 300us, Status::kSuccess, true, words.words()});
  for (std::size_t size = 0; size < bytes.size(); ++size) {
    EXPECT_EQ(DecodeOne(Bytes(bytes.begin(), bytes.begin() + static_cast<long>(size))),
              "(nonsense)");
  }
}

TEST(TickCoding, AnyBytesAreATickOrRefused) {
  std::mt19937 random(4);
  int ticks = 0;
  for (int i = 0; i < 200000; ++i) {
    Bytes bytes(random() % 30);
    for (std::uint8_t& byte : bytes) byte = static_cast<std::uint8_t>(random() % 40);
    ticks += DecodeOne(bytes) != "(nonsense)";
  }
  EXPECT_GT(ticks, 100);
}

TEST(TickCoding, CutsLongValuesAndSaysSo) {
  const std::string json = "\7[" + std::string(100000, '1') + "]";
  const std::string cut = CutValue(json);
  EXPECT_EQ(cut.size(), kMaxValueBytes);
  EXPECT_THAT(PrintValueBytes(cut), StartsWith("[1111"));
  EXPECT_THAT(PrintValueBytes(cut), EndsWith("111... (cut: 100002 bytes)"));
  EXPECT_EQ(CutValue("\1short"), "\1short");
}

TEST(TickCoding, CutsNoCharacterIntoPieces) {
  std::string text;
  for (int i = 0; i < 100; ++i) text += "\u20ac";
  for (std::size_t limit = 40; limit < 50; ++limit) {
    const std::string cut = CutText(text, limit);
    EXPECT_LE(cut.size(), limit);
    EXPECT_EQ(cut.find("...") % 3, 0u) << cut;
  }
}

TEST(TickCoding, CutsValuesShorterWhereThereIsMuchAlready) {
  EventWriter words;
  const std::string value = "\1" + std::string(60000, 'x');
  for (int i = 0; i < 1000; ++i) words.Add(EventCode::kWrite, 1, 1, value);
  const Bytes bytes = Encode({1, Time(0s), 0us, Status::kSuccess, true, words.words()});
  EXPECT_LT(bytes.size(), 10u << 20);
  EXPECT_NE(DecodeOne(bytes), "(nonsense)");
}

}  // namespace
}  // namespace coppice
