#include "robot_app/slam/map/map_folder.h"

#include <filesystem>
#include <system_error>
#include <utility>

#include "robot_app/slam/map/slam_map_file.h"

namespace coppice::robot::slam {
namespace {

constexpr char kStore[] = "memory.db";

Expected<std::unique_ptr<MapStore>> StoreIn(const std::string& folder) {
  if (folder.empty()) return MapStore::Open("");
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  return MapStore::Open((std::filesystem::path(folder) / kStore).string());
}

}  // namespace

Expected<OpenedMap> OpenMapFolder(const std::string& folder) {
  auto store = StoreIn(folder);
  if (!store) return Problem{store.problem()};
  OpenedMap opened;
  opened.store = *std::move(store);
  opened.version = NewestVersion(folder);
  auto kept = opened.store->Load();
  if (!kept || opened.version == 0 || opened.store->version() == opened.version) {
    if (!kept) return Problem{kept.problem()};
    opened.map = *std::move(kept);
    return opened;
  }
  auto loaded = LoadSlamMap(folder);
  if (!loaded) return Problem{loaded.problem()};
  const Outcome cleared = opened.store->Clear();
  if (!cleared) return Problem{cleared.problem()};
  opened.map = std::move(loaded->map);
  opened.remark = loaded->remark;
  return opened;
}

}  // namespace coppice::robot::slam
