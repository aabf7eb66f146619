#include "editor/workspace/file_keeper.h"

#include <algorithm>
#include <filesystem>
#include <system_error>
#include <utility>

#include "editor/keys/age_text.h"
#include "editor/workspace/file_dialog.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

std::string NameOf(const std::string& path) { return path.substr(path.rfind('/') + 1); }

std::string ReasonOf(const Diagnostics& diagnostics) {
  if (diagnostics.all().empty()) return "this file is not open";
  const Diagnostic& last = diagnostics.all().back();
  if (last.about.kind == ProblemKind::kCannotWrite) return last.hint;
  return last.hint.empty() ? last.message : last.message + ": " + last.hint;
}

bool IsThere(const std::string& path) {
  std::error_code error;
  return fs::exists(path, error);
}

std::string Listed(const std::vector<std::string>& paths) {
  std::string text;
  for (const std::string& path : paths) text += (text.empty() ? "" : ", ") + NameOf(path);
  return text;
}

}  // namespace

void FileKeeper::Save(bool overwrite, const std::function<void()>& then) {
  OpenProject& project = state_.workspace.project();
  const OpenFile* const shown = state_.workspace.file();
  std::string nameless;
  std::string refused;
  int saved = 0;
  for (const auto& [path, file] : project.files()) {
    if (!file.is_dirty()) continue;
    if (file.is_new) {
      const bool is_wanted = file.has_unsaved_work() || (shown && shown->path == path);
      if (is_wanted && nameless.empty()) nameless = path;
      continue;
    }
    Diagnostics diagnostics;
    if (project.Save(path, diagnostics, overwrite)) {
      state_.unsaveable.erase(path);
      ++saved;
    } else {
      refused = NameOf(path) + ": " + (state_.unsaveable[path] = ReasonOf(diagnostics));
    }
  }
  state_.work.Keep(project);  // the copies of what is saved go at once
  if (!refused.empty()) return state_.Notify(refused, now_, true);
  if (!nameless.empty()) return AskPath(nameless, then);
  state_.Notify(saved == 0   ? "Everything is already saved"
                : saved == 1 ? "Saved"
                             : "Saved " + std::to_string(saved) + " files",
                now_);
  if (then) then();
}

void FileKeeper::AskPath() {
  if (const OpenFile* file = state_.workspace.file()) AskPath(std::string(file->path), {});
}

void FileKeeper::AskPath(const std::string& path, const std::function<void()>& then) {
  state_.workspace.Open(path, now_);  // shows of which file it is asked
  state_.replaces.clear();
  OpenSaveDialog(state_, "Save " + NameOf(path) + " under a name", path,
                 [&s = state_, path, then](const std::string& typed) {
                   FileKeeper keeper(s, s.now);
                   Outcome saved = keeper.SaveAs(path, typed);
                   if (saved && then) keeper.Save(false, then);
                   return saved;
                 });
}

Outcome FileKeeper::SaveAs(const std::string& path, const std::string& new_path) {
  Workspace& workspace = state_.workspace;
  const EditedFile* const file = workspace.project().Find(path);
  if (!file) return Problem{"this file is not open"};
  if (new_path.empty()) return Problem{"a file needs a name"};
  const bool is_other =
      file->is_new || UnsavedWork::AbsolutePath(new_path) != UnsavedWork::AbsolutePath(path);
  if (is_other) {
    if (Outcome may = MayReplace(state_, new_path); !may) return may;
  }
  Diagnostics diagnostics;
  if (!workspace.project().SaveAs(path, new_path, diagnostics))
    return Problem{ReasonOf(diagnostics)};
  state_.unsaveable.erase(path);
  workspace.Rename(path, new_path);
  workspace.Refresh(now_);
  state_.work.Keep(workspace.project());
  state_.Notify("Saved " + new_path, now_);
  return {};
}

std::vector<std::string> FileKeeper::Unsaved() const {
  std::vector<std::string> paths;
  for (const auto& [path, file] : state_.workspace.project().files()) {
    if (file.has_unsaved_work()) paths.push_back(path);
  }
  return paths;
}

