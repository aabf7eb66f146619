// What a map consists of, as bytes: what goes into files, on whatever the map is kept.
//
// Numbers are as the processor has them, points in whole centimetres. A packed part is compressed
// and checksummed (zstd); parts that follow each other unpack to what they hold one behind the
// other.
#ifndef COPPICE_ROBOT_APP_SLAM_MAP_MAP_BYTES_H_
#define COPPICE_ROBOT_APP_SLAM_MAP_MAP_BYTES_H_

#include <cmath>
#include <cstdint>
#include <cstring>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "robot_app/slam/map/slam_map.h"

namespace coppice::robot::slam {

/// A map of half a kilometre is larger than kLargestAllocation lets a vector be (for messages).
template <typename T>
struct AnySize {
  using value_type = T;
  T* allocate(std::size_t count) { return new T[count]; }
  void deallocate(T* memory, std::size_t) { delete[] memory; }
  bool operator==(const AnySize&) const { return true; }
  bool operator!=(const AnySize&) const { return false; }
};
using Bytes = std::basic_string<char, std::char_traits<char>, AnySize<char>>;

/// Of a coordinate; a far or unknown one is kNoCentimetres, and NaN again.
inline constexpr std::int16_t kNoCentimetres = std::numeric_limits<std::int16_t>::min();
std::int16_t ToCentimetres(float metres);
float ToMetres(std::int16_t centimetres);

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

/// What is read beyond the end is zero, and failed() says so.
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

void PutPose(const Pose3& pose, Writer& writer);
Pose3 GetPose(Reader& reader);
void PutKeyFrame(const KeyFrame& key_frame, Writer& writer);
KeyFrame GetKeyFrame(Reader& reader);
void PutLink(const Link& link, Writer& writer);
/// Between `poses` poses.
Link GetLink(std::size_t poses, Reader& reader);
void PutName(const SessionName& session, Writer& writer);
SessionName GetName(Reader& reader);

/// Whether the sessions of the poses begin with 0, each follows the one before, and none is beyond
/// `names`.
bool FollowEachOther(const std::vector<std::uint32_t>& sessions, std::size_t names);

Bytes Packed(std::string_view bytes);
/// Nothing: the parts are damaged, or unpack to far more than any map does.
std::optional<Bytes> Unpacked(std::string_view packed);

}  // namespace coppice::robot::slam

#endif  // COPPICE_ROBOT_APP_SLAM_MAP_MAP_BYTES_H_
