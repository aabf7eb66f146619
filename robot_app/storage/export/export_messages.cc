#include "robot_app/storage/export/export_messages.h"

#include <fcntl.h>
#include <rosbag/bag.h>
#include <topic_tools/shape_shifter.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <utility>

#include "bt_core/model/write_file.h"
#include "robot_app/storage/export/csv_table.h"
#include "robot_app/storage/messages/json_to_message.h"
#include "robot_app/storage/topics/file_store.h"

namespace coppice::robot::storage {
namespace {

namespace fs = std::filesystem;

// A file that takes its name when it is whole; else it goes. Until then it has a name that nobody
// had: what somebody else has laid there is neither overwritten nor written through.
class Draft {
 public:
  explicit Draft(std::string path) : path_(std::move(path)) {}
  ~Draft() {
    if (is_there_) std::remove(draft_.c_str());
  }
  Draft(const Draft&) = delete;
  Draft& operator=(const Draft&) = delete;

  /// Before anything else: an empty file under the name draft().
  Outcome Begin() {
    std::error_code error;
    if (fs::exists(path_, error) && !fs::is_regular_file(path_, error)) {
      return Problem{path_ + ": is a folder, a device or a pipe, and no file"};
    }
    const int file = open(draft_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (file < 0) return Problem{path_ + ": " + std::strerror(errno)};
    is_there_ = true;
    close(file);
    return {};
  }
  const std::string& draft() const { return draft_; }
  Outcome Finish() {
    const int file = open(draft_.c_str(), O_RDONLY | O_CLOEXEC);
    const bool is_on_disk = file >= 0 && fsync(file) == 0;
    if (file >= 0) close(file);
    if (!is_on_disk || std::rename(draft_.c_str(), path_.c_str()) != 0) {
      return Problem{path_ + ": cannot be written"};
    }
    is_there_ = false;
    return {};
  }

 private:
  const std::string path_;
  const std::string draft_ = DraftName(path_);
  bool is_there_ = false;
};

// The layouts of types, each worked out once.
class Layouts {
 public:
  Expected<const MessageLayout*> Of(const MessageType& type) {
    const auto found = layouts_.find(&type);
    if (found != layouts_.end()) return &found->second;
    Expected<MessageLayout> layout = ParseDefinition(type.name, type.definition);
    if (!layout) return Problem{layout.problem()};
    return &layouts_.emplace(&type, *std::move(layout)).first->second;
  }

 private:
  std::map<const MessageType*, MessageLayout> layouts_;
};

void WriteTo(rosbag::Bag& bag, const StoredMessage& message, std::string& bytes) {
  topic_tools::ShapeShifter shape;
  shape.morph(message.type->md5, message.type->name, message.type->definition, "0");
  ros::serialization::IStream stream(reinterpret_cast<std::uint8_t*>(bytes.data()),
                                     static_cast<std::uint32_t>(bytes.size()));
  shape.read(stream);
  ros::Time stamp;
  stamp.fromNSec(static_cast<std::uint64_t>(std::max<std::int64_t>(message.stamp, 1)));
  bag.write(message.topic, std::max(stamp, ros::TIME_MIN), shape);
}

Outcome WriteTo(rosbag::Bag& bag, const StoredMessage& message, const std::string& files,
                Layouts& layouts, Exported& exported) {
  const auto layout = layouts.Of(*message.type);
  if (!layout) return Problem{layout.problem()};
  Expected<MessageBytes> bytes = JsonToMessage(
      **layout, message.json, [&](const std::string& name) { return ReadKeptFile(files, name); });
  if (!bytes) return Problem{message.topic + " at " + message.time + ": " + bytes.problem()};
  WriteTo(bag, message, bytes->bytes);
  ++exported.messages;
  exported.not_whole += bytes->is_whole ? 0 : 1;
  return {};
}

// Reads all, until `use` has a problem.
Outcome UseAll(const ServerConfig& server, const StoredQuery& query,
               const std::function<Outcome(const StoredMessage& message)>& use) {
  Outcome used;
  const Outcome read = ReadStored(server, query, [&](const StoredMessage& message) {
    used = use(message);
    return used.ok();
  });
  return read ? used : read;
}

}  // namespace

Expected<Exported> ExportBag(const ServerConfig& server, const StoredQuery& query,
                             const std::string& files, const std::string& path) {
  try {
    Draft draft(path);
    if (Outcome begun = draft.Begin(); !begun) return Problem{begun.problem()};
    rosbag::Bag bag(draft.draft(), rosbag::bagmode::Write);
    bag.setCompression(rosbag::compression::LZ4);
    Layouts layouts;
    Exported exported;
    const Outcome written = UseAll(server, query, [&](const StoredMessage& message) {
      return WriteTo(bag, message, files, layouts, exported);
    });
    if (!written) return Problem{written.problem()};
    bag.close();
    const Outcome finished = draft.Finish();
    if (!finished) return Problem{finished.problem()};
    return exported;
  } catch (const rosbag::BagException& error) {
    return Problem{path + ": " + error.what()};
  }
}

Expected<Exported> ExportCsv(const ServerConfig& server, const StoredQuery& query,
                             const std::string& path) {
  Draft draft(path);
  if (Outcome begun = draft.Begin(); !begun) return Problem{begun.problem()};
  std::ofstream file(draft.draft(), std::ios::binary);
  std::shared_ptr<const MessageType> type;
  Layouts layouts;
  Exported exported;
  const auto write = [&](const StoredMessage& message) -> Outcome {
    const auto layout = layouts.Of(*message.type);
    if (!layout) return Problem{layout.problem()};
    if (type && type != message.type) {
      return Problem{"a table is of one type, but there are " + type->name + " and " +
                     message.type->name};
    }
    // First: that a document has all these fields limits how many there are.
    const Expected<std::string> line = CsvLine(**layout, message);
    if (!line) return Problem{line.problem()};
    if (!type) {
      const Expected<std::string> header = CsvHeader(**layout);
      if (!header) return Problem{header.problem()};
      file << *header;
    }
    type = message.type;
    file << *line;
    ++exported.messages;
    return file ? Outcome() : Problem{path + ": cannot be written"};
  };
  const Outcome written = UseAll(server, query, write);
  if (!written) return Problem{written.problem()};
  file.close();
  if (!file) return Problem{path + ": cannot be written"};
  const Outcome finished = draft.Finish();
  if (!finished) return Problem{finished.problem()};
  return exported;
}

}  // namespace coppice::robot::storage
