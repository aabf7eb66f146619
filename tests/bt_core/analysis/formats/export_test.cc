#include "bt_core/analysis/formats/export.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>

#include "bt_core/analysis/formats/btlog.h"
#include "bt_core/analysis/formats/import_btlog.h"
#include "bt_core/analysis/formats/write_record.h"
#include "bt_core/analysis/load_recording.h"
#include "bt_core/analysis/play/verify.h"
#include "tests/bt_core/analysis/recorded_run.h"
#include "tests/support/temporary_folder.h"

namespace coppice {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;

constexpr char kTree[] =
    "<BehaviorTree ID='Main'><Sequence name='s'><Script code='n := 1.5'/>"
    "<SubTree ID='Sub' name='sub'/></Sequence></BehaviorTree>"
    "<BehaviorTree ID='Sub'><Sleep name='sleep' msec='250'/></BehaviorTree>";

struct Sleeper : RecordedRun {
  Sleeper() : RecordedRun(kTree) {
    for (int i = 0; i < 8; ++i) Tick();
  }
  const Recording& recording() const { return keeper.run; }
};

TEST(ChromeTrace, HasSlicesForTicksAndActivationsAndCountersForNumbers) {
  const json trace = json::parse(ToChromeTrace(Sleeper().recording()));
  std::map<std::string, int> phases;
  bool has_sleep = false;
  for (const json& event : trace["traceEvents"]) {
    ++phases[event["ph"]];
    has_sleep |= event["name"] == "sleep" && event["ph"] == "X" && event["dur"] == 300000.0 &&
                 event["args"]["ends"] == "SUCCESS";
  }
  EXPECT_TRUE(has_sleep);
  EXPECT_GE(phases["X"], 8) << "one per tick and more";
  EXPECT_EQ(phases["C"], 2) << "one per write";
}

TEST(Csv, HasALineForEveryChangeAndWrite) {
  const std::string csv = ToCsv(Sleeper().recording());
  EXPECT_EQ(csv.rfind("time,tick,kind,subject,from,to,by\r\n", 0), 0u);
  EXPECT_THAT(csv, HasSubstr("0.000000000,1,write,Main{n},,1.5,Script::2\r\n"));
  EXPECT_THAT(csv, HasSubstr("0.000000000,1,change,sub/sleep,IDLE,RUNNING,\r\n"));
  EXPECT_THAT(csv, HasSubstr("0.300000000,4,change,sub/sleep,RUNNING,SUCCESS,\r\n"));
}

TEST(Btlog, GoesThereAndBack) {
  const Sleeper run;
  Diagnostics diagnostics;
  const std::optional<std::string> bytes = ToBtlog(run.recording(), diagnostics);
  ASSERT_TRUE(bytes) << diagnostics.ToString();
  EXPECT_EQ(bytes->substr(0, 18), "BTCPP4-FileLogger2");
  const std::optional<Btlog> log = ReadBtlog(*bytes, "x.btlog", diagnostics);
  ASSERT_TRUE(log) << diagnostics.ToString();
  EXPECT_THAT(log->xml, HasSubstr(R"(_uid="4")"));
  ASSERT_FALSE(log->transitions.empty());

  const std::optional<Recording> back = FromBtlog(*bytes, "x.btlog", diagnostics);
  ASSERT_TRUE(back) << diagnostics.ToString();
  EXPECT_TRUE(TellsChangesOnly(back->trees()[0].info));
  ASSERT_EQ(back->trees()[0].nodes.size(), 4u);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(back->trees()[0].nodes[i].path, run.recording().trees()[0].nodes[i].path);
    EXPECT_EQ(back->trees()[0].nodes[i].parent, run.recording().trees()[0].nodes[i].parent);
  }
  EXPECT_EQ(back->Before(back->ticks().size()).statuses, run.executor.statuses());
  EXPECT_EQ(WriteBtlog(*log), *bytes);
}

