#include "robot_app/slam/map/slam_map_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <optional>
#include <system_error>

#include "robot_app/slam/map/map_bytes.h"

namespace coppice::robot::slam {
namespace {

namespace fs = std::filesystem;

constexpr char kHeader[] = "coppice slam map 3\n";
constexpr int kKept = 3;                                   // versions
constexpr int kLastVersion = 999'999'999;                  // no map of ours has a higher number
constexpr std::size_t kLongestMap = std::size_t{2} << 30;  // bytes of a file

// As ReadFile, of any size.
std::optional<Bytes> ReadBytes(const std::string& path) {
  std::error_code error;
  const bool is_file = fs::is_regular_file(path, error);
  const std::uintmax_t size = is_file ? fs::file_size(path, error) : 0;
  if (!is_file || error || size > kLongestMap) return std::nullopt;
  Bytes bytes(size, '\0');
  std::ifstream stream(path, std::ios::binary);
  stream.read(bytes.data(), static_cast<std::streamsize>(size));
  if (!stream) return std::nullopt;
  return bytes;
}

std::string NameOf(int version) {
  char name[32];
  std::snprintf(name, sizeof(name), "map-%06d.slam", version);
  return name;
}

// Ascending.
std::vector<int> VersionsIn(const std::string& folder) {
  std::vector<int> versions;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(folder, error)) {
    int version = 0;
    const std::string name = entry.path().filename();
    if (std::sscanf(name.c_str(), "map-%d.slam", &version) == 1 && name == NameOf(version) &&
        version <= kLastVersion) {
      versions.push_back(version);
    }
  }
  std::sort(versions.begin(), versions.end());
  return versions;
}

std::string PathOf(const std::string& folder, int version) {
  return (fs::path(folder) / NameOf(version)).string();
}

void PutNames(const SlamMap& map, Writer& writer) {
  writer.PutSize(map.names.size());
  for (const SessionName& session : map.names) PutName(session, writer);
  writer.PutSize(map.key_frames.size());
}

// Of a key frame, which comes behind.
void PutPlace(const SlamMap& map, std::uint32_t key_frame, Writer& writer) {
  writer.Put(map.sessions[key_frame]);
  PutPose(map.graph.poses[key_frame], writer);
}

void PutLinks(const SlamMap& map, Writer& writer) {
  writer.PutSize(map.graph.links.size());
  for (const Link& link : map.graph.links) PutLink(link, writer);
}

// What lies there goes: nothing is written through a link, and no pipe is waited for.
std::FILE* Create(const std::string& path) {
  ::unlink(path.c_str());
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
  return file < 0 ? nullptr : ::fdopen(file, "wb");
}

// Written beside the one that it is to be, synced and renamed.
class NewFile {
 public:
  explicit NewFile(const std::string& path) : path_(path), file_(Create(beside_)) {}
  ~NewFile() {
    if (file_ != nullptr) std::fclose(file_);
    std::error_code error;
    fs::remove(beside_, error);
  }
  NewFile(const NewFile&) = delete;

  void Put(std::string_view bytes) {
    if (file_ == nullptr || std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size()) {
      failed_ = true;
    }
  }
  void Put(const Writer& writer) { Put(std::string_view(Packed(writer.bytes()))); }

  Outcome Finish() {
    if (file_ == nullptr || failed_ || std::fflush(file_) != 0 || ::fsync(::fileno(file_)) != 0 ||
        std::rename(beside_.c_str(), path_.c_str()) != 0) {
      return Problem{path_ + ": " + std::strerror(errno)};
    }
    const int folder = ::open(fs::path(path_).parent_path().c_str(), O_RDONLY | O_DIRECTORY);
    if (folder >= 0) {
      ::fsync(folder);
      ::close(folder);
    }
    return {};
  }

