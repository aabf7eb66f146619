#include "bt_core/engine/compile/sibling_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "bt_core/model/document.h"

namespace coppice {
namespace {

constexpr std::size_t kMostFiles = 1000;
constexpr std::uintmax_t kBiggestFile = std::uintmax_t{4} << 20;

// In alphabetical order, so that the answer is always the same.
std::vector<std::filesystem::path> XmlFiles(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  std::error_code error;
  for (std::filesystem::directory_iterator at(folder, error), end; !error && at != end;
       at.increment(error)) {
    std::error_code ignored;
    if (at->path().extension() == ".xml" && at->is_regular_file(ignored) &&
        at->file_size(ignored) <= kBiggestFile) {
      files.push_back(at->path());
    }
  }
  std::sort(files.begin(), files.end());
  if (files.size() > kMostFiles) files.resize(kMostFiles);
  return files;
}

bool Defines(const std::filesystem::path& file, std::string_view tree_id) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  if (text.str().find(tree_id) == std::string::npos) return false;
  Diagnostics ignored;
  const std::optional<Document> document = Document::FromText(text.str(), file.string(), ignored);
  if (!document) return false;
  const std::vector<Element>& all = document->elements();
  return std::any_of(all.begin(), all.end(), [&](const Element& element) {
    return element.tag == "BehaviorTree" && document->AttributeValue(element, "ID") == tree_id;
  });
}

}  // namespace

std::string FindTreeInFolder(const std::string& file, std::string_view tree_id) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
  for (const std::filesystem::path& other : XmlFiles(folder)) {
    if (Defines(other, tree_id)) return other.filename().string();
  }
  return {};
}

}  // namespace coppice
