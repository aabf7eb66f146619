#include "robot_app/common/shipped.h"

#include <cstring>
#include <filesystem>
#include <system_error>

namespace coppice::robot {
namespace {

namespace fs = std::filesystem;

bool IsIn(const std::string& folder, const std::string& path) {
  return path == folder || path.rfind(folder + "/", 0) == 0;
}

}  // namespace

std::string ShippedWith(const std::string& programs, const std::string& built) {
  const fs::path installed = fs::path(programs).parent_path() / "share/coppice/robot";
  std::error_code error;
  if (!fs::is_directory(installed, error)) return built;
  const std::string path = fs::path(built).lexically_normal().string();
  for (const char* folder : {COPPICE_BUILD_FOLDER, COPPICE_SOURCE_FOLDER}) {
    if (IsIn(folder, path)) return installed.string() + path.substr(std::strlen(folder));
  }
  return built;
}

std::string Shipped(const std::string& built) {
  std::error_code error;
  const fs::path program = fs::read_symlink("/proc/self/exe", error);
  return ShippedWith(program.parent_path().string(), built);
}

}  // namespace coppice::robot
