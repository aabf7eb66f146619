#include "bt_core/engine/compile/sibling_files.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>
#include <system_error>
#include <vector>

#include "bt_core/model/document.h"

namespace coppice {
namespace {

constexpr std::size_t kMostFiles = 1000;
constexpr std::uintmax_t kBiggestFile = std::uintmax_t{4} << 20;
constexpr std::uintmax_t kMostBytes = std::uintmax_t{16} << 20;

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
  std::size_t count = 0;
  std::uintmax_t bytes = 0;
  while (count < std::min(files.size(), kMostFiles)) {
    bytes += std::filesystem::file_size(files[count], error);
    if (error || bytes > kMostBytes) break;
    ++count;
  }
  files.resize(count);
  return files;
}

// Files without a tree cost no more than being read.
void AddTrees(const std::filesystem::path& file,
              std::map<std::string, std::string, std::less<>>& all) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  if (text.str().find("BehaviorTree") == std::string::npos) return;
  Diagnostics ignored;
  const std::optional<Document> document = Document::FromText(text.str(), file.string(), ignored);
  if (!document) return;
  for (const Element& element : document->elements()) {
    if (element.tag != "BehaviorTree") continue;
    all.emplace(document->AttributeValue(element, "ID"), file.filename().string());
  }
}

}  // namespace

std::string SiblingFiles::FindTree(const std::string& file, std::string_view tree_id) {
  std::error_code error;
  if (!std::filesystem::is_regular_file(file, error)) return {};
  const std::filesystem::path folder = std::filesystem::absolute(file, error).parent_path();
  const auto [at, is_new] = folders_.try_emplace(folder.string());
  if (is_new) {
    for (const std::filesystem::path& other : XmlFiles(folder)) AddTrees(other, at->second);
  }
  const auto found = at->second.find(tree_id);
  return found == at->second.end() ? std::string() : found->second;
}

}  // namespace coppice