void FileKeeper::Quit() {
  const std::vector<std::string> unsaved = Unsaved();
  if (unsaved.empty()) {
    state_.quit = true;
    return;
  }
  Choice save;
  save.title = "Save and quit";
  save.run = [&s = state_] {
    FileKeeper(s, s.now).Save(false, [&s] { FileKeeper(s, s.now).Quit(); });
  };
  Choice discard;
  discard.title = "Quit without saving";
  discard.note = "unsaved changes are lost";
  discard.run = [&s = state_] {
    s.work.DropOwn();
    s.quit = true;
  };
  Choice stay;
  stay.title = "Go on editing";
  stay.note = "Esc";
  stay.run = [] {};
  const std::string is_not = unsaved.size() == 1 ? " is not saved" : " are not saved";
  state_.Offer(
      {Listed(unsaved) + is_not,
       [rows = std::vector<Choice>{save, discard, stay}](const std::string&) { return rows; },
       false});
}

const UnsavedCopy* FileKeeper::Offered() const {
  for (const UnsavedCopy& copy : state_.work.left()) {
    if (!OpenPathOf(copy).empty()) return &copy;
  }
  return nullptr;
}

const UnsavedCopy* FileKeeper::Elsewhere() const {
  for (const UnsavedCopy& copy : state_.work.elsewhere()) {
    if (!copy.is_new && !OpenPathOf(copy).empty()) return &copy;
  }
  return nullptr;
}

// Under which path the file is open, or empty. A name that was never on the disk is no file.
std::string FileKeeper::OpenPathOf(const UnsavedCopy& copy) const {
  if (copy.is_new) return {};
  for (const auto& [path, file] : state_.workspace.project().files()) {
    if (!file.is_new && UnsavedWork::AbsolutePath(path) == copy.path) return path;
  }
  return {};
}

std::string FileKeeper::FreePath(const std::string& wanted) const {
  const fs::path path(wanted);
  std::string free = wanted;
  for (int i = 2; state_.workspace.project().Find(free) || IsThere(free); ++i) {
    free = (path.parent_path() / (path.stem().string() + "-" + std::to_string(i))).string() +
           path.extension().string();
  }
  return free;
}

void FileKeeper::OfferAll() {
  state_.Offer(
      {"Unsaved work of earlier sessions: Enter opens it", [&s = state_](const std::string& typed) {
         std::vector<Choice> rows;
         for (const UnsavedCopy& copy : s.work.left()) {
           if (copy.path.find(typed) == std::string::npos) continue;
           Choice row;
           row.kind = copy.is_new ? "new" : "";
           row.title = copy.path;
           row.note = AgeOf(copy);
           row.run = [&s, copy] { FileKeeper(s, s.now).Restore(copy); };
           rows.push_back(std::move(row));
         }
         return rows;
       }});
}

// The copy goes when the text is in a copy of this editor.
void FileKeeper::Restore(UnsavedCopy copy) {
  const std::optional<std::string> text = UnsavedWork::TextOf(copy);
  if (!text) return state_.Notify("the copy cannot be read any more", now_, true);
  OpenProject& project = state_.workspace.project();
  std::string path = OpenPathOf(copy);
  if (path.empty()) {
    path = copy.is_new || !IsThere(copy.path) ? FreePath(copy.path) : copy.path;
    if (path == copy.path && IsThere(path)) {
      state_.services.open_file(path);
    } else {
      state_.workspace.Create(path, now_);
    }
  }
  const EditedFile* const file = project.Find(path);
  if (!file) return state_.Notify(path + " cannot be opened", now_, true);
  const bool is_touched = file->has_unsaved_work();  // before the user answered
  if (is_touched || !state_.services.resume(path, *text)) {
    project.SetText(path, "Restore unsaved work", *text);
  }
  state_.workspace.Refresh(now_);
  state_.work.Keep(project);
  if (state_.work.trouble().empty()) Forget(copy);
  state_.Notify("Restored: Ctrl+S saves it", now_);
}

std::string AgeOf(const UnsavedCopy& copy) {
  const auto age = fs::file_time_type::clock::now() - copy.time;
  return AgeText(std::chrono::duration_cast<std::chrono::seconds>(age).count());
}

}  // namespace coppice::editor
