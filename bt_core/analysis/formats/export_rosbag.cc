// http://wiki.ros.org/Bags/Format/2.0: "#ROSBAG V2.0\n", then records of a header (fields
// "name=value", each with its length) and data, each with its length. One chunk, uncompressed, with
// its connections and messages; behind it an index per connection, the connections again and the
// chunk info.
#include <algorithm>
#include <vector>

#include "bt_core/analysis/formats/export.h"
#include "bt_core/analysis/formats/full_xml.h"
#include "bt_core/analysis/why/run_walk.h"
#include "bt_core/base/json.h"
#include "bt_core/data/value_bytes.h"

namespace coppice {
namespace {

enum class Op : char {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7
};

constexpr std::string_view kMagic = "#ROSBAG V2.0\n";
constexpr std::size_t kBagHeaderSize = 4096;  // padded, so that it can be rewritten
constexpr const char* kTopics[] = {"/coppice/tree", "/coppice/ticks", "/coppice/changes"};
constexpr std::size_t kTopicCount = 3;

std::string Number(std::uint64_t number, int bytes) {
  std::string out;
  for (int i = 0; i < bytes; ++i) out += static_cast<char>(number >> (8 * i) & 0xff);
  return out;
}

// Seconds and nanoseconds, four bytes each.
std::string BagTime(WallTime time) {
  const auto nanoseconds =
      static_cast<std::uint64_t>(std::max<std::int64_t>(time.time_since_epoch().count(), 0));
  return Number(nanoseconds / 1000000000, 4) + Number(nanoseconds % 1000000000, 4);
}

std::string Sized(const std::string& bytes) { return Number(bytes.size(), 4) + bytes; }
std::string Field(const std::string& name, const std::string& value) {
  return Sized(name + "=" + value);
}
std::string RecordHeader(Op op, const std::string& fields) {
  return Sized(Field("op", std::string(1, static_cast<char>(op))) + fields);
}

std::string Connection(std::size_t topic) {
  const std::string data = Field("topic", kTopics[topic]) + Field("type", "std_msgs/String") +
                           Field("md5sum", "992ce8a1687cec8c8bd883ec73ca41d1") +
                           Field("message_definition", "string data\n") +
                           Field("callerid", "/coppice") + Field("latching", "1");
  return RecordHeader(Op::kConnection,
                      Field("conn", Number(topic, 4)) + Field("topic", kTopics[topic])) +
         Sized(data);
}

class BagWriter final : public RunVisitor {
 public:
  explicit BagWriter(WallTime start) : begin_(start), end_(start) {
    for (std::size_t i = 0; i < kTopicCount; ++i) chunk_ += Connection(i);
  }

  void OnSection(const TreeDescription& tree, const Recording::Section& section) override {
    tree_ = &tree;
    Add(0, section.state.time, FullXml(tree));
  }
  void OnTickBegin(const TickEvents&) override { changes_.clear(); }
  void OnChange(const StatusChange& change, const TickEvents&) override {
    changes_.push_back(JsonObject()
                           .AddText("node", tree_->nodes[change.node].path)
                           .AddText("from", ToString(change.from))
                           .AddText("to", ToString(change.to))
                           .Finish());
  }
  void OnEvent(const Event& event, const TickEvents&) override {
    if (event.code != EventCode::kWrite && event.code != EventCode::kDelivery) return;
    const DescribedSlot& slot = tree_->slots[event.index];
    changes_.push_back(JsonObject()
                           .AddText("scope", slot.scope)
                           .AddText("key", slot.name)
                           .Add("value", ValueBytesToJson(event.bytes))
                           .Finish());
  }
  void OnTickEnd(const TickEvents& events) override {
    if (events.result != Status::kIdle) {
      Add(1, events.start,
          JsonObject()
              .Add("tick", events.tick)
              .AddText("result", ToString(events.result))
              .Add("duration", JsonSeconds(events.duration))
              .Finish());
    }
    if (changes_.empty()) return;
    const auto itself = [](const std::string& json) { return json; };
    Add(2, events.start,
        JsonObject().Add("tick", events.tick).Add("changes", JsonArray(changes_, itself)).Finish());
  }

  std::size_t chunk_size() const { return chunk_.size(); }

  std::string Finish() const {
    std::string bag(kMagic);
    const std::string chunk =
        RecordHeader(Op::kChunk,
                     Field("compression", "none") + Field("size", Number(chunk_.size(), 4))) +
        Sized(chunk_);
    std::string indices;
    std::string counts;
    std::string connections;
    for (std::size_t i = 0; i < kTopicCount; ++i) {
      connections += Connection(i);
      if (index_[i].empty()) continue;
      const std::uint64_t count = index_[i].size() / 12;
      indices += RecordHeader(Op::kIndex, Field("ver", Number(1, 4)) + Field("conn", Number(i, 4)) +
                                              Field("count", Number(count, 4))) +
                 Sized(index_[i]);
      counts += Number(i, 4) + Number(count, 4);
    }
    const std::size_t chunk_at = kMagic.size() + kBagHeaderSize;
    const std::string info =
        RecordHeader(Op::kChunkInfo,
                     Field("ver", Number(1, 4)) + Field("chunk_pos", Number(chunk_at, 8)) +
                         Field("start_time", BagTime(begin_)) + Field("end_time", BagTime(end_)) +
                         Field("count", Number(counts.size() / 8, 4))) +
        Sized(counts);
    bag += BagHeader(chunk_at + chunk.size() + indices.size());
    return bag + chunk + indices + connections + info;
  }

 private:
  static std::string BagHeader(std::uint64_t index_at) {
    std::string header =
        RecordHeader(Op::kBagHeader, Field("index_pos", Number(index_at, 8)) +
                                         Field("conn_count", Number(kTopicCount, 4)) +
                                         Field("chunk_count", Number(1, 4)));
    return header + Sized(std::string(kBagHeaderSize - header.size() - 4, ' '));
  }

  void Add(std::size_t topic, Time time, const std::string& text) {
    const WallTime stamp = tree_->info.WallAt(time);
    if (is_empty_) begin_ = stamp;
    is_empty_ = false;
    end_ = stamp;
    index_[topic] += BagTime(stamp) + Number(chunk_.size(), 4);
    chunk_ += RecordHeader(Op::kMessage,
                           Field("conn", Number(topic, 4)) + Field("time", BagTime(stamp))) +
              Sized(Sized(text));
  }

  const TreeDescription* tree_ = nullptr;
  WallTime begin_;
  WallTime end_;
  bool is_empty_ = true;
  std::string chunk_;
  std::string index_[kTopicCount];
  std::vector<std::string> changes_;  // of the present tick
};

}  // namespace

std::optional<std::string> ToRosbag(const Recording& run, Diagnostics& diagnostics) {
  BagWriter writer(run.trees().front().info.wall_start);
  WalkRun(run, writer);
  if (writer.chunk_size() <= INT32_MAX) return writer.Finish();
  diagnostics.Error({}, "the run is too long for a bag of one chunk, which has at most 2 GiB");
  return std::nullopt;
}

}  // namespace coppice
