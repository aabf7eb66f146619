#include "bt_core/model/include_path.h"

#include <filesystem>
#include <vector>

namespace coppice {
namespace {

namespace fs = std::filesystem;

std::string NearestFile(const fs::path& missing) {
  const fs::path folder = missing.has_parent_path() ? missing.parent_path() : fs::path(".");
  std::error_code error;
  if (!fs::is_directory(folder, error)) return "there is no folder " + folder.string();
  std::vector<std::string> names;  // without .xml, which makes all of them alike
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
       entry.increment(error)) {
    if (entry->path().extension() == ".xml") names.push_back(entry->path().stem().string());
  }
  const std::string nearest = NearestName(missing.stem().string(), names);
  return nearest.empty() ? nearest : "did you mean \"" + nearest + ".xml\"?";
}

}  // namespace

std::string IncludePath(const Document& document, const Element& include,
                        const PackageFinder& find_package, Diagnostics& diagnostics) {
  const Attribute* path = document.FindAttribute(include, "path");
  if (!path || path->value.empty()) {
    diagnostics.Error(document.Location(include.offset), "<include> without path");
    return {};
  }
  fs::path file(path->value);
  fs::path folder = fs::path(document.file()).parent_path();
  if (const Attribute* package = document.FindAttribute(include, "ros_pkg")) {
    const std::string name(package->value);
    folder = find_package(name);
    if (folder.empty()) {
      diagnostics.Error(document.Location(package->value_offset),
                        "ROS package \"" + name + "\" was not found",
                        "looked in ROS_PACKAGE_PATH and AMENT_PREFIX_PATH, and asked rospack");
      return {};
    }
    if (file.is_absolute()) {
      diagnostics.Warning(document.Location(package->name_offset),
                          "ros_pkg has no effect: the path is absolute");
    }
  }
  file = (folder / file).lexically_normal();  // of an absolute path, the folder is left out
  std::error_code error;
  if (fs::is_regular_file(file, error)) return file.string();
  diagnostics.Error(document.Location(path->value_offset),
                    "included file " + file.string() + " does not exist", NearestFile(file));
  return {};
}

}  // namespace coppice