TEST(Btlog, IsRefusedIfItIsNone) {
  Diagnostics diagnostics;
  EXPECT_FALSE(FromBtlog("", "a.btlog", diagnostics));
  EXPECT_FALSE(FromBtlog("BTCPP4-FileLogger2\x02        ", "a.btlog", diagnostics));
  EXPECT_FALSE(
      FromBtlog(std::string("BTCPP4-FileLogger2\x01\xff\xff\x00\x00", 23), "a.btlog", diagnostics));
  const std::string xml = WriteBtlog({"<root><BehaviorTree ID='M'><A/></BehaviorTree></root>", {}});
  EXPECT_FALSE(FromBtlog(xml, "a.btlog", diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("node without _uid"));
  const std::string bytes = *ToBtlog(Sleeper().recording(), diagnostics);
  for (std::size_t size = 0; size < bytes.size(); size += 7) {
    FromBtlog(bytes.substr(0, size), "a.btlog", diagnostics);  // never crashes
  }
}

Btlog LogOf(std::vector<BtlogTransition> transitions) {
  return {R"(<root><BehaviorTree ID="M"><A _uid="1"/></BehaviorTree></root>)",
          std::move(transitions)};
}

TEST(Btlog, AClockThatWasSetBackMakesNoTickOfLessThanNoTime) {
  Diagnostics diagnostics;
  const std::string bytes =
      WriteBtlog(LogOf({{5000, 1, Status::kRunning}, {9000, 1, Status::kSuccess}}));
  std::string set_back = bytes;
  set_back[bytes.size() - 9] = 0;  // the second one at 5000 us too
  set_back[bytes.size() - 8] = 0;
  set_back[bytes.size() - 18] = 100;  // the first one 100 us later
  const auto run = FromBtlog(set_back, "a.btlog", diagnostics);
  ASSERT_TRUE(run) << diagnostics.ToString();
  ASSERT_EQ(run->ticks().size(), 1u);
  EXPECT_EQ(run->ticks()[0].duration, Duration(0));
}

TEST(Btlog, IsRefusedIfItStartsAtATimeThatMakesNoSense) {
  for (const std::int64_t time : {std::int64_t{-1}, INT64_MAX / 1000, INT64_MAX}) {
    Diagnostics diagnostics;
    EXPECT_FALSE(
        FromBtlog(WriteBtlog(LogOf({{time, 1, Status::kRunning}})), "a.btlog", diagnostics));
    EXPECT_THAT(diagnostics.ToString(), HasSubstr("makes no sense: " + std::to_string(time)));
  }
}

TEST(Btlog, HasNoMoreThan65535Nodes) {
  Recording run;
  TreeDescription tree;
  tree.nodes.resize(65536);
  run.OnTree(tree);
  HistoryState state;
  state.statuses.resize(65536);
  run.OnState(state);
  Diagnostics diagnostics;
  EXPECT_FALSE(ToBtlog(run, diagnostics));
  EXPECT_THAT(diagnostics.ToString(), HasSubstr("at most 65535"));
}

TEST(Record, IsWrittenSoThatItReadsBackTheSame) {
  const Sleeper run;
  const TemporaryFolder folder;
  const std::string path = folder.Path("copy.coppice");
  std::ofstream(path, std::ios::binary) << ToRecord(run.recording());
  Diagnostics diagnostics;
  const std::optional<Recording> copy = LoadRecording(path, diagnostics);
  ASSERT_TRUE(copy) << diagnostics.ToString();
  ASSERT_EQ(copy->ticks().size(), run.recording().ticks().size());
  EXPECT_EQ(ToCsv(*copy), ToCsv(run.recording()));
  EXPECT_TRUE(Verify(*copy, {}, diagnostics).is_the_same());
}

// Reads a bag as the format says, record by record.
class BagReader {
 public:
  explicit BagReader(std::string bytes) : bytes_(std::move(bytes)), at_(13) {}

  using Fields = std::map<std::string, std::string>;
  bool Next(Fields& fields, std::string& data) {
    if (at_ >= bytes_.size()) return false;
    fields = FieldsOf(Sized());
    data = Sized();
    return true;
  }
  static std::uint64_t Number(const std::string& bytes) {
    std::uint64_t number = 0;
    for (std::size_t i = bytes.size(); i-- > 0;) {
      number = number << 8 | static_cast<unsigned char>(bytes[i]);
    }
    return number;
  }
  static Fields FieldsOf(const std::string& header) {
    Fields fields;
    for (std::size_t at = 0; at < header.size();) {
      const std::uint64_t size = Number(header.substr(at, 4));
      const std::string field = header.substr(at + 4, size);
      fields[field.substr(0, field.find('='))] = field.substr(field.find('=') + 1);
      at += 4 + size;
    }
    return fields;
  }
  std::size_t at() const { return at_; }

 private:
  std::string Sized() {
    const std::uint64_t size = Number(bytes_.substr(at_, 4));
    const std::string content = bytes_.substr(at_ + 4, size);
    at_ += 4 + size;
    return content;
  }

  std::string bytes_;
  std::size_t at_;
};

TEST(Rosbag, IsReadAsTheFormatSays) {
  Diagnostics diagnostics;
  const std::string bag = *ToRosbag(Sleeper().recording(), diagnostics);
  ASSERT_EQ(bag.substr(0, 13), "#ROSBAG V2.0\n");
  BagReader reader(bag);
  BagReader::Fields fields;
  std::string data;
  ASSERT_TRUE(reader.Next(fields, data));
  EXPECT_EQ(fields["op"], "\x03");
  EXPECT_EQ(reader.at(), 13u + 4096u);
  const std::uint64_t index_at = BagReader::Number(fields["index_pos"]);
  ASSERT_TRUE(reader.Next(fields, data));
  ASSERT_EQ(fields["op"], "\x05");
  ASSERT_EQ(fields["compression"], "none");
  EXPECT_EQ(BagReader::Number(fields["size"]), data.size());

  BagReader chunk(std::string(13, ' ') + data);
  std::map<std::string, int> ops;
  std::string message;
  int ticks = 0;
  while (chunk.Next(fields, message)) {
    ++ops[fields["op"]];
    if (fields["op"] != "\x02" || BagReader::Number(fields["conn"]) != 1) continue;
    EXPECT_EQ(BagReader::Number(message.substr(0, 4)), message.size() - 4);
    EXPECT_EQ(json::parse(message.substr(4))["tick"], ++ticks);
  }
  EXPECT_EQ(ticks, 8);
  EXPECT_EQ(ops["\x07"], 3);
  int indices = 0;
  while (reader.at() < index_at && reader.Next(fields, data)) indices += fields["op"] == "\x04";
  EXPECT_EQ(indices, 3);
  EXPECT_EQ(reader.at(), index_at);
}

}  // namespace
}  // namespace coppice
