#include "bt_core/record/entry_coding.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

#include "tests/bt_core/record/recorded_tree.h"

namespace coppice {

struct Unprintable {};
template <>
struct ValueTraits<Unprintable> {
  static constexpr const char* kName = "Unprintable";
  static bool Parse(std::string_view, Unprintable&) { return false; }
  static std::string Print(const Unprintable&) { throw std::runtime_error("no words"); }
};

namespace {

using ::testing::ElementsAre;

Decoder Read(const Bytes& bytes) { return {bytes.data(), bytes.data() + bytes.size()}; }

class EntryCodingTest : public ::testing::Test {
 protected:
  RecordHeader Header(const Metadata& metadata = {}) {
    Bytes bytes;
    Encoder out(bytes);
    EncodeHeader(executor_, metadata, out);
    return DecodeHeader(Read(bytes)).value();
  }

  // The value as a tick that writes it to slot 0 brings it to the reader.
  RecordedValue BringOver(const Value& value) {
    Blackboard blackboard(1);
    blackboard[0].value = value;
    Bytes bytes;
    Encoder out(bytes);
    EncodeTick({1, Time(0), Status::kRunning, {}, {0}, {}, blackboard}, out);
    return DecodeTick(Read(bytes), Header()).value().writes.at(0).value;
  }

  LeafScript script_;
  SimulatedClock clock_{Time(1234)};
  Executor executor_{RecordedProgram(script_), clock_};
};

TEST_F(EntryCodingTest, DescribesTheTreeInTheHeader) {
  const RecordHeader header = Header({{"robot", "sobi"}, {"empty", ""}});
  EXPECT_EQ(header.main_tree, "Main");
  EXPECT_EQ(header.start, Time(1234));
  EXPECT_THAT(header.metadata, ElementsAre(std::pair<std::string, std::string>("robot", "sobi"),
                                           std::pair<std::string, std::string>("empty", "")));
  ASSERT_EQ(header.documents.size(), 1u);
  EXPECT_EQ(header.documents[0].file, "recorded.xml");
  EXPECT_EQ(header.documents[0].text, executor_.program().project->documents()[0].text());
  ASSERT_EQ(header.nodes.size(), 5u);
  EXPECT_EQ(header.nodes[1].path, "first");
  EXPECT_EQ(header.nodes[1].id, "Scripted");
  EXPECT_EQ(header.nodes[3].parent, 2u);
  EXPECT_EQ(header.nodes[3].element, executor_.program().info[3].element);
  EXPECT_EQ(header.slots.size(), executor_.blackboard().size());
  EXPECT_EQ(header.slots[0].scope + "/" + header.slots[0].key + ":" + header.slots[0].type,
            "Main/number:int");
}

TEST_F(EntryCodingTest, PutsTheStateOfARunningTreeInTheHeader) {
  script_.write = true;
  script_.number = -7;
  executor_.Tick();
  const RecordHeader header = Header();
  EXPECT_EQ(header.state.statuses, executor_.statuses());
  EXPECT_EQ(header.state.values[0], "-7");
}

TEST_F(EntryCodingTest, PrintsValuesAsTheTreeDoes) {
  for (const Value& value :
       {Value(true), Value(-5), Value(5u), Value(-5L), Value(UINT64_MAX), Value(0.1), Value(1e300),
        Value(std::string("a\0b", 3)), Value(std::string())}) {
    EXPECT_EQ(BringOver(value), value.Print()) << value.type()->name;
  }
  EXPECT_EQ(BringOver(Value()), std::nullopt);
  EXPECT_EQ(BringOver(Value(Unprintable())), "cannot be printed: no words");
}

TEST_F(EntryCodingTest, BringsOverAGapWithTheStateOfTheTree) {
  executor_.Tick();
  Bytes bytes;
  Encoder out(bytes);
  EncodeGap({Time(5), 3, 10, 12, 2, {}}, executor_.statuses(), executor_.blackboard(), out);
  const RecordedGap gap = DecodeGap(Read(bytes), Header()).value();
  EXPECT_EQ(gap.time, Time(5));
  EXPECT_EQ(gap.lost_ticks, 3u);
  EXPECT_EQ(gap.first_tick, 10u);
  EXPECT_EQ(gap.last_tick, 12u);
  EXPECT_EQ(gap.lost_notes, 2u);
  EXPECT_EQ(gap.state.statuses, executor_.statuses());
  EXPECT_EQ(gap.state.values.size(), executor_.blackboard().size());
}

TEST_F(EntryCodingTest, RefusesWhatDoesNotMakeSense) {
  const RecordHeader header = Header();
  const auto decode = [&](const std::vector<StatusChange>& changes,
                          const std::vector<NodeMessage>& messages) {
    Bytes bytes;
    Encoder out(bytes);
    EncodeTick({1, Time(0), Status::kRunning, changes, {}, messages, {}}, out);
    return DecodeTick(Read(bytes), header).has_value();
  };
  EXPECT_TRUE(decode({{4, Status::kIdle, Status::kRunning}}, {{4, "fine"}}));
  EXPECT_FALSE(decode({{5, Status::kIdle, Status::kRunning}}, {}));
  EXPECT_FALSE(decode({{0, Status::kIdle, static_cast<Status>(5)}}, {}));
  EXPECT_FALSE(decode({}, {{5, "nobody"}}));
  EXPECT_FALSE(DecodeNote(Read({0, 0, 0, 0})));  // one byte too many
  EXPECT_FALSE(DecodeEnd(Read({0})));
  EXPECT_FALSE(DecodeHeader(Read({})));
  EXPECT_FALSE(DecodeGap(Read({0, 0, 0, 0, 0}), header));
}

}  // namespace
}  // namespace coppice
