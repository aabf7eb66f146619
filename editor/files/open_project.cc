// Everything that can be undone passes through here, and a change of several files is one step. So
// a change is worked out completely on copies of the texts first: a file that is not open or a text
// that would be malformed refuses all of it, and nothing has to be taken back.
#include "editor/files/open_project.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "bt_core/base/read_file.h"
#include "bt_core/model/write_file.h"
#include "editor/files/merge.h"

namespace coppice::editor {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kSmallText = 64 * 1024;  // read in a millisecond

// What a file looks like from outside: enough to see that somebody wrote it.
void NoteStamp(EditedFile& file) {
  std::error_code error;
  file.time = fs::last_write_time(file.path, error);
  file.size = fs::file_size(file.path, error);
}

bool IsGone(const std::string& path) {
  std::error_code error;
  return !fs::exists(path, error) && !error;
}

bool HasOldStamp(const EditedFile& file) {
  std::error_code error;
  const auto time = fs::last_write_time(file.path, error);
  if (error) return true;  // it is gone: the text in memory is all there is
  return time == file.time && fs::file_size(file.path, error) == file.size;
}

std::vector<Edit> Backwards(const std::vector<Edit>& steps, std::string& text) {
  std::vector<Edit> back;
  for (const Edit& step : steps) {
    back.push_back(Inverse(step, text));
    text = Apply(step, text);
  }
  std::reverse(back.begin(), back.end());
  return back;
}

}  // namespace

const EditedFile* OpenProject::Find(const std::string& path) const {
  const auto found = files_.find(path);
  if (found != files_.end()) return &found->second;
  for (const auto& [known, file] : files_) {
    std::error_code error;
    if (!file.is_new && fs::equivalent(known, path, error)) return &file;
  }
  return nullptr;
}

EditedFile* OpenProject::Get(const std::string& path) {
  return const_cast<EditedFile*>(std::as_const(*this).Find(path));
}

const EditedFile* OpenProject::Open(const std::string& path, Diagnostics& diagnostics) {
  if (const EditedFile* known = Find(path)) return known;
  std::optional<std::string> text = ReadFile(path, diagnostics);
  if (!text) return nullptr;
  EditedFile& file = files_[path];
  file.path = path;
  Know(file, *text);
  NoteStamp(file);
  Replace(file, *std::move(text), std::nullopt);
  return &file;
}

const EditedFile& OpenProject::Create(const std::string& path, std::string text) {
  EditedFile& file = files_[path];
  file.path = path;
  file.is_new = true;
  Replace(file, std::move(text), std::nullopt);
  return file;
}

// What is on the disk.
void OpenProject::Know(EditedFile& file, std::string saved) {
  file.saved = std::move(saved);
  ++file.saved_version;
}

// A document that was read before does not tell what is warned of in its text. Reading that again
// is spared a large one that had nothing of the kind.
void OpenProject::Replace(EditedFile& file, std::string text, std::optional<Document> document) {
  const bool may_have_problems = !file.problems.all().empty() || text.size() < kSmallText;
  file.problems = {};
  file.text = std::move(text);
  file.document = std::move(document);
  if (!file.document) {
    file.document = Document::FromText(file.text, file.path, file.problems);
  } else if (may_have_problems) {
    Document::FromText(file.text, file.path, file.problems);
  }
  ++file.version;
  ++version_;
}

bool OpenProject::Do(NamedChange change, std::vector<FilePlace> selected,
                     Diagnostics& diagnostics) {
  if (change.is_empty()) return true;
  Step step;
  std::vector<std::string> texts;
  for (FileChange& part : change.files) {
    const EditedFile* file = Find(part.path);
    if (!file) {
      diagnostics.Error({part.path, 0, 0}, "this file is not open");
      return false;
    }
    std::string text = file->text;
    FileStep done;
    done.path = file->path;
    done.back = Backwards(part.steps, text);
    done.forward = std::move(part.steps);
    done.before = file->document;
    if (!part.after) part.after = Document::FromText(text, file->path, diagnostics);
    if (!part.after) return false;
    done.after = std::move(part.after);
    for (const std::uint32_t offset : part.selected) {
      step.selected_after.push_back({file->path, offset});
    }
    step.files.push_back(std::move(done));
    texts.push_back(std::move(text));
  }
  for (std::size_t i = 0; i < texts.size(); ++i) {
    Replace(*Get(step.files[i].path), std::move(texts[i]), step.files[i].after);
  }
  step.name = std::move(change.name);
  step.selected_before = std::move(selected);
  history_.Add(std::move(step));
  return true;
}

