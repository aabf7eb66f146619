#include "robot_app/slam/map/slam_map_file.h"

#include <zstd.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <type_traits>

#include "bt_core/model/write_file.h"

namespace coppice::robot::slam {
namespace {

namespace fs = std::filesystem;

constexpr char kHeader[] = "coppice slam map 1\n";
constexpr int kKept = 3;                                   // versions
constexpr int kLevel = 3;                                  // of compression
constexpr std::size_t kMostRatio = 20;                     // of compression: more is no map
constexpr std::size_t kSmall = std::size_t{1} << 20;       // bytes, of whatever ratio
constexpr std::size_t kLongestMap = std::size_t{2} << 30;  // bytes of a file
constexpr double kFarthest = 1000;                         // range of a key frame [m]
constexpr std::int16_t kNone = std::numeric_limits<std::int16_t>::min();

// A map of half a kilometre is larger than kLargestAllocation lets a vector be (it is for
// messages).
template <typename T>
struct AnySize {
  using value_type = T;
  T* allocate(std::size_t count) { return new T[count]; }
  void deallocate(T* memory, std::size_t) { delete[] memory; }
  bool operator==(const AnySize&) const { return true; }
  bool operator!=(const AnySize&) const { return false; }
};
using Bytes = std::basic_string<char, std::char_traits<char>, AnySize<char>>;

std::int16_t ToCentimetres(float metres) {
  if (!std::isfinite(metres) || std::abs(metres) > 300) return kNone;
  return static_cast<std::int16_t>(std::lround(metres * 100));
}
float ToMetres(std::int16_t centimetres) {
  return centimetres == kNone ? std::numeric_limits<float>::quiet_NaN()
                              : static_cast<float>(centimetres) / 100;
}

class Writer {
 public:
  template <typename T>
  void Put(const T& value) {
    static_assert(std::is_trivially_copyable_v<T>);
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof(T));
  }
  void PutSize(std::size_t size) { Put(static_cast<std::uint32_t>(size)); }
  void PutText(const std::string& text) {
    PutSize(text.size());
    bytes_ += text;
  }
  template <typename Derived>
  void PutMatrix(const Eigen::MatrixBase<Derived>& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i)
      Put(matrix(i % matrix.rows(), i / matrix.rows()));
  }
  void PutPoints(const std::vector<Eigen::Vector3f>& points) {
    PutSize(points.size());
    for (const Eigen::Vector3f& point : points) {
      for (int i = 0; i < 3; ++i) Put(ToCentimetres(point(i)));
    }
  }
  const Bytes& bytes() const { return bytes_; }

 private:
  Bytes bytes_;
};

// What is read beyond the end is zero, and failed() says so.
class Reader {
 public:
  explicit Reader(std::string_view bytes) : bytes_(bytes) {}

