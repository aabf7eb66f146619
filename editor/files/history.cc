#include "editor/files/history.h"

#include <iterator>
#include <utility>

namespace coppice::editor {
namespace {

constexpr std::size_t kKeptDocuments = 16;  // on each side of what is shown

}  // namespace

void History::Add(Step step) {
  steps_.resize(done_);
  steps_.push_back(std::move(step));
  ++done_;
  if (done_ > kKeptDocuments) ForgetDocuments(done_ - kKeptDocuments - 1);
}

void History::Prepend(std::vector<Step> undo, std::vector<Step> redo) {
  if (steps_.empty()) steps_ = std::move(redo);
  done_ += undo.size();
  steps_.insert(steps_.begin(), std::make_move_iterator(undo.begin()),
                std::make_move_iterator(undo.end()));
}

void History::Keep(std::size_t step, std::size_t file, std::optional<Document> before,
                   std::optional<Document> after) {
  FileStep& kept = steps_[step].files[file];
  if (before) kept.before = std::move(before);
  if (after) kept.after = std::move(after);
}

const Step* History::TakeUndo() {
  if (done_ == 0) return nullptr;
  if (done_ + kKeptDocuments < steps_.size()) ForgetDocuments(done_ + kKeptDocuments);
  return &steps_[--done_];
}

const Step* History::TakeRedo() {
  if (done_ == steps_.size()) return nullptr;
  if (done_ >= kKeptDocuments) ForgetDocuments(done_ - kKeptDocuments);
  return &steps_[done_++];
}

void History::Rename(const std::string& path, const std::string& new_path) {
  const auto rename = [&](std::string& name) {
    if (name == path) name = new_path;
  };
  for (Step& step : steps_) {
    for (FileStep& file : step.files) {
      rename(file.path);
      file.before.reset();  // it speaks of the old name
      file.after.reset();
    }
    for (FilePlace& place : step.selected_before) rename(place.path);
    for (FilePlace& place : step.selected_after) rename(place.path);
  }
}

void History::ForgetDocuments(std::size_t step) {
  for (FileStep& file : steps_[step].files) {
    file.before.reset();
    file.after.reset();
  }
}

}  // namespace coppice::editor
