#include "tests/fuzz/robot_file_seeds.h"

#include <cstdint>
#include <memory>

#include "robot_app/slam/map/slam_map_file.h"
#include "robot_app/speech/sound/wav_file.h"

namespace coppice::fuzz {
namespace {

template <class Number>
void Append(Number number, std::string& out) {
  out.append(reinterpret_cast<const char*>(&number), sizeof(number));
}

robot::slam::KeyFrame SomeKeyFrame() {
  robot::slam::KeyFrame key_frame;
  key_frame.range = 8;
  for (int i = 0; i < 5; ++i) key_frame.points.emplace_back(1.0F, 0.5F * static_cast<float>(i), 1);
  key_frame.camera_clouds.push_back({{0.3F, 0, 1}, key_frame.points});
  auto picture = std::make_shared<robot::slam::PictureFeatures>();
  for (int i = 0; i < 2; ++i) {
    picture->pixels.emplace_back(10.0F, 20.0F);
    picture->descriptors.push_back({1, 2, 3, 4});
    picture->points.emplace_back(1.0F, 2.0F, 3.0F);
  }
  key_frame.pictures.push_back(picture);
  return key_frame;
}

}  // namespace

std::string SomeMap() {
  robot::slam::SlamMap map;
  map.names = {{"morning", 1}, {"noon", 2}};
  for (std::uint32_t i = 0; i < 3; ++i) {
    map.key_frames.push_back(std::make_shared<robot::slam::KeyFrame>(SomeKeyFrame()));
    map.graph.poses.push_back(robot::slam::Pose3::Identity());
    map.sessions.push_back(i / 2);
  }
  robot::slam::Link link;
  link.to = 1;
  map.graph.links.push_back(link);
  return robot::slam::BytesOf(map);
}

std::string SomeMessage() {
  const std::string line = "\n" + std::string(80, '=') + "\n";
  std::string bytes = "Header header\nfloat64[2] two\nN[] more\nstring[0] none\nuint8[] bytes" +
                      line + "MSG: std_msgs/Header\nuint32 seq\ntime stamp\nstring frame_id" +
                      line + "MSG: a/N\nstring name\nbool is_there\nO[3] o" + line + "MSG: a/O\n";
  bytes += '\0';
  for (const std::uint32_t number : {1U, 2U, 3U, 1U}) Append(number, bytes);
  bytes += 'f';
  Append(1.5, bytes);
  Append(-2e300, bytes);
  Append(2U, bytes);
  for (int i = 0; i < 2; ++i) {
    Append(3U, bytes);
    bytes += "\"a\xc3";
    bytes += '\1';
  }
  Append(2U, bytes);
  return bytes + "xy";
}

std::string SomeWav() {
  robot::speech::Sound sound{8000, {}};
  for (int i = 0; i < 60; ++i) sound.samples.push_back(static_cast<std::int16_t>(i * 100));
  return robot::speech::WavOf(sound);
}

// IMA ADPCM, two channels: blocks of 36 bytes for 25 samples of each.
std::string SomePackedWav() {
  constexpr std::uint16_t kBlock = 40, kSamples = 33;
  std::string format;
  for (const std::uint16_t number : {std::uint16_t{0x11}, std::uint16_t{2}}) Append(number, format);
  Append(std::uint32_t{8000}, format);
  Append(std::uint32_t{8000 * kBlock / kSamples}, format);
  for (const std::uint16_t number : {kBlock, std::uint16_t{4}, std::uint16_t{2}, kSamples}) {
    Append(number, format);
  }
  std::string chunks = "WAVEfmt ";
  Append(static_cast<std::uint32_t>(format.size()), chunks);
  chunks += format + "fact";
  for (const std::uint32_t number : {4U, 3U * kSamples}) Append(number, chunks);
  chunks += "data";
  Append(std::uint32_t{3 * kBlock}, chunks);
  for (int i = 0; i < 3; ++i) chunks += std::string(8, '\0') + std::string(kBlock - 8, '\x17');
  std::string bytes = "RIFF";
  Append(static_cast<std::uint32_t>(chunks.size()), bytes);
  return bytes + chunks;
}

}  // namespace coppice::fuzz
