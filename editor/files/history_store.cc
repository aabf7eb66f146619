#include "editor/files/history_store.h"

#include <algorithm>
#include <filesystem>
#include <map>
#include <random>
#include <system_error>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr char kPrefix[] = "history-";

std::string AbsolutePath(const std::string& path) {
  std::error_code error;
  return fs::absolute(path, error).lexically_normal().string();
}

std::string NewName() {
  std::random_device random;
  return kPrefix + std::to_string((std::uint64_t{random()} << 32U) | random());
}

std::vector<fs::path> NewestFirst(const std::string& folder) {
  std::vector<std::pair<fs::file_time_type, fs::path>> files;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().filename().string().rfind(kPrefix, 0) != 0) continue;
    files.emplace_back(entry.last_write_time(error), entry.path());
  }
  std::sort(files.rbegin(), files.rend());
  std::vector<fs::path> paths;
  for (auto& [time, path] : files) paths.push_back(std::move(path));
  return paths;
}

// Which steps can be taken over: walks away from where the texts are known. Behind a step that
// cannot be taken, the other files of that step are not known any more.
class Selection {
 public:
  /// By stored path: the path under which the file is open.
  explicit Selection(std::map<std::string, std::string> files) : files_(std::move(files)) {}

  bool Takes(Step& step) {
    const auto is_known = [this](const FileStep& file) { return files_.count(file.path) > 0; };
    if (std::all_of(step.files.begin(), step.files.end(), is_known)) {
      Rename(step);
      return true;
    }
    for (const FileStep& file : step.files) files_.erase(file.path);
    return false;
  }

 private:
  void Rename(Step& step) const {
    for (FileStep& file : step.files) file.path = files_.at(file.path);
    for (auto* places : {&step.selected_before, &step.selected_after}) {
      for (FilePlace& place : *places) {
        const auto known = files_.find(place.path);
        if (known != files_.end()) place.path = known->second;
      }
    }
  }

  std::map<std::string, std::string> files_;
};

std::vector<Step> UndoSteps(const StoredHistory& stored, Selection selection) {
  std::vector<Step> steps;
  for (std::size_t i = stored.done; i-- > 0;) {
    Step step = stored.steps[i];
    if (selection.Takes(step)) steps.push_back(std::move(step));
  }
  std::reverse(steps.begin(), steps.end());
  return steps;
}

std::vector<Step> RedoSteps(const StoredHistory& stored, Selection selection) {
  std::vector<Step> steps;
  for (std::size_t i = stored.done; i < stored.steps.size(); ++i) {
    Step step = stored.steps[i];
    if (selection.Takes(step)) steps.push_back(std::move(step));
  }
  return steps;
}

}  // namespace

HistoryStore::HistoryStore(std::string folder, std::size_t limit)
    : folder_(std::move(folder)), limit_(limit), path_(folder_ + "/" + NewName()) {}

void HistoryStore::Update(const OpenProject& project) {
  const History& history = project.history();
  if (folder_.empty() || history.steps().empty() || project.version() == written_version_) return;
  StoredHistory stored;
  stored.done = history.done();
  std::set<std::string> paths;
  for (const Step& step : history.steps()) {
    stored.steps.push_back({step.name, {}, step.selected_before, step.selected_after});
    for (const FileStep& file : step.files) {
      stored.steps.back().files.push_back(
          {AbsolutePath(file.path), file.forward, file.back, {}, {}});
      paths.insert(file.path);
    }
    for (FilePlace& place : stored.steps.back().selected_before)
      place.path = AbsolutePath(place.path);
    for (FilePlace& place : stored.steps.back().selected_after)
      place.path = AbsolutePath(place.path);
  }
  for (const std::string& path : paths) {
    const EditedFile* file = project.Find(path);
    if (file) stored.texts.push_back(DescribeText(AbsolutePath(path), file->text));
  }
  std::error_code error;
  fs::create_directories(folder_, error);
  Diagnostics ignored;  // the next time it may succeed
  if (!WriteFile(path_, WriteHistory(stored, limit_), ignored)) return;
  written_version_ = project.version();
  RemoveOld();
}

void HistoryStore::RemoveOld() const {
  const std::vector<fs::path> files = NewestFirst(folder_);
  std::error_code error;
  for (std::size_t i = kMostFiles; i < files.size(); ++i) fs::remove(files[i], error);
}

std::vector<StoredHistory> HistoryStore::ReadAll() const {
  std::vector<StoredHistory> all;
  if (folder_.empty()) return all;
  for (const fs::path& path : NewestFirst(folder_)) {
    const std::optional<std::string> bytes = ReadFile(path.string());
    if (!bytes) continue;
    if (auto stored = ReadHistory(*bytes)) all.push_back(*std::move(stored));
  }
  return all;
}

std::size_t HistoryStore::Restore(OpenProject& project) {
  std::map<std::string, const EditedFile*> opened;  // by absolute path
  for (const auto& [path, file] : project.files()) {
    if (!seen_.insert(path).second || file.is_new) continue;
    opened[AbsolutePath(path)] = &file;
  }
  if (opened.empty()) return 0;
  std::size_t count = 0;
  for (const StoredHistory& stored : ReadAll()) {
    std::map<std::string, std::string> files;
    for (const KnownText& text : stored.texts) {
      const auto file = opened.find(text.path);
      if (file == opened.end() || !IsText(text, file->second->text)) continue;
      files[text.path] = file->second->path;
      opened.erase(file);  // an older history knows it no better
    }
    if (files.empty()) continue;
    std::vector<Step> undo = UndoSteps(stored, Selection(files));
    std::vector<Step> redo = RedoSteps(stored, Selection(std::move(files)));
    count += undo.size() + redo.size();
    project.Remember(std::move(undo), std::move(redo));
  }
  return count;
}

bool HistoryStore::Resume(OpenProject& project, const std::string& path, const std::string& text) {
  const std::string full = AbsolutePath(path);
  for (const StoredHistory& stored : ReadAll()) {
    for (const KnownText& known : stored.texts) {
      if (known.path != full || !IsText(known, text)) continue;
      project.Resume(path, text);
      seen_.erase(project.Find(path)->path);
      return Restore(project) > 0;
    }
  }
  return false;
}

}  // namespace coppice::editor
