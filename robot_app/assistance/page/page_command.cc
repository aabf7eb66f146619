#include "robot_app/assistance/page/page_command.h"

#include <cmath>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "bt_core/base/json_library.h"

namespace coppice::robot::assistance {
namespace {

using Kind = PageCommand::Kind;
using nlohmann::json;

constexpr double kMostNumber = 1e6;
constexpr std::uint64_t kMostMilliseconds = 4'000'000'000'000;  // since 1970: in the year 2096
constexpr std::size_t kMostNames = 8;

const std::map<std::string, Kind> kKinds = {{"cameras", Kind::kCameras},  {"take", Kind::kTake},
                                            {"leave", Kind::kLeave},      {"drive", Kind::kDrive},
                                            {"set_pose", Kind::kSetPose}, {"answer", Kind::kAnswer},
                                            {"restart", Kind::kRestart}};

double Number(const json& object, const char* key) {
  if (!object.at(key).is_number()) throw std::invalid_argument(key);
  const double number = object.at(key);
  if (!std::isfinite(number) || std::abs(number) > kMostNumber) throw std::out_of_range(key);
  return number;
}

std::uint64_t Count(const json& object, const char* key) {
  if (!object.at(key).is_number_unsigned()) throw std::invalid_argument(key);
  return object.at(key);
}

Time Milliseconds(const json& object, const char* key) {
  const std::uint64_t count = Count(object, key);
  if (count > kMostMilliseconds) throw std::out_of_range(key);
  return Time(std::chrono::milliseconds(count));
}

bool Flag(const json& object, const char* key) { return object.at(key).get<bool>(); }

PageCommand Read(const json& object) {
  PageCommand command;
  command.kind = kKinds.at(object.at("do").get<std::string>());
  switch (command.kind) {
    case Kind::kCameras:
      command.names = object.at("names").get<std::vector<std::string>>();
      if (command.names.size() > kMostNames) throw std::out_of_range("names");
      break;
    case Kind::kTake:
      command.take_over = Flag(object, "over");
      break;
    case Kind::kLeave:
      break;
    case Kind::kDrive:
      command.velocity = {Number(object, "linear"), Number(object, "angular")};
      command.beat = Milliseconds(object, "beat");
      break;
    case Kind::kSetPose:
      command.pose = {Number(object, "x"), Number(object, "y"), Number(object, "yaw")};
      break;
    case Kind::kAnswer:
      command.request = static_cast<std::uint32_t>(Count(object, "request"));
      command.fixed = Flag(object, "fixed");
      break;
    case Kind::kRestart:
      command.name = object.at("name").get<std::string>();
      break;
  }
  return command;
}

}  // namespace

std::optional<PageCommand> ReadPageCommand(std::string_view text) {
  try {
    return Read(ParseLimitedJson(text));
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace coppice::robot::assistance
