#include "editor/document/history.h"

#include <utility>

namespace coppice::editor {
namespace {

constexpr std::size_t kKeptDocuments = 16;  // of the last steps

}  // namespace

void History::Add(Step step) {
  steps_.resize(done_);
  steps_.push_back(std::move(step));
  ++done_;
  ForgetDocuments();
}

const Step* History::TakeUndo() {
  if (done_ == 0) return nullptr;
  return &steps_[--done_];
}

const Step* History::TakeRedo() {
  if (done_ == steps_.size()) return nullptr;
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
    for (Place& place : step.selected_before) rename(place.path);
    for (Place& place : step.selected_after) rename(place.path);
  }
}

void History::ForgetDocuments() {
  if (steps_.size() <= kKeptDocuments) return;
  for (FileStep& file : steps_[steps_.size() - kKeptDocuments - 1].files) {
    file.before.reset();
    file.after.reset();
  }
}

}  // namespace coppice::editor