 private:
  const std::string path_;
  const std::string beside_ = path_ + ".new";
  std::FILE* file_;
  bool failed_ = false;
};

// Part by part, so that a map takes no more memory than a key frame.
Outcome WriteVersion(const std::string& path, const SlamMap& map, const PackedKeyFrames& others) {
  NewFile file(path);
  file.Put(kHeader);
  Writer names;
  PutNames(map, names);
  file.Put(names);
  for (std::uint32_t i = 0; i < map.key_frames.size(); ++i) {
    Writer place;
    PutPlace(map, i, place);
    if (map.key_frames[i] != nullptr) {
      PutKeyFrame(*map.key_frames[i], place);
      file.Put(place);
      continue;
    }
    file.Put(place);
    const Expected<std::string> packed = others(i);
    if (!packed) return Problem{packed.problem()};
    file.Put(std::string_view(*packed));
  }
  Writer links;
  PutLinks(map, links);
  file.Put(links);
  return file.Finish();
}

}  // namespace

std::string BytesOf(const SlamMap& map) {
  Writer writer;
  PutNames(map, writer);
  for (std::uint32_t i = 0; i < map.key_frames.size(); ++i) {
    PutPlace(map, i, writer);
    PutKeyFrame(*map.key_frames[i], writer);
  }
  PutLinks(map, writer);
  return std::string(writer.bytes());
}

std::optional<SlamMap> ParseSlamMap(std::string_view bytes) {
  Reader reader(bytes);
  SlamMap map;
  map.names.resize(reader.GetSize(12));
  for (SessionName& session : map.names) session = GetName(reader);
  const std::size_t frames = reader.GetSize(100);
  for (std::size_t i = 0; i < frames && !reader.failed(); ++i) {
    map.sessions.push_back(reader.Get<std::uint32_t>());
    map.graph.poses.push_back(GetPose(reader));
    map.key_frames.push_back(std::make_shared<KeyFrame>(GetKeyFrame(reader)));
  }
  const std::size_t links = reader.GetSize(100);
  for (std::size_t i = 0; i < links && !reader.failed(); ++i) {
    map.graph.links.push_back(GetLink(frames, reader));
  }
  if (reader.failed() || !FollowEachOther(map.sessions, map.names.size())) return std::nullopt;
  // A session that had seen nothing when the map was saved never was.
  map.names.resize(frames == 0 ? 0 : map.sessions.back() + 1);
  return map;
}

Expected<int> SaveSlamMap(const std::string& folder, const SlamMap& map,
                          const PackedKeyFrames& others) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Problem{folder + ": " + error.message()};
  std::vector<int> versions = VersionsIn(folder);
  const int version = versions.empty() ? 1 : versions.back() + 1;
  const Outcome written = WriteVersion(PathOf(folder, version), map, others);
  if (!written) return Problem{written.problem()};
  versions.push_back(version);
  for (std::size_t i = 0; i + kKept < versions.size(); ++i) {
    fs::remove(PathOf(folder, versions[i]), error);
  }
  return version;
}

int NewestVersion(const std::string& folder) {
  const std::vector<int> versions = VersionsIn(folder);
  return versions.empty() ? 0 : versions.back();
}

Expected<SlamMap> ReadSlamMap(const std::string& file) {
  const auto text = ReadBytes(file);
  if (!text) return Problem{file + ": cannot be read"};
  const std::string_view header = kHeader;
  if (text->compare(0, header.size(), header) != 0) {
    return Problem{file + ": expected a map that begins with \"" +
                   std::string(header.substr(0, header.size() - 1)) + "\""};
  }
  const auto bytes = Unpacked(std::string_view(*text).substr(header.size()));
  auto map = bytes ? ParseSlamMap(*bytes) : std::nullopt;
  if (!map) return Problem{file + ": the map is damaged"};
  return *std::move(map);
}

Expected<LoadedMap> LoadSlamMap(const std::string& folder) {
  const std::vector<int> versions = VersionsIn(folder);
  std::string remark;
  for (auto version = versions.rbegin(); version != versions.rend(); ++version) {
    auto map = ReadSlamMap(PathOf(folder, *version));
    if (map) return LoadedMap{*std::move(map), *version, remark};
    remark += (remark.empty() ? "" : "; ") + map.problem();
  }
  if (!remark.empty()) return Problem{remark};
  return Problem{folder + ": expected a folder with maps, " + NameOf(1) + " and so on"};
}

}  // namespace coppice::robot::slam
