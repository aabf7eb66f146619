#include "editor/settings/project_settings.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <utility>

#include "editor/settings/settings_json.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostFiles = 50;  // read anew when the project is opened
constexpr std::size_t kMostTrees = 500;

fs::path Absolute(const std::string& path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal();
}

// Neither absolute nor leading upwards.
bool IsBelow(const fs::path& path) {
  return !path.empty() && path.is_relative() && *path.begin() != ".." && *path.begin() != "." &&
         path == path.lexically_normal();
}

// The texts of a list; at most so many.
std::vector<std::string> TextsOf(const JsonValue& json, const char* name, std::size_t most,
                                 SettingsReader& reader) {
  std::vector<std::string> texts;
  const JsonValue* const list = json.Find(name);
  if (list && !list->is(JsonValue::Kind::kArray)) reader.Wrong(*list, "a list");
  for (const JsonValue& one : PartOf(json, name).children) {
    if (one.is(JsonValue::Kind::kString) && texts.size() < most) texts.push_back(one.text);
  }
  return texts;
}

JsonValue ListOf(const char* name, const std::vector<std::string>& texts) {
  JsonValue list = MakeJson(JsonValue::Kind::kArray, name);
  for (const std::string& text : texts) list.children.push_back(MakeText("", text));
  return list;
}

}  // namespace

std::string PathInProject(const std::string& folder, const std::string& file) {
  const fs::path path = Absolute(file).lexically_relative(folder);
  return IsBelow(path) ? path.string() : std::string();
}

ProjectSettings ReadProject(const std::string& text, const std::string& file,
                            Diagnostics& diagnostics) {
  ProjectSettings settings;
  const std::optional<JsonValue> json = ParseJson(text, file, diagnostics);
  if (!json) return settings;
  SettingsReader reader(diagnostics);
  reader.Take(*json, "folder", settings.folder);
  reader.Take(*json, "layout", settings.style);
  reader.Take(*json, "tiles", settings.tiles);
  settings.files = TextsOf(*json, "files", kMostFiles, reader);
  const auto leads_out = [&](const std::string& path) {
    if (IsBelow(path)) return false;
    diagnostics.Error(json->where, "\"" + path + "\" is not a file of the project");
    return true;
  };
  settings.files.erase(std::remove_if(settings.files.begin(), settings.files.end(), leads_out),
                       settings.files.end());
  for (const JsonValue& one : PartOf(*json, "trees").children) {
    if (settings.trees.size() == kMostTrees) break;
    ProjectTree tree;
    reader.Take(one, "file", tree.file);
    reader.Take(one, "tree", tree.tree);
    reader.Take(one, "tab", tree.has_tab);
    tree.closed = TextsOf(one, "closed", text.size(), reader);
    if (!leads_out(tree.file)) settings.trees.push_back(std::move(tree));
  }
  return settings;
}

std::string WriteProject(const ProjectSettings& settings) {
  JsonValue trees = MakeJson(JsonValue::Kind::kArray, "trees");
  for (const ProjectTree& tree : settings.trees) {
    JsonValue json = MakeJson(JsonValue::Kind::kObject, "");
    json.children = {MakeText("file", tree.file), MakeText("tree", tree.tree),
                     MakeJson("tab", tree.has_tab), ListOf("closed", tree.closed)};
    trees.children.push_back(std::move(json));
    if (trees.children.size() == kMostTrees) break;
  }
  std::vector<std::string> files = settings.files;
  if (files.size() > kMostFiles) files.resize(kMostFiles);
  JsonValue json = MakeJson(JsonValue::Kind::kObject, "");
  json.children = {MakeText("folder", settings.folder), MakeJson("layout", settings.style),
                   MakeJson("tiles", settings.tiles), ListOf("files", files), std::move(trees)};
  return PrintJson(json) + "\n";
}

}  // namespace coppice::editor