const Step* OpenProject::LastOf(const std::string& path, const std::string& name) const {
  const Step* last = history_.undo();
  const bool fits = last && !history_.redo() && last->name == name && last->files.size() == 1 &&
                    last->files[0].path == path;
  return fits ? last : nullptr;
}

void OpenProject::SetText(const std::string& path, std::string name, std::string text, bool join) {
  EditedFile* file = Get(path);
  if (!file || file->text == text) return;
  Step step;
  FileStep part;
  part.path = file->path;
  std::string before = file->text;
  part.before = file->document;
  if (const Step* last = join ? LastOf(file->path, name) : nullptr) {
    for (const Edit& edit : last->files[0].back) before = Apply(edit, before);
    part.before = last->files[0].before;
    history_.DropLast();
  }
  part.forward = {Difference(before, text)};
  part.back = {Inverse(part.forward[0], before)};
  Replace(*file, std::move(text), std::nullopt);
  if (before == file->text) return;  // typed and taken back
  part.after = file->document;
  step.name = std::move(name);
  step.files.push_back(std::move(part));
  history_.Add(std::move(step));
}

// A document that had to be parsed is kept: the step may be taken back.
void OpenProject::Run(std::size_t number, bool forward) {
  const Step& step = history_.steps()[number];
  for (std::size_t i = 0; i < step.files.size(); ++i) {
    const FileStep& part = step.files[i];
    EditedFile* file = Get(part.path);
    if (!file) continue;
    std::optional<Document> left = file->document;
    std::string text = std::move(file->text);
    for (const Edit& edit : forward ? part.forward : part.back) text = Apply(edit, text);
    Replace(*file, std::move(text), forward ? part.after : part.before);
    history_.Keep(number, i, forward ? std::move(left) : file->document,
                  forward ? file->document : std::move(left));
  }
}

const Step* OpenProject::Undo() {
  const Step* step = history_.TakeUndo();
  if (step) Run(history_.done(), false);
  return step;
}

const Step* OpenProject::Redo() {
  const Step* step = history_.TakeRedo();
  if (step) Run(history_.done() - 1, true);
  return step;
}

bool OpenProject::ReadAhead() {
  bool parsed = history_.undo() && ReadAhead(history_.done() - 1, false);
  if (history_.redo()) parsed = ReadAhead(history_.done(), true) || parsed;
  return parsed;
}

bool OpenProject::ReadAhead(std::size_t number, bool forward) {
  const Step& step = history_.steps()[number];
  bool parsed = false;
  for (std::size_t i = 0; i < step.files.size(); ++i) {
    const FileStep& part = step.files[i];
    const EditedFile* file = Find(part.path);
    if (!file || (forward ? part.after : part.before)) continue;
    std::string text = file->text;
    for (const Edit& edit : forward ? part.forward : part.back) text = Apply(edit, text);
    Diagnostics ignored;
    std::optional<Document> document = Document::FromText(std::move(text), file->path, ignored);
    parsed = parsed || document;
    if (forward) {
      history_.Keep(number, i, std::nullopt, std::move(document));
    } else {
      history_.Keep(number, i, std::move(document), std::nullopt);
    }
  }
  return parsed;
}

void OpenProject::Remember(std::vector<Step> undo, std::vector<Step> redo) {
  history_.Prepend(std::move(undo), std::move(redo));
}

void OpenProject::Resume(const std::string& path, std::string text) {
  if (EditedFile* file = Get(path)) Replace(*file, std::move(text), std::nullopt);
}

