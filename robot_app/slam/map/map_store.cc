#include "robot_app/slam/map/map_store.h"

#include <SQLiteCpp/SQLiteCpp.h>

#include <algorithm>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <system_error>
#include <utility>

#include "robot_app/common/databases/open_database.h"
#include "robot_app/slam/map/map_bytes.h"

namespace coppice::robot::slam {
namespace {

constexpr int kApplicationId = 0x436f536c;  // "CoSl"
constexpr int kSchemaVersion = 3;
constexpr int kPatience = 1000;                 // ms, with another program
constexpr int kLongestPart = 16 << 20;          // bytes, packed
constexpr int kDamaged = 11, kNoDatabase = 26;  // SQLITE_CORRUPT, SQLITE_NOTADB
constexpr char kSchema[] =
    "CREATE TABLE parts (kind INTEGER, number INTEGER, bytes BLOB NOT NULL, "
    "PRIMARY KEY (kind, number))";
constexpr std::size_t kPosesOfPart = 128;
constexpr std::size_t kLinksOfPart = 64;

// The parts: of each kind, numbered from 0 on.
enum Kind : int { kNames, kPoses, kLinks, kKeyFrames, kVersion };

std::string PackedText(const Writer& writer) {
  const Bytes packed = Packed(writer.bytes());
  return {packed.data(), packed.size()};
}

// What its log holds is of the damaged file and goes with it.
bool PutAside(const std::string& file) {
  std::error_code error;
  for (const char* const part : {"-wal", "-shm", ""}) {
    std::filesystem::rename(file + part, file + ".damaged" + part, error);
  }
  return !error;
}

bool SamePose(const Pose3& a, const Pose3& b) { return a.matrix() == b.matrix(); }

}  // namespace

MapStore::MapStore(std::unique_ptr<SQLite::Database> database, std::string file)
    : database_(std::move(database)), file_(std::move(file)) {}
MapStore::~MapStore() = default;

Problem MapStore::ProblemOf(const std::exception& error) const {
  return Problem{(file_.empty() ? "long-term memory" : file_) + ": " + error.what()};
}

Expected<std::unique_ptr<MapStore>> MapStore::Open(const std::string& file) {
  try {
    auto store = OpenWhole(file);
    if (!store || (*store)->Load()) return store;
  } catch (const SQLite::Exception& error) {
    const int code = error.getErrorCode();
    if (code != kDamaged && code != kNoDatabase) return Problem{file + ": " + error.what()};
  }
  if (!PutAside(file)) return Problem{file + ": it is damaged and cannot be put aside"};
  try {
    return OpenWhole(file);
  } catch (const SQLite::Exception& error) {
    return Problem{file + ": " + error.what()};
  }
}

Expected<std::unique_ptr<MapStore>> MapStore::OpenWhole(const std::string& file) {
  auto database =
      OpenDatabase(file, SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE, kPatience, kLongestPart);
  database->exec("PRAGMA locking_mode = EXCLUSIVE");
  database->exec("PRAGMA journal_mode = WAL");
  database->exec("PRAGMA synchronous = NORMAL");
  if (database->execAndGet("SELECT count(*) FROM sqlite_master").getInt() == 0) {
    SQLite::Transaction transaction(*database, SQLite::TransactionBehavior::IMMEDIATE);
    database->exec(kSchema);
    database->exec("PRAGMA application_id = " + std::to_string(kApplicationId));
    database->exec("PRAGMA user_version = " + std::to_string(kSchemaVersion));
    transaction.commit();
  } else if (database->execAndGet("PRAGMA application_id").getInt() != kApplicationId) {
    return Problem{file + ": a database of another program"};
  } else if (database->execAndGet("PRAGMA user_version").getInt() != kSchemaVersion) {
    return Problem{file + ": a map of another version of Coppice"};
  }
  return std::unique_ptr<MapStore>(new MapStore(std::move(database), file));
}

void MapStore::Put(int kind, std::size_t number, const std::string& packed) {
  SQLite::Statement statement(*database_, "INSERT OR REPLACE INTO parts VALUES (?, ?, ?)");
  statement.bind(1, kind);
  statement.bind(2, static_cast<std::int64_t>(number));
  statement.bindNoCopy(3, packed.data(), static_cast<int>(packed.size()));
  statement.exec();
}

std::string MapStore::Get(int kind, std::size_t number) {
  SQLite::Statement statement(*database_, "SELECT bytes FROM parts WHERE kind = ? AND number = ?");
  statement.bind(1, kind);
  statement.bind(2, static_cast<std::int64_t>(number));
  if (!statement.executeStep()) return {};
  const SQLite::Column column = statement.getColumn(0);
  return {static_cast<const char*>(column.getBlob()), static_cast<std::size_t>(column.getBytes())};
}

Expected<std::string> MapStore::ReadPacked(std::uint32_t key_frame) {
  try {
    std::string packed = Get(kKeyFrames, key_frame);
    if (!packed.empty()) return packed;
    return Problem{file_ + ": key frame " + std::to_string(key_frame) + " is missing"};
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
}

Expected<std::shared_ptr<const KeyFrame>> MapStore::Read(std::uint32_t key_frame) {
  const auto packed = ReadPacked(key_frame);
  if (!packed) return Problem{packed.problem()};
  const auto bytes = Unpacked(*packed);
  if (bytes) {
    Reader reader(*bytes);
    auto read = std::make_shared<KeyFrame>(GetKeyFrame(reader));
    if (!reader.failed()) return std::shared_ptr<const KeyFrame>(std::move(read));
  }
  return Problem{file_ + ": key frame " + std::to_string(key_frame) + " is damaged"};
}

Outcome MapStore::Keep(const std::vector<SessionName>& names, const SessionGraph& graph,
                       const std::vector<std::shared_ptr<const KeyFrame>>& key_frames) {
  try {
    SQLite::Transaction transaction(*database_, SQLite::TransactionBehavior::IMMEDIATE);
    KeepAll(names, graph, key_frames);
    transaction.commit();
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
  is_version_kept_ = true;
  key_frames_ = key_frames.size();
  links_ = graph.graph().links.size();
  poses_ = graph.poses();
  return {};
}

void MapStore::KeepAll(const std::vector<SessionName>& names, const SessionGraph& graph,
                       const std::vector<std::shared_ptr<const KeyFrame>>& key_frames) {
  Writer of_names;
  of_names.PutSize(names.size());
  for (const SessionName& name : names) PutName(name, of_names);
  Put(kNames, 0, PackedText(of_names));
  if (!is_version_kept_) Put(kVersion, 0, std::to_string(version_));
  const std::vector<Pose3>& poses = graph.poses();
  for (std::size_t begin = 0; begin < poses.size(); begin += kPosesOfPart) {
    const std::size_t end = std::min(begin + kPosesOfPart, poses.size());
    const auto at = [](const auto& of, std::size_t i) {
      return of.begin() + static_cast<std::ptrdiff_t>(i);
    };
    if (end <= poses_.size() &&
        std::equal(at(poses, begin), at(poses, end), at(poses_, begin), SamePose)) {
      continue;
    }
    Writer writer;
    writer.PutSize(end - begin);
    for (std::size_t i = begin; i < end; ++i) {
      writer.Put(graph.sessions()[i]);
      PutPose(poses[i], writer);
    }
    Put(kPoses, begin / kPosesOfPart, PackedText(writer));
  }
  const std::vector<Link>& links = graph.graph().links;
  for (std::size_t begin = links_ - links_ % kLinksOfPart; begin < links.size();
       begin += kLinksOfPart) {
    const std::size_t end = std::min(begin + kLinksOfPart, links.size());
    Writer writer;
    writer.PutSize(end - begin);
    for (std::size_t i = begin; i < end; ++i) PutLink(links[i], writer);
    Put(kLinks, begin / kLinksOfPart, PackedText(writer));
  }
  for (std::size_t i = key_frames_; i < key_frames.size(); ++i) PutKeyFrameOf(i, *key_frames[i]);
}

void MapStore::PutKeyFrameOf(std::size_t number, const KeyFrame& key_frame) {
  Writer writer;
  PutKeyFrame(key_frame, writer);
  Put(kKeyFrames, number, PackedText(writer));
}

Outcome MapStore::Replace(std::uint32_t key_frame, const KeyFrame& with) {
  try {
    PutKeyFrameOf(key_frame, with);
    return {};
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
}

std::size_t MapStore::Count(int kind) {
  SQLite::Statement statement(*database_, "SELECT count(*) FROM parts WHERE kind = ?");
  statement.bind(1, kind);
  statement.executeStep();
  return static_cast<std::size_t>(statement.getColumn(0).getInt64());
}

// All parts of a kind; `take` reads each thing in them.
template <typename Take>
bool MapStore::ReadAll(int kind, std::size_t least_size, Take take) {
  const std::size_t parts = Count(kind);
  for (std::size_t part = 0; part < parts; ++part) {
    const std::string packed = Get(kind, part);
    const auto bytes = packed.empty() ? std::nullopt : Unpacked(packed);
    if (!bytes) return false;
    Reader reader(*bytes);
    for (std::size_t left = reader.GetSize(least_size); left > 0; --left) take(reader);
    if (reader.failed()) return false;
  }
  return true;
}

bool MapStore::ReadMap(SlamMap& map) {
  return ReadAll(kNames, 12, [&](Reader& reader) { map.names.push_back(GetName(reader)); }) &&
         ReadAll(kPoses, 100,
                 [&](Reader& reader) {
                   map.sessions.push_back(reader.Get<std::uint32_t>());
                   map.graph.poses.push_back(GetPose(reader));
                 }) &&
         ReadAll(kLinks, 100,
                 [&](Reader& reader) {
                   map.graph.links.push_back(GetLink(map.graph.poses.size(), reader));
                 }) &&
         Count(kKeyFrames) == map.graph.poses.size() &&
         FollowEachOther(map.sessions, map.names.size());
}

Expected<SlamMap> MapStore::Load() {
  SlamMap map;
  try {
    if (!ReadMap(map)) return Problem{file_ + ": the map is damaged"};
    version_ = std::atoi(Get(kVersion, 0).c_str());
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
  map.key_frames.resize(map.graph.poses.size());
  key_frames_ = map.key_frames.size();
  links_ = map.graph.links.size();
  poses_ = map.graph.poses;
  return map;
}

Outcome MapStore::Clear() {
  try {
    database_->exec("DELETE FROM parts");
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
  key_frames_ = links_ = 0;
  poses_.clear();
  version_ = 0;
  is_version_kept_ = true;
  return {};
}

Outcome MapStore::SetVersion(int version) {
  version_ = version;
  is_version_kept_ = false;
  try {
    Put(kVersion, 0, std::to_string(version));
  } catch (const SQLite::Exception& error) {
    return ProblemOf(error);
  }
  is_version_kept_ = true;
  return {};
}

}  // namespace coppice::robot::slam