  template <typename T>
  T Get() {
    T value{};
    if (bytes_.size() - at_ < sizeof(T)) {
      failed_ = true;
      return value;
    }
    std::memcpy(&value, bytes_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  // Of things of at least `least` bytes each.
  std::size_t GetSize(std::size_t least) {
    const std::size_t size = Get<std::uint32_t>();
    if (size * least <= bytes_.size() - at_) return size;
    failed_ = true;
    return 0;
  }
  std::string GetText() {
    const std::size_t size = GetSize(1);
    at_ += size;
    return std::string(bytes_.substr(at_ - size, size));
  }
  template <typename Matrix>
  void GetMatrix(Matrix& matrix) {
    for (Eigen::Index i = 0; i < matrix.size(); ++i) {
      matrix(i % matrix.rows(), i / matrix.rows()) = Get<typename Matrix::Scalar>();
    }
    if (!matrix.allFinite()) failed_ = true;
  }
  std::vector<Eigen::Vector3f> GetPoints() {
    std::vector<Eigen::Vector3f> points(GetSize(6));
    for (Eigen::Vector3f& point : points) {
      for (int i = 0; i < 3; ++i) point(i) = ToMetres(Get<std::int16_t>());
    }
    return points;
  }
  bool failed() const { return failed_; }
  void Fail() { failed_ = true; }

 private:
  const std::string_view bytes_;
  std::size_t at_ = 0;
  bool failed_ = false;
};

void PutPose(const Pose3& pose, Writer& writer) { writer.PutMatrix(pose.matrix().topRows<3>()); }

Pose3 GetPose(Reader& reader) {
  Eigen::Matrix<double, 3, 4> rows;
  reader.GetMatrix(rows);
  Pose3 pose = Pose3::Identity();
  pose.matrix().topRows<3>() = rows;
  return pose;
}

void PutPicture(const PictureFeatures& picture, Writer& writer) {
  writer.PutSize(picture.size());
  for (std::size_t i = 0; i < picture.size(); ++i) {
    writer.PutMatrix(picture.pixels[i]);
    writer.Put(picture.descriptors[i]);
  }
  writer.PutPoints(picture.points);
}

PictureFeatures GetPicture(Reader& reader) {
  PictureFeatures picture;
  const std::size_t size = reader.GetSize(sizeof(Descriptor));
  for (std::size_t i = 0; i < size; ++i) {
    reader.GetMatrix(picture.pixels.emplace_back());
    picture.descriptors.push_back(reader.Get<Descriptor>());
  }
  picture.points = reader.GetPoints();
  if (picture.points.size() != size) reader.Fail();
  return picture;
}

void PutKeyFrame(const KeyFrame& key_frame, Writer& writer) {
  writer.Put(key_frame.stamp);
  writer.Put(key_frame.range);
  writer.Put(key_frame.descriptor);
  writer.PutPoints(key_frame.points);
  writer.PutSize(key_frame.pictures.size());
  for (const auto& picture : key_frame.pictures) PutPicture(*picture, writer);
}

KeyFrame GetKeyFrame(Reader& reader) {
  KeyFrame key_frame;
  key_frame.stamp = reader.Get<double>();
  key_frame.range = reader.Get<double>();
  if (!(key_frame.range >= 0 && key_frame.range <= kFarthest)) reader.Fail();
  key_frame.descriptor = reader.Get<CloudDescriptor>();
  key_frame.points = reader.GetPoints();
  const std::size_t pictures = reader.GetSize(4);
  for (std::size_t i = 0; i < pictures; ++i) {
    key_frame.pictures.push_back(std::make_shared<PictureFeatures>(GetPicture(reader)));
  }
  return key_frame;
}

void PutLink(const Link& link, Writer& writer) {
  writer.Put(link.from);
  writer.Put(link.to);
  writer.Put(link.kind);
  PutPose(link.relative, writer);
  writer.PutMatrix(link.information);
}

Link GetLink(std::size_t poses, Reader& reader) {
  Link link;
  link.from = reader.Get<std::uint32_t>();
  link.to = reader.Get<std::uint32_t>();
  link.kind = reader.Get<LinkKind>();
  link.relative = GetPose(reader);
  reader.GetMatrix(link.information);
  if (link.from >= poses || link.to >= poses || link.kind > LinkKind::kCloud) reader.Fail();
  return link;
}

void Write(const SlamMap& map, Writer& writer) {
  writer.PutSize(map.names.size());
  for (const SessionName& session : map.names) {
    writer.PutText(session.name);
    writer.Put(session.begin);
  }
  writer.PutSize(map.key_frames.size());
  for (std::size_t i = 0; i < map.key_frames.size(); ++i) {
    writer.Put(map.sessions[i]);
    PutPose(map.graph.poses[i], writer);
    PutKeyFrame(*map.key_frames[i], writer);
  }
  writer.PutSize(map.graph.links.size());
  for (const Link& link : map.graph.links) PutLink(link, writer);
}

// What goes into a file.
Bytes Packed(const Bytes& bytes) {
  const std::size_t header = std::strlen(kHeader);
  Bytes packed(header + ZSTD_compressBound(bytes.size()), '\0');
  std::memcpy(packed.data(), kHeader, header);
  ZSTD_CCtx* const context = ZSTD_createCCtx();
  ZSTD_CCtx_setParameter(context, ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context, ZSTD_c_checksumFlag, 1);
  packed.resize(header + ZSTD_compress2(context, packed.data() + header, packed.size() - header,
                                        bytes.data(), bytes.size()));
  ZSTD_freeCCtx(context);
  return packed;
}

std::optional<Bytes> Unpacked(std::string_view packed) {
  const unsigned long long whole = ZSTD_getFrameContentSize(packed.data(), packed.size());
  if (whole == ZSTD_CONTENTSIZE_ERROR || whole == ZSTD_CONTENTSIZE_UNKNOWN ||
      whole > kMostRatio * packed.size() + kSmall) {
    return std::nullopt;
  }
  Bytes bytes(whole, '\0');
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) || got != whole) return std::nullopt;
  return bytes;
}

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
    if (std::sscanf(name.c_str(), "map-%d.slam", &version) == 1 && name == NameOf(version)) {
      versions.push_back(version);
    }
  }
  std::sort(versions.begin(), versions.end());
  return versions;
}

std::string PathOf(const std::string& folder, int version) {
  return (fs::path(folder) / NameOf(version)).string();
}

}  // namespace

std::string BytesOf(const SlamMap& map) {
  Writer writer;
  Write(map, writer);
  return std::string(writer.bytes());
}

std::optional<SlamMap> ParseSlamMap(std::string_view bytes) {
  Reader reader(bytes);
  SlamMap map;
  map.names.resize(reader.GetSize(12));
  for (SessionName& session : map.names) {
    session.name = reader.GetText();
    session.begin = reader.Get<double>();
  }
  const std::size_t frames = reader.GetSize(100);
  for (std::size_t i = 0; i < frames && !reader.failed(); ++i) {
    map.sessions.push_back(reader.Get<std::uint32_t>());
    map.graph.poses.push_back(GetPose(reader));
    map.key_frames.push_back(std::make_shared<KeyFrame>(GetKeyFrame(reader)));
    const std::uint32_t session = map.sessions[i], last = i == 0 ? 0 : map.sessions[i - 1];
    const bool begins = session == last + 1 && i > 0;
    if ((session != last && !begins) || session >= map.names.size()) reader.Fail();
  }
  const std::size_t links = reader.GetSize(100);
  for (std::size_t i = 0; i < links && !reader.failed(); ++i) {
    map.graph.links.push_back(GetLink(frames, reader));
  }
  if (reader.failed()) return std::nullopt;
  // A session that had seen nothing when the map was saved never was.
  map.names.resize(frames == 0 ? 0 : map.sessions.back() + 1);
  return map;
}

Expected<int> SaveSlamMap(const std::string& folder, const SlamMap& map) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) return Problem{folder + ": " + error.message()};
  std::vector<int> versions = VersionsIn(folder);
  const int version = versions.empty() ? 1 : versions.back() + 1;
  Diagnostics diagnostics;
  Writer writer;
  Write(map, writer);
  if (!WriteFile(PathOf(folder, version), Packed(writer.bytes()), diagnostics)) {
    return Problem{diagnostics.ToString()};
  }
  versions.push_back(version);
  for (std::size_t i = 0; i + kKept < versions.size(); ++i) {
    fs::remove(PathOf(folder, versions[i]), error);
  }
  return version;
}

bool HasSlamMap(const std::string& folder) { return !VersionsIn(folder).empty(); }

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