bool OpenProject::Save(const std::string& path, Diagnostics& diagnostics, bool overwrite) {
  EditedFile* file = Get(path);
  if (!file) return false;
  if (!file->is_dirty()) return true;
  if (!overwrite && !file->is_new && !HasOldStamp(*file)) {
    const std::optional<std::string> there = ReadFile(file->path);
    if (there && *there != file->saved) file->other = there;
  }
  if (!overwrite && file->other) {
    diagnostics.Error({file->path, 0, 0}, "somebody else has changed this file",
                      "take theirs, or save over it");
    return false;
  }
  if (file->is_gone) {  // perhaps with its folder
    std::error_code error;
    fs::create_directories(fs::absolute(file->path, error).parent_path(), error);
  }
  if (!WriteFile(file->path, file->text, diagnostics)) return false;
  Know(*file, file->text);
  file->other.reset();
  file->is_new = file->is_gone = false;
  NoteStamp(*file);
  return true;
}

bool OpenProject::SaveAs(const std::string& path, const std::string& new_path,
                         Diagnostics& diagnostics) {
  EditedFile* file = Get(path);
  if (!file) return false;
  if (file->path == new_path) return Save(path, diagnostics, true);
  if (Find(new_path)) {
    diagnostics.Error({new_path, 0, 0}, "this file is open already");
    return false;
  }
  if (!WriteFile(new_path, file->text, diagnostics)) return false;
  history_.Rename(file->path, new_path);
  auto node = files_.extract(file->path);
  node.key() = new_path;
  EditedFile& moved = files_.insert(std::move(node)).position->second;
  moved.path = new_path;
  Know(moved, moved.text);
  moved.is_new = moved.is_gone = false;
  moved.other.reset();
  NoteStamp(moved);
  Replace(moved, std::string(moved.text), std::nullopt);
  return true;
}

std::vector<std::string> OpenProject::LookAtDisk() {
  std::vector<std::string> changed;
  for (auto& [path, file] : files_) {
    if (file.is_new) continue;
    const bool is_gone = IsGone(path);
    if (is_gone && !file.is_gone) changed.push_back(path);
    file.is_gone = is_gone;
    if (HasOldStamp(file)) continue;
    std::optional<std::string> text = ReadFile(path);
    NoteStamp(file);
    if (!text) continue;
    if (*text == file.saved) {
      file.other.reset();  // they took it back
      continue;
    }
    changed.push_back(path);
    if (*text == file.text) {
      Know(file, *std::move(text));
      file.other.reset();
    } else if (file.is_dirty()) {
      file.other = std::move(text);
      if (MergeTexts(file.saved, file.text, *file.other).conflicts.empty()) MergeTheirs(path);
    } else {
      Know(file, *text);
      SetText(path, "Changed on the disk", *std::move(text));
    }
  }
  return changed;
}

void OpenProject::TakeTheirs(const std::string& path) {
  EditedFile* file = Get(path);
  if (!file || !file->other) return;
  Know(*file, *std::exchange(file->other, std::nullopt));
  SetText(path, "Take what is on the disk", std::string(file->saved));
}

int OpenProject::MergeTheirs(const std::string& path, const std::vector<bool>& theirs) {
  EditedFile* file = Get(path);
  if (!file || !file->other) return 0;
  MergedText merged = MergeTexts(file->saved, file->text, *file->other);
  Edit taken;
  for (std::size_t i = 0; i < std::min(theirs.size(), merged.conflicts.size()); ++i) {
    const MergeConflict& conflict = merged.conflicts[i];
    const std::size_t end = conflict.offset + conflict.mine.size();
    if (theirs[i]) taken.push_back(Replacement(conflict.offset, end, conflict.theirs));
  }
  merged.text = Apply(taken, merged.text);
  Diagnostics problems;
  if (!Document::FromText(merged.text, file->path, problems)) return -1;
  Know(*file, *std::exchange(file->other, std::nullopt));
  SetText(path, "Merge with what is on the disk", std::move(merged.text));
  return static_cast<int>(merged.conflicts.size());
}

void OpenProject::KeepMine(const std::string& path) {
  EditedFile* file = Get(path);
  if (!file || !file->other) return;
  Know(*file, *std::exchange(file->other, std::nullopt));
}

}  // namespace coppice::editor
