#include "bt_core/model/include_path.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <sstream>
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

std::vector<fs::path> FoldersOf(const char* variable) {
  std::vector<fs::path> folders;
  const char* value = std::getenv(variable);
  std::istringstream list(value ? value : "");
  for (std::string folder; std::getline(list, folder, ':');) {
    if (!folder.empty()) folders.emplace_back(folder);
  }
  return folders;
}

// The <name> that the package.xml gives, or empty.
std::string PackageName(const fs::path& manifest) {
  Diagnostics ignored;  // a broken manifest is not this program's matter
  const auto document = Document::FromFile(manifest.string(), ignored);
  if (!document) return {};
  for (ElementIndex i = document->element(kRootElement).first_child; i != kNoElement;
       i = document->element(i).next_sibling) {
    if (document->element(i).tag == "name") return document->TextOf(document->element(i));
  }
  return {};
}

bool IsSkipped(const fs::path& folder) {
  std::error_code error;
  return folder.filename().string().substr(0, 1) == "." ||
         fs::exists(folder / "CATKIN_IGNORE", error) || fs::exists(folder / "AMENT_IGNORE", error);
}

// Below `root`, breadth first, so that the nearest match is found. Links are not followed: they can
// form circles.
std::string Search(const fs::path& root, const std::string& package) {
  std::vector<fs::path> folders = {root};
  for (std::size_t i = 0; i < folders.size(); ++i) {
    const fs::path folder = folders[i];
    std::error_code error;
    if (fs::is_regular_file(folder / "package.xml", error)) {
      if (PackageName(folder / "package.xml") == package) return folder.string();
      continue;
    }
    for (fs::directory_iterator entry(folder, error), end; !error && entry != end;
         entry.increment(error)) {
      std::error_code ignored;
      const bool is_folder = entry->is_directory(ignored) && !entry->is_symlink(ignored);
      if (is_folder && !IsSkipped(entry->path())) folders.push_back(entry->path());
    }
  }
  return {};
}

// The name goes to a shell.
bool IsPackageName(const std::string& package) {
  return !package.empty() && package[0] != '-' &&
         std::all_of(package.begin(), package.end(),
                     [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; });
}

std::string AskRospack(const std::string& package) {
  const std::string command =
      "command -v rospack >/dev/null && rospack find " + package + " 2>/dev/null";
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> pipe(popen(command.c_str(), "r"), &pclose);
  std::string folder;
  std::array<char, 4096> line{};
  if (pipe && std::fgets(line.data(), static_cast<int>(line.size()), pipe.get())) {
    folder = line.data();
  }
  while (!folder.empty() && folder.back() == '\n') folder.pop_back();
  return folder;
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

std::string FindRosPackage(const std::string& package) {
  if (!IsPackageName(package)) return {};
  for (const fs::path& folder : FoldersOf("ROS_PACKAGE_PATH")) {
    std::string found = Search(folder, package);
    if (!found.empty()) return found;
  }
  for (const fs::path& prefix : FoldersOf("AMENT_PREFIX_PATH")) {
    const fs::path folder = prefix / "share" / package;
    std::error_code error;
    if (fs::is_regular_file(folder / "package.xml", error)) return folder.string();
  }
  return AskRospack(package);
}

}  // namespace coppice
