#include "robot_app/slam/map/map_bytes.h"

#include <zstd.h>

#include <memory>

namespace coppice::robot::slam {
namespace {

constexpr int kLevel = 3;                             // of compression
constexpr std::size_t kMostRatio = 20;                // of compression: more is no map
constexpr std::size_t kSmall = std::size_t{1} << 20;  // bytes, of whatever ratio
constexpr double kFarthest = 1000;                    // range of a key frame [m]

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

}  // namespace

std::int16_t ToCentimetres(float metres) {
  if (!std::isfinite(metres) || std::abs(metres) > 300) return kNoCentimetres;
  return static_cast<std::int16_t>(std::lround(metres * 100));
}
float ToMetres(std::int16_t centimetres) {
  return centimetres == kNoCentimetres ? std::numeric_limits<float>::quiet_NaN()
                                       : static_cast<float>(centimetres) / 100;
}

void PutPose(const Pose3& pose, Writer& writer) { writer.PutMatrix(pose.matrix().topRows<3>()); }

Pose3 GetPose(Reader& reader) {
  Eigen::Matrix<double, 3, 4> rows;
  reader.GetMatrix(rows);
  Pose3 pose = Pose3::Identity();
  pose.matrix().topRows<3>() = rows;
  return pose;
}

void PutKeyFrame(const KeyFrame& key_frame, Writer& writer) {
  writer.Put(key_frame.stamp);
  writer.Put(key_frame.range);
  writer.Put(static_cast<std::uint8_t>(key_frame.place.has_value()));
  const Pose2D place = key_frame.place.value_or(Pose2D{});
  writer.PutMatrix(Eigen::Vector3d(place.x, place.y, place.yaw));
  writer.Put(key_frame.descriptor);
  writer.PutPoints(key_frame.points);
  writer.PutSize(key_frame.camera_clouds.size());
  for (const CameraCloud& cloud : key_frame.camera_clouds) {
    writer.PutPoints({cloud.camera});
    writer.PutPoints(cloud.points);
  }
  writer.PutSize(key_frame.pictures.size());
  for (const auto& picture : key_frame.pictures) PutPicture(*picture, writer);
}

KeyFrame GetKeyFrame(Reader& reader) {
  KeyFrame key_frame;
  key_frame.stamp = reader.Get<double>();
  key_frame.range = reader.Get<double>();
  if (!(key_frame.range >= 0 && key_frame.range <= kFarthest)) reader.Fail();
  const bool has_place = reader.Get<std::uint8_t>() != 0;
  Eigen::Vector3d place;
  reader.GetMatrix(place);
  if (has_place) key_frame.place = Pose2D{place.x(), place.y(), place.z()};
  key_frame.descriptor = reader.Get<CloudDescriptor>();
  key_frame.points = reader.GetPoints();
  const std::size_t clouds = reader.GetSize(8);
  for (std::size_t i = 0; i < clouds; ++i) {
    const std::vector<Eigen::Vector3f> camera = reader.GetPoints();
    if (camera.size() != 1 || !camera[0].allFinite()) return reader.Fail(), key_frame;
    key_frame.camera_clouds.push_back({camera[0], reader.GetPoints()});
  }
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

void PutName(const SessionName& session, Writer& writer) {
  writer.PutText(session.name);
  writer.Put(session.begin);
}

SessionName GetName(Reader& reader) {
  SessionName session;
  session.name = reader.GetText();
  session.begin = reader.Get<double>();
  return session;
}

bool FollowEachOther(const std::vector<std::uint32_t>& sessions, std::size_t names) {
  for (std::size_t i = 0; i < sessions.size(); ++i) {
    const std::uint32_t last = i == 0 ? 0 : sessions[i - 1];
    const bool begins = i > 0 && sessions[i] == last + 1;
    if ((sessions[i] != last && !begins) || sessions[i] >= names) return false;
  }
  return true;
}

Bytes Packed(std::string_view bytes) {
  Bytes packed(ZSTD_compressBound(bytes.size()), '\0');
  const std::unique_ptr<ZSTD_CCtx, std::size_t (*)(ZSTD_CCtx*)> context(ZSTD_createCCtx(),
                                                                        &ZSTD_freeCCtx);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_compressionLevel, kLevel);
  ZSTD_CCtx_setParameter(context.get(), ZSTD_c_checksumFlag, 1);
  packed.resize(
      ZSTD_compress2(context.get(), packed.data(), packed.size(), bytes.data(), bytes.size()));
  return packed;
}

std::optional<Bytes> Unpacked(std::string_view packed) {
  unsigned long long whole = 0;
  for (std::string_view left = packed; !left.empty();) {
    const unsigned long long part = ZSTD_getFrameContentSize(left.data(), left.size());
    const std::size_t size = ZSTD_findFrameCompressedSize(left.data(), left.size());
    if (part == ZSTD_CONTENTSIZE_ERROR || part == ZSTD_CONTENTSIZE_UNKNOWN || ZSTD_isError(size)) {
      return std::nullopt;
    }
    if (part > kMostRatio * packed.size() + kSmall) return std::nullopt;
    whole += part;
    left.remove_prefix(size);
  }
  if (whole > kMostRatio * packed.size() + kSmall) return std::nullopt;
  Bytes bytes(whole, '\0');
  const std::size_t got = ZSTD_decompress(bytes.data(), bytes.size(), packed.data(), packed.size());
  if (ZSTD_isError(got) || got != whole) return std::nullopt;
  return bytes;
}

}  // namespace coppice::robot::slam
